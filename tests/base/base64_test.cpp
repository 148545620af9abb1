#include "base/base64.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "base/error.h"

namespace ccmorse {
namespace {

TEST(Base64, TheStandardsOwnExamples) {
  const std::pair<const char*, const char*> examples[] = {{"", ""},
                                                          {"f", "Zg=="},
                                                          {"fo", "Zm8="},
                                                          {"foo", "Zm9v"},
                                                          {"foob", "Zm9vYg=="},
                                                          {"fooba", "Zm9vYmE="},
                                                          {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : examples) {
    EXPECT_EQ(ToBase64(bytes), text);
    EXPECT_EQ(FromBase64(text), bytes);
  }
}

TEST(Base64, AllBytesComeBack) {
  EXPECT_TRUE(rc::check("round trip", [](const std::string& bytes) {
    RC_ASSERT(FromBase64(ToBase64(bytes)) == bytes);
  }));
}

TEST(Base64, WhatItDoesNotWriteIsAnError) {
  for (const char* text :
       {"Z", "Zg", "Zg=", "Zg===", "====", "Zh==", "Zm9=", "Zm 9", "Zm9v\n", "Z=g="}) {
    EXPECT_THROW(FromBase64(text), Error) << text;
  }
}

}  // namespace
}  // namespace ccmorse
