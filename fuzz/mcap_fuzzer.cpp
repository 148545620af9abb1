// McapReader, and McapWriter as its counterpart. The first byte of the input says what the rest is:
// 0: a file;
// 1: the records of a chunk, which is given the head and the checksum that make it count;
// else: a script. Each step is a byte for what to do, one for its size, and so many bytes of data;
//   what it writes must be read as it was written, and neither cut off nor with one changed byte
//   may it be read as anything else.
// What must hold for any bytes: they are read to their end or refused by McapError, and no message
// lies outside of the file.

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/check.h"
#include "wire/mcap.h"

namespace {

using ccmorse::fuzz::Require;
using ccmorse::wire::McapError;
using ccmorse::wire::McapMessage;
using ccmorse::wire::McapReader;
using ccmorse::wire::McapWriter;

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);

struct Message {
  std::string topic;
  std::uint64_t time = 0;
  std::string data;
  bool operator==(const Message&) const = default;
};

struct Contents {
  std::vector<Message> messages;
  bool complete = false;
  bool refused = false;
};

Contents Read(const std::string& bytes) {
  std::istringstream stream(bytes);
  Contents contents;
  std::size_t size = 0;
  try {
    McapReader reader(stream);
    McapMessage message;
    while (reader.Next(&message)) {
      size += message.data.size();
      Require(size <= bytes.size(), "messages lie in the file");
      contents.messages.push_back(
          {message.channel->topic, message.log_time, std::string(message.data)});
    }
    contents.complete = reader.complete();
    Require(!reader.Next(&message), "nothing follows the end");
  } catch (const McapError& error) {
    contents.refused = true;
    Require(*error.what() != '\0', "a refusal has a reason");
  }
  return contents;
}

void AppendInteger(std::string& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 0xFFU);
}

std::string WrapChunk(const std::string& records) {
  std::string file(kMagic);
  file += '\x01';  // a header with two empty texts
  AppendInteger(file, 8, 8);
  AppendInteger(file, 0, 8);
  file += '\x06';
  AppendInteger(file, 8 + 8 + 8 + 4 + 4 + 8 + records.size(), 8);
  AppendInteger(file, 0, 8);
  AppendInteger(file, 0, 8);
  AppendInteger(file, records.size(), 8);
  AppendInteger(file, crc32_z(0, reinterpret_cast<const Bytef*>(records.data()), records.size()),
                4);
  AppendInteger(file, 0, 4);
  AppendInteger(file, records.size(), 8);
  return file + records;
}

void RunScript(std::string_view script) {
  std::ostringstream stream;
  McapWriter writer(stream, "fuzz");
  std::vector<Message> written;
  std::vector<std::uint16_t> channels;
  std::uint64_t time = 0;
  std::uint8_t change = 1;
  std::size_t place = 0;
  while (script.size() >= 2) {
    const auto what = static_cast<std::uint8_t>(script[0]);
    const std::string_view data = script.substr(2, static_cast<std::uint8_t>(script[1]));
    script.remove_prefix(2 + data.size());
    place = place * 31 + what + data.size();
    if (what % 8 == 0) {
      writer.EndChunk();
    } else if (what % 8 == 1 || channels.empty()) {
      const std::uint16_t schema = what % 16 == 1 ? writer.AddSchema(data, "jsonschema", data) : 0;
      channels.push_back(writer.AddChannel(schema, "/" + std::to_string(channels.size()), "json"));
    } else {
      const std::size_t index = what / 8 % channels.size();
      time += what % 8 == 2 ? 700'000'000 : what;
      writer.Write(channels[index], time, data);
      written.push_back({"/" + std::to_string(index), time, std::string(data)});
      change = static_cast<std::uint8_t>(what | 1U);
    }
  }
  writer.Finish();
  const std::string file = stream.str();
  Require(writer.bytes() == file.size(), "the writer counts its bytes");
  const Contents whole = Read(file);
  Require(!whole.refused && whole.complete, "what was written is whole");
  Require(whole.messages == written, "what was written is read");

  const std::size_t at = place % file.size();
  std::string damaged = file;
  damaged[at] = static_cast<char>(static_cast<unsigned char>(damaged[at]) ^ change);
  Require(Read(damaged).refused, "a changed byte is refused");
  const Contents cut = Read(file.substr(0, at));
  // Cut behind data that look like a file's end, it cannot be told from a damaged one.
  const bool like_whole = at >= 16 && std::string_view(file).substr(at - 8, 8) == kMagic;
  Require(cut.refused == (at < 8 || like_whole) && !cut.complete,
          "what is cut off is neither damaged nor whole");
  Require(cut.messages.size() <= written.size() &&
              std::equal(cut.messages.begin(), cut.messages.end(), written.begin()),
          "what is cut off begins as the whole does");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string bytes(data + 1, data + size);
  if (data[0] == 0) {
    Read(bytes);
  } else if (data[0] == 1) {
    Require(!Read(WrapChunk(bytes)).complete, "a file without an end is not whole");
  } else {
    RunScript(bytes);
  }
  return 0;
}
