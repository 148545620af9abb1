// A log that no program can make too long.

#include "tools/bounded_log.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.h"
#include "tests/support/process.h"

namespace ccmorse::tools {
namespace {

using ccmorse::testing::TemporaryFolder;

// What is logged of `text`, added `piece` bytes at a time.
std::string Logged(const std::string& text, std::size_t most, std::size_t piece) {
  const TemporaryFolder folder;
  BoundedLog log(folder.path() + "/log", most);
  for (std::size_t at = 0; at < text.size(); at += piece) log.Add(text.substr(at, piece));
  log.Close();
  return ReadFile(log.path());
}

TEST(BoundedLog, KeepsTheFirstAndTheLastHalfHoweverItComes) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += std::to_string(i) + " ";
  for (const std::size_t piece : {1U, 7U, 50U, 99U, 100U, 101U, 10000U}) {
    for (const std::size_t length : {1U, 50U, 99U, 100U}) {
      EXPECT_EQ(Logged(text.substr(0, length), 100, piece), text.substr(0, length)) << piece;
    }
    for (const std::size_t length : {101U, 149U, 150U, 151U, 1000U, 3890U}) {
      const std::string whole = text.substr(0, length);
      EXPECT_EQ(Logged(whole, 100, piece), whole.substr(0, 50) + "\n[... " +
                                               std::to_string(length - 100) +
                                               " bytes left out ...]\n" + whole.substr(length - 50))
          << piece;
    }
  }
}

TEST(BoundedLog, TheFirstHalfIsThereBeforeTheEndAndNothingMakesNoFile) {
  const TemporaryFolder folder;
  BoundedLog log(folder.path() + "/log", 8);
  EXPECT_FALSE(std::filesystem::exists(log.path()));
  log.Add("123456");
  EXPECT_EQ(ReadFile(log.path()), "1234");
}

}  // namespace
}  // namespace ccmorse::tools
