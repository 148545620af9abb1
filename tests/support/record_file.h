#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ccmorse::testing {

/// One message of an MCAP file, with all that it needs to be written again.
struct RecordedMessage {
  std::string topic;
  std::string schema;
  std::uint64_t log_time = 0;  ///< ns
  std::string data;
};

/// All messages of a file. Throws wire::McapError.
std::vector<RecordedMessage> ReadMessages(const std::string& file);

/// Writes a whole file with right checksums.
void WriteMessages(const std::string& file, const std::vector<RecordedMessage>& messages);

/// A file's bytes, and a file of these bytes.
std::string ReadBytes(const std::string& file);
void WriteBytes(const std::string& file, const std::string& bytes);

}  // namespace ccmorse::testing
