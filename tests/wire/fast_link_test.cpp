// The fast link's frames: byte by byte as docs/protocols/fast-link.md says, however they are cut.

#include "wire/fast_link.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <limits>
#include <vector>

namespace ccmorse::wire {
namespace {

std::string Bytes(std::initializer_list<int> values) {
  std::string bytes;
  for (const int value : values) bytes += static_cast<char>(value);
  return bytes;
}

TEST(N05, TheFrameOfTheDocumentation) {
  std::string out;
  {
    FrameWriter frame(out, FrameType::kCommand);
    frame.Short(0);
    const double numbers[] = {0.5, -1.0};
    frame.Doubles(numbers, 2);
  }
  EXPECT_EQ(out, Bytes({18, 0, 0, 0,    2,    0, 0, 0, 0, 0, 0, 0,    0,
                        0,  0, 0, 0xE0, 0x3F, 0, 0, 0, 0, 0, 0, 0xF0, 0xBF}));
}

TEST(N05, FramesDoNotDependOnHowTheyAreCut) {
  EXPECT_TRUE(rc::check("cut anywhere, the frames are the same", [] {
    std::string stream;
    std::vector<std::pair<FrameType, std::string>> expected;
    const int count = *rc::gen::inRange(0, 8);
    for (int i = 0; i < count; ++i) {
      const auto type = static_cast<FrameType>(*rc::gen::inRange(1, 11));
      const auto payload = *rc::gen::arbitrary<std::string>();
      FrameWriter(stream, type).Bytes(payload);
      expected.emplace_back(type, payload);
    }
    FrameSplitter splitter(kMostClientFrame);
    std::vector<std::pair<FrameType, std::string>> frames;
    Frame frame;
    std::string_view rest = stream;
    while (!rest.empty()) {
      const auto piece = static_cast<std::size_t>(*rc::gen::inRange(1, 40));
      splitter.Append(rest.substr(0, piece));
      rest.remove_prefix(std::min(piece, rest.size()));
      while (splitter.Next(&frame) == FrameSplitter::Result::kFrame) {
        frames.emplace_back(frame.type, frame.payload);
      }
    }
    RC_ASSERT(frames == expected);
    RC_ASSERT(splitter.buffered() == 0U);
  }));
}

TEST(N05, WhatIsNoFrameIsSaidAtOnce) {
  Frame frame;
  for (const std::string& header :
       {Bytes({0, 0, 0, 0, 0, 0, 0, 0}), Bytes({0, 0, 0, 0, 11, 0, 0, 0}),
        Bytes({0, 0, 0, 0, 1, 1, 0, 0}), Bytes({0, 0, 0, 0, 1, 0, 0, 1}),
        Bytes({101, 0, 0, 0, 1, 0, 0, 0}), std::string("1 simulation list_robots\n")}) {
    FrameSplitter splitter(100);
    splitter.Append(header);
    EXPECT_EQ(splitter.Next(&frame), FrameSplitter::Result::kBroken) << header;
  }
}

TEST(N05, DoublesKeepEveryBit) {
  EXPECT_TRUE(rc::check("any 64 bits", [](std::uint64_t bits) {
    std::string out;
    {
      FrameWriter frame(out, FrameType::kData);
      frame.Double(std::bit_cast<double>(bits));
    }
    ByteReader reader(std::string_view(out).substr(kFrameHeader));
    RC_ASSERT(std::bit_cast<std::uint64_t>(reader.Double()) == bits);
    double copied = 0.0;
    CopyDoubles(out.data() + kFrameHeader, 1, &copied);
    RC_ASSERT(std::bit_cast<std::uint64_t>(copied) == bits);
  }));
}

TEST(N05, MessagesThatAreCutShortAreRefused) {
  CommandMessage command;
  EXPECT_FALSE(ParseCommand("", &command));
  EXPECT_FALSE(ParseCommand("a", &command));
  EXPECT_FALSE(ParseCommand("ab1234567", &command));
  EXPECT_TRUE(ParseCommand("ab", &command));
  EXPECT_FALSE(ParseCommand(std::string(2 + 8 * (kMostNumbers + 1), '\0'), &command));
  EXPECT_TRUE(ParseCommand(std::string(2 + 8 * kMostNumbers, '\0'), &command));
  DeclareMessage declare;
  EXPECT_FALSE(ParseDeclare(Bytes({1, 0, 5, 0, 'a', 'b'}), &declare));
  EXPECT_FALSE(ParseDeclare(Bytes({0, 0x10, 0, 0}), &declare));  // number 4096
  const std::string declaration = Bytes({1, 0, 1, 0, 'a', 'b'});
  ASSERT_TRUE(ParseDeclare(declaration, &declare));
  EXPECT_EQ(declare.component, "a");
  EXPECT_EQ(declare.service, "b");
  SubscribeMessage subscribe;
  EXPECT_FALSE(ParseSubscribe(Bytes({1, 0}), &subscribe));
  EXPECT_FALSE(ParseSubscribe(Bytes({1, 0, 4, 'x'}), &subscribe));  // no such form
  EXPECT_TRUE(ParseSubscribe(Bytes({1, 0, 255}), &subscribe));
  DataEntry entry;
  const std::string short_entry = Bytes({1, 0, 3, 9, 0, 0, 0, 1, 2, 3});
  ByteReader cut(short_entry);
  EXPECT_FALSE(NextDataEntry(cut, &entry));
  EXPECT_FALSE(cut.ok());
}

}  // namespace
}  // namespace ccmorse::wire
