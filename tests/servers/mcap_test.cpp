// The MCAP writer and reader; that others can read the files is tested with @mcap/core in
// tests/end_to_end/record_test.cpp.

#include "wire/mcap.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fstream>
#include <random>
#include <sstream>
#include <tuple>
#include <vector>

namespace ccmorse::wire {
namespace {

struct Line {
  std::string topic;
  std::string schema;
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;
  std::string data;
  bool operator==(const Line&) const = default;
};

struct Contents {
  std::vector<Line> lines;
  bool complete = false;
  std::string library;
};

Contents Read(const std::string& bytes) {
  std::istringstream stream(bytes);
  McapReader reader(stream);
  Contents contents;
  contents.library = reader.library();
  McapMessage message;
  while (reader.Next(&message)) {
    contents.lines.push_back({message.channel->topic, message.channel->schema, message.sequence,
                              message.log_time, std::string(message.data)});
  }
  contents.complete = reader.complete();
  return contents;
}

// A file of three chunks, the last with a topic of its own.
std::string SmallFile() {
  std::ostringstream stream;
  McapWriter writer(stream, "test 1");
  const std::uint16_t schema = writer.AddSchema("Thing", "jsonschema", "{\"type\": \"object\"}");
  const std::uint16_t one = writer.AddChannel(schema, "/one", "json");
  const std::uint16_t two = writer.AddChannel(0, "/two", "json");
  writer.Write(one, 0, "{\"a\": 1}");
  writer.Write(two, 5, "{}");
  writer.EndChunk();
  writer.Write(one, 7, "{\"a\": 2}");
  writer.Write(one, 7, "");
  writer.EndChunk();
  const std::uint16_t three = writer.AddChannel(schema, "/three", "json");
  writer.Write(three, 1'000'000'009, "{\"a\": 3}");
  writer.Finish();
  return stream.str();
}

TEST(Mcap, WhatIsWrittenIsRead) {
  const Contents contents = Read(SmallFile());
  const std::vector<Line> expected = {{"/one", "Thing", 0, 0, "{\"a\": 1}"},
                                      {"/two", "", 0, 5, "{}"},
                                      {"/one", "Thing", 1, 7, "{\"a\": 2}"},
                                      {"/one", "Thing", 2, 7, ""},
                                      {"/three", "Thing", 0, 1'000'000'009, "{\"a\": 3}"}};
  EXPECT_EQ(contents.lines, expected);
  EXPECT_TRUE(contents.complete);
  EXPECT_EQ(contents.library, "test 1");
}

TEST(Mcap, AnyMessagesAreReadAsTheyWereWritten) {
  rc::check(
      "round trip",
      [](const std::vector<std::tuple<std::uint8_t, std::uint32_t, std::string>>& script) {
        std::ostringstream stream;
        McapWriter writer(stream, "test");
        std::vector<std::uint16_t> channels;
        std::vector<std::uint32_t> counts;
        std::vector<Line> expected;
        std::uint64_t time = 0;
        for (const auto& [choice, step, data] : script) {
          const std::size_t topic = choice % 5;
          while (channels.size() <= topic) {
            channels.push_back(writer.AddChannel(0, "/" + std::to_string(channels.size()), "json"));
            counts.push_back(0);
          }
          time += step;  // up to 4 s, so that chunks end by themselves, too
          if (choice > 200) writer.EndChunk();
          writer.Write(channels[topic], time, data);
          expected.push_back({"/" + std::to_string(topic), "", counts[topic]++, time, data});
        }
        writer.Finish();
        RC_ASSERT(writer.bytes() == stream.str().size());
        const Contents contents = Read(stream.str());
        RC_ASSERT(contents.lines == expected);
        RC_ASSERT(contents.complete);
      });
}

TEST(Mcap, EveryChangedByteIsRefused) {
  const std::string good = SmallFile();
  const unsigned seed = std::random_device{}();
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const unsigned change : {1U, 0x80U, 0xFFU, 1U + static_cast<unsigned>(random() % 255)}) {
      std::string bad = good;
      bad[i] = static_cast<char>(static_cast<unsigned char>(bad[i]) ^ change);
      EXPECT_THROW(Read(bad), McapError)
          << "byte " << i << " of " << good.size() << " ^ " << change << ", seed " << seed;
    }
  }
}

TEST(Mcap, AFileThatBreaksOffGivesItsWholeChunks) {
  const std::string whole = SmallFile();
  const std::vector<Line> lines = Read(whole).lines;
  std::size_t most = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::string cut = whole.substr(0, size);
    if (size < 8) {
      EXPECT_THROW(Read(cut), McapError) << size;
      continue;
    }
    const Contents contents = Read(cut);
    EXPECT_FALSE(contents.complete) << size;
    ASSERT_LE(contents.lines.size(), lines.size());
    EXPECT_TRUE(std::equal(contents.lines.begin(), contents.lines.end(), lines.begin())) << size;
    EXPECT_GE(contents.lines.size(), most) << "more of the file, fewer messages";
    most = contents.lines.size();
  }
  EXPECT_EQ(most, lines.size());
}

TEST(Mcap, BytesBehindTheEndAreRefused) {
  EXPECT_THROW(Read(SmallFile() + "x"), McapError);
  EXPECT_THROW(Read(SmallFile() + SmallFile()), McapError);
}

TEST(Mcap, OtherFilesAreRefusedAndNamedForWhatTheyAre) {
  for (const std::string& bytes : {std::string(), std::string("{}"), std::string(1000, '\0')}) {
    try {
      Read(bytes);
      ADD_FAILURE() << bytes.size();
    } catch (const McapError& error) {
      EXPECT_NE(std::string(error.what()).find("no MCAP file"), std::string::npos);
    }
  }
}

TEST(Mcap, ALengthBeyondTheFileAllocatesNothing) {
  std::string bytes = SmallFile();
  // The header's length, with and without the file's proper end.
  for (int i = 0; i < 8; ++i) bytes[9 + static_cast<std::size_t>(i)] = '\xff';
  EXPECT_THROW(Read(bytes), McapError);
  bytes.pop_back();
  EXPECT_FALSE(Read(bytes).complete);
}

TEST(Mcap, AStreamThatTakesNothingIsAnError) {
  std::ofstream full("/dev/full", std::ios::binary);
  ASSERT_TRUE(full);
  EXPECT_THROW(
      {
        McapWriter writer(full, "test");
        const std::uint16_t channel = writer.AddChannel(0, "/a", "json");
        for (int i = 0; i < 100; ++i) {
          writer.Write(channel, 0, std::string(10'000, 'x'));
          writer.EndChunk();
        }
      },
      Error);
}

}  // namespace
}  // namespace ccmorse::wire
