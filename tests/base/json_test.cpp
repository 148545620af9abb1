#include "base/json.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

namespace ccmorse {
namespace {

// An independent writer and reader of JSON to compare with.
nlohmann::json ToReference(const Json& value) {
  if (value.IsNull()) return nullptr;
  if (value.IsBool()) return value.AsBool();
  if (value.IsInt()) return value.AsInt();
  if (value.IsNumber()) return value.AsDouble();
  if (value.IsString()) return value.AsString();
  if (value.IsArray()) {
    nlohmann::json list = nlohmann::json::array();
    for (const Json& item : value.AsArray()) list.push_back(ToReference(item));
    return list;
  }
  nlohmann::json object = nlohmann::json::object();
  for (const auto& [key, member] : value.AsObject()) object[key] = ToReference(member);
  return object;
}

Json RandomValue(int depth) {
  const int kind = *rc::gen::inRange(0, depth > 3 ? 5 : 7);
  switch (kind) {
    case 0:
      return Json(nullptr);
    case 1:
      return Json(*rc::gen::arbitrary<bool>());
    case 2:
      return Json(*rc::gen::arbitrary<std::int64_t>());
    case 3: {
      const double number = *rc::gen::arbitrary<double>();
      return Json(std::isfinite(number) ? number : 0.5);
    }
    case 4: {
      std::string text = *rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127));
      return Json(text + "\xC5\x99\xF0\x9F\xA4\x96");  // letters outside ASCII, one beyond the BMP
    }
    case 5: {
      Json::Array list;
      const int size = *rc::gen::inRange(0, 4);
      for (int i = 0; i < size; ++i) list.push_back(RandomValue(depth + 1));
      return Json(std::move(list));
    }
    default: {
      Json object(Json::Object{});
      const int size = *rc::gen::inRange(0, 4);
      for (int i = 0; i < size; ++i) object.Set("k" + std::to_string(i), RandomValue(depth + 1));
      return object;
    }
  }
}

TEST(Json, WhatWeWriteTheReferenceReadsAsTheSame) {
  EXPECT_TRUE(rc::check("dump against nlohmann", [] {
    const Json value = RandomValue(0);
    RC_ASSERT(nlohmann::json::parse(value.Dump()) == ToReference(value));
  }));
}

TEST(Json, WhatTheReferenceWritesWeReadAsTheSame) {
  EXPECT_TRUE(rc::check("parse against nlohmann", [] {
    const Json value = RandomValue(0);
    RC_ASSERT(ToReference(Json::Parse(ToReference(value).dump())) == ToReference(value));
  }));
}

TEST(Json, NumbersAreWrittenAsPythonWritesThem) {
  const std::pair<double, const char*> cases[] = {
      {0.0, "0.0"},
      {-0.0, "-0.0"},
      {1.0, "1.0"},
      {0.1, "0.1"},
      {1e15, "1000000000000000.0"},
      {1e16, "1e+16"},
      {1.5e16, "1.5e+16"},
      {1e-4, "0.0001"},
      {1e-5, "1e-05"},
      {123456.789, "123456.789"},
      {1e100, "1e+100"},
      {5e-324, "5e-324"},
      {-2.5, "-2.5"},
      {100.0, "100.0"},
      {1.7976931348623157e308, "1.7976931348623157e+308"}};
  for (const auto& [number, text] : cases) EXPECT_EQ(Json(number).Dump(), text);
  EXPECT_EQ(Json(std::nan("")).Dump(), "NaN");
  EXPECT_EQ(Json(-std::numeric_limits<double>::infinity()).Dump(), "-Infinity");
  EXPECT_EQ(Json(3).Dump(), "3");
}

TEST(Json, EveryDoubleSurvivesTheRoundTripBitForBit) {
  EXPECT_TRUE(rc::check("round trip", [](std::uint64_t bits) {
    double number;
    std::memcpy(&number, &bits, sizeof(number));
    RC_PRE(std::isfinite(number));
    const double back = Json::Parse(Json(number).Dump()).AsDouble();
    RC_ASSERT(std::memcmp(&back, &number, sizeof(back)) == 0);
  }));
}

TEST(Json, ReadsPythonsBareWords) {
  EXPECT_TRUE(std::isnan(Json::Parse("NaN").AsDouble()));
  EXPECT_EQ(Json::Parse("[Infinity, -Infinity]").AsArray()[1].AsDouble(),
            -std::numeric_limits<double>::infinity());
}

TEST(Json, ErrorsAreWordedAsPythonWordsThem) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "Expecting value: line 1 column 1 (char 0)"},
      {"[1,", "Expecting value: line 1 column 4 (char 3)"},
      {"[1 2]", "Expecting ',' delimiter: line 1 column 4 (char 3)"},
      {"{1: 2}", "Expecting property name enclosed in double quotes: line 1 column 2 (char 1)"},
      {"{\"a\" 2}", "Expecting ':' delimiter: line 1 column 6 (char 5)"},
      {"\"abc", "Unterminated string starting at: line 1 column 1 (char 0)"},
      {"1 2", "Extra data: line 1 column 3 (char 2)"},
      {"[\n 1,\n x]", "Expecting value: line 3 column 2 (char 7)"},
      // Characters, not bytes.
      {"[\"\xC3\xA9\xF0\x9F\x98\x80\",\n\"\xC5\xBE\" x]",
       "Expecting ',' delimiter: line 2 column 5 (char 11)"}};
  for (const auto& [text, message] : cases) {
    try {
      Json::Parse(text);
      ADD_FAILURE() << text << " was accepted";
    } catch (const JsonError& error) {
      EXPECT_STREQ(error.what(), message);
    }
  }
}

TEST(Json, DeepNestingIsRefusedAndNotFollowed) {
  EXPECT_THROW(Json::Parse(std::string(100000, '[')), JsonError);
  EXPECT_NO_THROW(Json::Parse(std::string(60, '[') + std::string(60, ']')));
}

TEST(Json, AnyBytesGiveAValueOrAnError) {
  EXPECT_TRUE(rc::check("no crash", [](const std::string& bytes) {
    try {
      Json::Parse(bytes).Dump();
    } catch (const JsonError&) {
    }
  }));
}

TEST(Json, ValuesKnowTheirLine) {
  const Json value = Json::Parse("{\n\"a\": 1,\n\"b\": [\n2]}");
  EXPECT_EQ(value.Find("a")->line(), 2);
  EXPECT_EQ(value.Find("b")->AsArray()[0].line(), 4);
}

TEST(Json, FalsyIsWhatPythonCallsFalsy) {
  for (const char* text : {"null", "false", "0", "0.0", "\"\"", "[]", "{}"}) {
    EXPECT_TRUE(Json::Parse(text).IsFalsy()) << text;
  }
  for (const char* text : {"true", "-1", "0.1", "\"a\"", "[0]", "{\"a\": 0}", "NaN"}) {
    EXPECT_FALSE(Json::Parse(text).IsFalsy()) << text;
  }
}

}  // namespace
}  // namespace ccmorse
