#include "wire/morse_line.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <vector>

namespace ccmorse::wire {
namespace {

using Kind = MorseRequest::Kind;

TEST(MorseLine, TokensAreSeparatedByAnyRunOfWhitespace) {
  const MorseRequest request = ParseMorseRequest(" \t id1  a.b\t c   [1, 2] \r");
  EXPECT_EQ(request.kind, Kind::kCall);
  EXPECT_EQ(request.id, "id1");
  EXPECT_EQ(request.component, "a.b");
  EXPECT_EQ(request.service, "c");
  EXPECT_EQ(request.parameters, "[1, 2]");
}

TEST(MorseLine, CancelAndTheMalformed) {
  EXPECT_EQ(ParseMorseRequest("7 cancel").kind, Kind::kCancel);
  EXPECT_EQ(ParseMorseRequest("7").kind, Kind::kMalformed);
  EXPECT_EQ(ParseMorseRequest("7").id, "7");
  EXPECT_EQ(ParseMorseRequest("7 simulation").kind, Kind::kMalformed);
  EXPECT_EQ(ParseMorseRequest("").id, "");
}

TEST(MorseLine, AnyBytesAreParsedWithoutHarm) {
  EXPECT_TRUE(rc::check("no crash", [](const std::string& bytes) {
    const MorseRequest request = ParseMorseRequest(bytes);
    RC_ASSERT(request.id.size() + request.component.size() + request.parameters.size() <=
              bytes.size());
  }));
}

TEST(LineSplitter, LinesDoNotDependOnHowTheBytesWereCut) {
  EXPECT_TRUE(rc::check("any cuts give the same lines", [] {
    const auto text = *rc::gen::container<std::string>(rc::gen::element('a', 'b', '\n', '\r'));
    std::vector<std::string> expected;
    std::string line;
    for (const char c : text) {
      if (c == '\n') {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        expected.push_back(line);
        line.clear();
      } else {
        line += c;
      }
    }
    LineSplitter splitter(1000);
    std::vector<std::string> got;
    std::size_t at = 0;
    while (at < text.size()) {
      const auto size = static_cast<std::size_t>(*rc::gen::inRange(1, 5));
      splitter.Append(std::string_view(text).substr(at, size));
      at += size;
      std::string_view next;
      while (splitter.Next(&next) == LineSplitter::Result::kLine) got.emplace_back(next);
    }
    RC_ASSERT(got == expected);
  }));
}

TEST(LineSplitter, ALongLineIsToldOfOnceAndTheNextOneIsWhole) {
  LineSplitter splitter(10);
  std::string_view line;
  splitter.Append(std::string(15, 'x'));
  EXPECT_EQ(splitter.Next(&line), LineSplitter::Result::kTooLong);
  EXPECT_EQ(splitter.Next(&line), LineSplitter::Result::kNeedMore);
  for (int i = 0; i < 1000; ++i) {
    splitter.Append(std::string(1000, 'x'));
    EXPECT_EQ(splitter.Next(&line), LineSplitter::Result::kNeedMore);
    EXPECT_LE(splitter.buffered(), 1000U);
  }
  splitter.Append("x\nnext\n");
  EXPECT_EQ(splitter.Next(&line), LineSplitter::Result::kLine);
  EXPECT_EQ(line, "next");
}

}  // namespace
}  // namespace ccmorse::wire
