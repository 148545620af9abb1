#pragma once

#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace ccmorse::wire {

/// What is no MCAP file, is damaged, or holds what our records never hold. what() says what is
/// wrong and at which byte.
class McapError : public Error {
 public:
  using Error::Error;
};

/// A topic of a file. `encoding` is that of its messages ("json").
struct McapChannel {
  std::uint16_t id = 0;
  std::string topic;
  std::string encoding;
  std::string schema;  ///< name of its messages' schema; "" for none
};

/// One message; `channel` lives as long as its reader, `data` until the next call.
struct McapMessage {
  const McapChannel* channel = nullptr;
  std::uint32_t sequence = 0;  ///< counts its channel's messages, from 0
  std::uint64_t log_time = 0;  ///< ns
  std::string_view data;
};

/// Writes an MCAP file (the public format specification, version 0) from front to back: messages
/// in uncompressed chunks with their indexes, then a summary with statistics, every checksum
/// filled in. Each chunk goes to the stream as soon as it is full, so what a killed program leaves
/// is readable up to its last whole chunk. Equal calls give equal bytes. Not thread safe.
class McapWriter {
 public:
  /// Writes the head of the file. `library` names the program that writes. The stream outlives the
  /// writer. Throws Error, as every method does, when the stream does not take the bytes.
  McapWriter(std::ostream& out, std::string_view library);

  /// A schema for channels to refer to: its id. `encoding` as the specification's registry names it
  /// ("jsonschema").
  std::uint16_t AddSchema(std::string_view name, std::string_view encoding, std::string_view data);
  /// A topic: its id. At most 65535 of either.
  std::uint16_t AddChannel(std::uint16_t schema, std::string_view topic, std::string_view encoding);

  /// Adds a message. `log_time` in ns, not less than that of the message before.
  void Write(std::uint16_t channel, std::uint64_t log_time, std::string_view data);

  /// Hands over what was added so far, as a chunk that can be read whatever happens next.
  void EndChunk();

  /// Ends the file; nothing can be added any more. A file without it counts as broken off.
  void Finish();

  std::uint64_t messages() const { return messages_; }  ///< written so far
  std::uint64_t bytes() const { return position_; }     ///< handed to the stream so far

 private:
  struct Channel {
    std::string record;  // as it stands in the file
    std::uint64_t messages = 0;
    std::vector<std::uint64_t> index;  // of the chunk: pairs of log time and offset
  };
  struct Chunk {  // as the summary lists it
    std::uint64_t first_time;
    std::uint64_t last_time;
    std::uint64_t offset;
    std::uint64_t length;                            // of the whole chunk record
    std::uint64_t index_length;                      // of the message indexes behind it
    std::uint64_t size;                              // of the records in it
    std::map<std::uint16_t, std::uint64_t> indexes;  // channel -> offset of its message index
  };

  void Put(std::string_view bytes);
  void PutSummary();

  std::ostream& out_;
  std::uint64_t position_ = 0;
  std::uint32_t crc_ = 0;  // of all bytes put since the start of the file or of the summary
  std::vector<std::string> schemas_;
  std::vector<Channel> channels_;  // channel k has the id k + 1
  std::vector<Chunk> chunks_;
  std::uint64_t messages_ = 0;
  std::uint64_t first_time_ = 0;
  std::uint64_t last_time_ = 0;
  std::string records_;  // of the chunk that is being filled
  bool chunk_has_messages_ = false;
  std::uint64_t chunk_first_time_ = 0;
};

/// Reads an MCAP file from front to back and trusts nothing: a chunk's messages are handed out only
/// when its checksum is right, and the checksums of the data and of the summary are compared when
/// they are reached, so that once Next() has returned false for a complete() file every byte of it
/// was checked. It is stricter than the specification: chunks must be uncompressed and checksums
/// present, as our writer's are. Not thread safe.
class McapReader {
 public:
  /// Reads the head. The stream must be seekable, outlives the reader and belongs to it alone.
  /// Throws McapError.
  explicit McapReader(std::istream& in);

  /// What the file's head says of the program that wrote it.
  const std::string& library() const { return library_; }

  /// The next message of the file; false at its end. Throws McapError for a damaged file.
  bool Next(McapMessage* message);

  /// At the end: whether the file was ended properly. A file that was not, because its writer was
  /// killed, has given the messages of its whole chunks.
  bool complete() const { return complete_; }

 private:
  enum class Part { kData, kSummary, kEnd };

  bool ReadRecord();  // into content_; false when the file breaks off
  bool BrokenOff();   // ends the reading, or throws when the file's end is there; returns false
  void ReadChunk();
  void ReadDataEnd();
  void ReadFooter();
  void ReadDefinition(std::uint8_t opcode, std::string_view content);
  void TakeMessage(std::string_view content, McapMessage* message) const;
  bool NextInChunk(McapMessage* message);
  [[noreturn]] void Fail(const std::string& what) const;

  std::istream& in_;
  std::uint64_t size_ = 0;      // of the file
  std::uint64_t position_ = 0;  // behind the record in content_
  std::uint64_t record_at_ = 0;
  bool ends_well_ = false;        // the file's last bytes are those that end every whole file
  std::uint32_t crc_ = 0;         // of the bytes read since the start of the file or of the summary
  std::uint32_t footer_crc_ = 0;  // crc_ before the checksum in the footer
  std::uint64_t summary_at_ = 0;
  Part part_ = Part::kData;
  bool complete_ = false;
  std::string library_;
  std::map<std::uint16_t, std::string> schemas_;  // id -> name
  std::map<std::uint16_t, McapChannel> channels_;
  std::uint8_t opcode_ = 0;
  std::string content_;     // of the record read last
  std::string_view chunk_;  // what is left of the chunk in content_
};

}  // namespace ccmorse::wire
