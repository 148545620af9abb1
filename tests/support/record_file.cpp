#include "tests/support/record_file.h"

#include <fstream>
#include <iterator>
#include <map>

#include "wire/mcap.h"

namespace ccmorse::testing {

std::vector<RecordedMessage> ReadMessages(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  ccmorse::wire::McapReader reader(stream);
  std::vector<RecordedMessage> messages;
  ccmorse::wire::McapMessage message;
  while (reader.Next(&message)) {
    messages.push_back({message.channel->topic, message.channel->schema, message.log_time,
                        std::string(message.data)});
  }
  return messages;
}

void WriteMessages(const std::string& file, const std::vector<RecordedMessage>& messages) {
  std::ofstream stream(file, std::ios::binary);
  ccmorse::wire::McapWriter writer(stream, "a test");
  std::map<std::string, std::uint16_t> channels;
  for (const RecordedMessage& message : messages) {
    auto channel = channels.find(message.topic);
    if (channel == channels.end()) {
      const std::uint16_t schema = writer.AddSchema(message.schema, "jsonschema", "{}");
      channel =
          channels.emplace(message.topic, writer.AddChannel(schema, message.topic, "json")).first;
    }
    writer.Write(channel->second, message.log_time, message.data);
  }
  writer.Finish();
}

std::string ReadBytes(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void WriteBytes(const std::string& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace ccmorse::testing
