#include "base/error.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

namespace ccmorse {
namespace {

TEST(ReadFile, AnEmptyFileIsEmptyAndAFolderIsAnError) {
  const std::string path = ::testing::TempDir() + "ccmorse_empty_file";
  std::ofstream{path};
  EXPECT_EQ(ReadFile(path), "");
  std::remove(path.c_str());
  EXPECT_THROW(ReadFile(::testing::TempDir()), Error);
  EXPECT_THROW(ReadFile("/no/such/file"), Error);
}

}  // namespace
}  // namespace ccmorse
