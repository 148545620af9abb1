#include "wire/mcap.h"

#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <istream>
#include <ostream>

namespace ccmorse::wire {
namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
constexpr std::size_t kRecordHead = 1 + 8;           // opcode and length
constexpr std::size_t kFooterLength = 8 + 8 + 4;     // of its content
constexpr std::size_t kMessageHead = 2 + 4 + 8 + 8;  // what stands before a message's data
constexpr std::size_t kMostIds = 65535;
// A full chunk is this large, or this long in ns of log time: what a killed program loses at most.
constexpr std::size_t kChunkBytes = 1U << 20;
constexpr std::uint64_t kChunkTime = 1'000'000'000;

// The specification's opcodes.
constexpr std::uint8_t kHeader = 0x01;
constexpr std::uint8_t kFooter = 0x02;
constexpr std::uint8_t kSchema = 0x03;
constexpr std::uint8_t kChannel = 0x04;
constexpr std::uint8_t kMessage = 0x05;
constexpr std::uint8_t kChunk = 0x06;
constexpr std::uint8_t kMessageIndex = 0x07;
constexpr std::uint8_t kChunkIndex = 0x08;
constexpr std::uint8_t kStatistics = 0x0B;
constexpr std::uint8_t kSummaryOffset = 0x0E;
constexpr std::uint8_t kDataEnd = 0x0F;

std::uint32_t Crc(std::uint32_t before, std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

// Appends whole numbers as the format has them: little-endian, of the type's size.
template <typename Integer>
void AppendInteger(std::string& out, Integer value) {
  for (std::size_t i = 0; i < sizeof value; ++i) {
    out += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
  }
}

void AppendString(std::string& out, std::string_view text) {
  AppendInteger(out, static_cast<std::uint32_t>(text.size()));
  out += text;
}

void AppendRecord(std::string& out, std::uint8_t opcode, std::string_view content) {
  out += static_cast<char>(opcode);
  AppendInteger(out, std::uint64_t{content.size()});
  out += content;
}

// Takes the fields of a record one by one; nothing is read behind its end.
class Fields {
 public:
  explicit Fields(std::string_view bytes) : rest_(bytes) {}

  template <typename Integer>
  Integer Take() {
    const std::string_view bytes = Bytes(sizeof(Integer));
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
    }
    return static_cast<Integer>(value);
  }

  std::string_view Bytes(std::uint64_t count) {
    if (count > rest_.size()) {
      whole_ = false;
      rest_ = {};
      return {};
    }
    const std::string_view bytes = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return bytes;
  }

  std::string String() { return std::string(Bytes(Take<std::uint32_t>())); }

  std::string_view rest() const { return rest_; }
  // Were all fields there?
  bool whole() const { return whole_; }

 private:
  std::string_view rest_;
  bool whole_ = true;
};

}  // namespace

McapWriter::McapWriter(std::ostream& out, std::string_view library) : out_(out) {
  std::string head(kMagic);
  std::string content;
  AppendString(content, "");  // no profile: topics and schemas speak for themselves
  AppendString(content, library);
  AppendRecord(head, kHeader, content);
  Put(head);
  out_.flush();
}

void McapWriter::Put(std::string_view bytes) {
  errno = 0;
  if (!out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    throw Error(errno != 0 ? std::strerror(errno) : "it does not take what is written");
  }
  position_ += bytes.size();
  crc_ = Crc(crc_, bytes);
}

std::uint16_t McapWriter::AddSchema(std::string_view name, std::string_view encoding,
                                    std::string_view data) {
  if (schemas_.size() >= kMostIds) throw Error("too many schemas");
  const auto id = static_cast<std::uint16_t>(schemas_.size() + 1);  // 0 means no schema
  std::string content;
  AppendInteger(content, id);
  AppendString(content, name);
  AppendString(content, encoding);
  AppendString(content, data);
  std::string record;
  AppendRecord(record, kSchema, content);
  records_ += record;
  schemas_.push_back(std::move(record));
  return id;
}

std::uint16_t McapWriter::AddChannel(std::uint16_t schema, std::string_view topic,
                                     std::string_view encoding) {
  if (channels_.size() >= kMostIds) throw Error("too many topics");
  const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
  std::string content;
  AppendInteger(content, id);
  AppendInteger(content, schema);
  AppendString(content, topic);
  AppendString(content, encoding);
  AppendInteger(content, std::uint32_t{0});  // no metadata
  Channel channel;
  AppendRecord(channel.record, kChannel, content);
  records_ += channel.record;
  channels_.push_back(std::move(channel));
  return id;
}

void McapWriter::Write(std::uint16_t channel, std::uint64_t log_time, std::string_view data) {
  if (chunk_has_messages_ &&
      (records_.size() >= kChunkBytes || log_time - chunk_first_time_ >= kChunkTime)) {
    EndChunk();
  }
  Channel& topic = channels_.at(std::size_t{channel} - 1);
  if (messages_ == 0) first_time_ = log_time;
  if (!chunk_has_messages_) chunk_first_time_ = log_time;
  chunk_has_messages_ = true;
  last_time_ = log_time;
  topic.index.push_back(log_time);
  topic.index.push_back(records_.size());
  records_ += static_cast<char>(kMessage);
  AppendInteger(records_, std::uint64_t{kMessageHead + data.size()});
  AppendInteger(records_, channel);
  AppendInteger(records_, static_cast<std::uint32_t>(topic.messages));
  AppendInteger(records_, log_time);
  AppendInteger(records_, log_time);  // publish time: in a simulation the same
  records_ += data;
  ++topic.messages;
  ++messages_;
}

void McapWriter::EndChunk() {
  if (records_.empty()) return;
  Chunk chunk{chunk_first_time_, last_time_, position_, 0, 0, records_.size(), {}};
  if (!chunk_has_messages_) chunk.first_time = chunk.last_time = 0;
  std::string head;
  AppendInteger(head, chunk.first_time);
  AppendInteger(head, chunk.last_time);
  AppendInteger(head, std::uint64_t{records_.size()});
  AppendInteger(head, Crc(0, records_));
  AppendString(head, "");  // no compression
  AppendInteger(head, std::uint64_t{records_.size()});
  std::string record(1, static_cast<char>(kChunk));
  AppendInteger(record, std::uint64_t{head.size() + records_.size()});
  record += head;
  Put(record);
  Put(records_);
  chunk.length = position_ - chunk.offset;
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    std::vector<std::uint64_t>& index = channels_[k].index;
    if (index.empty()) continue;
    const auto id = static_cast<std::uint16_t>(k + 1);
    chunk.indexes[id] = position_;
    std::string content;
    AppendInteger(content, id);
    AppendInteger(content, static_cast<std::uint32_t>(8 * index.size()));
    for (const std::uint64_t word : index) AppendInteger(content, word);
    record.clear();
    AppendRecord(record, kMessageIndex, content);
    Put(record);
    index.clear();
  }
  chunk.index_length = position_ - chunk.offset - chunk.length;
  chunks_.push_back(std::move(chunk));
  records_.clear();
  chunk_has_messages_ = false;
  if (!out_.flush()) Put("");  // throws with the system's reason
}

void McapWriter::Finish() {
  EndChunk();
  std::string content;
  AppendInteger(content, crc_);
  std::string record;
  AppendRecord(record, kDataEnd, content);
  Put(record);
  PutSummary();
  Put(kMagic);
  if (!out_.flush()) Put("");
}

void McapWriter::PutSummary() {
  const std::uint64_t summary_at = position_;
  crc_ = 0;
  std::string offsets;
  const auto put_group = [&](std::uint8_t opcode, const std::string& group) {
    if (group.empty()) return;
    std::string content(1, static_cast<char>(opcode));
    AppendInteger(content, position_);
    AppendInteger(content, std::uint64_t{group.size()});
    AppendRecord(offsets, kSummaryOffset, content);
    Put(group);
  };

  std::string group;
  for (const std::string& schema : schemas_) group += schema;
  put_group(kSchema, group);
  group.clear();
  for (const Channel& channel : channels_) group += channel.record;
  put_group(kChannel, group);

  std::string content;
  AppendInteger(content, messages_);
  AppendInteger(content, static_cast<std::uint16_t>(schemas_.size()));
  AppendInteger(content, static_cast<std::uint32_t>(channels_.size()));
  AppendInteger(content, std::uint32_t{0});  // attachments
  AppendInteger(content, std::uint32_t{0});  // metadata
  AppendInteger(content, static_cast<std::uint32_t>(chunks_.size()));
  AppendInteger(content, first_time_);
  AppendInteger(content, last_time_);
  AppendInteger(content, static_cast<std::uint32_t>((2 + 8) * channels_.size()));
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    AppendInteger(content, static_cast<std::uint16_t>(k + 1));
    AppendInteger(content, channels_[k].messages);
  }
  group.clear();
  AppendRecord(group, kStatistics, content);
  put_group(kStatistics, group);

  group.clear();
  for (const Chunk& chunk : chunks_) {
    content.clear();
    AppendInteger(content, chunk.first_time);
    AppendInteger(content, chunk.last_time);
    AppendInteger(content, chunk.offset);
    AppendInteger(content, chunk.length);
    AppendInteger(content, static_cast<std::uint32_t>((2 + 8) * chunk.indexes.size()));
    for (const auto& [channel, offset] : chunk.indexes) {
      AppendInteger(content, channel);
      AppendInteger(content, offset);
    }
    AppendInteger(content, chunk.index_length);
    AppendString(content, "");  // no compression, so both sizes are the same
    AppendInteger(content, chunk.size);
    AppendInteger(content, chunk.size);
    AppendRecord(group, kChunkIndex, content);
  }
  put_group(kChunkIndex, group);

  const std::uint64_t offsets_at = position_;
  Put(offsets);
  std::string footer(1, static_cast<char>(kFooter));
  AppendInteger(footer, std::uint64_t{kFooterLength});
  AppendInteger(footer, summary_at);
  AppendInteger(footer, offsets_at);
  AppendInteger(footer, Crc(crc_, footer));
  Put(footer);
}

McapReader::McapReader(std::istream& in) : in_(in) {
  in_.seekg(0, std::ios::end);
  const auto end = in_.tellg();
  if (!in_ || end < 0) Fail("it cannot be read");
  size_ = static_cast<std::uint64_t>(end);
  std::string bytes(kMagic.size(), '\0');
  if (size_ >= 2 * kMagic.size()) {
    in_.seekg(-static_cast<std::streamoff>(kMagic.size()), std::ios::end);
    in_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    ends_well_ = bytes == kMagic;
  }
  in_.clear();
  in_.seekg(0);
  bytes.assign(kMagic.size(), '\0');
  in_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!in_ || bytes != kMagic) Fail("it is no MCAP file");
  position_ = bytes.size();
  crc_ = Crc(0, bytes);
  if (!ReadRecord()) {
    BrokenOff();
    return;
  }
  Fields fields(content_);
  fields.String();  // profile
  library_ = fields.String();
  if (opcode_ != kHeader || !fields.whole()) Fail("its header is damaged");
}

void McapReader::Fail(const std::string& what) const {
  throw McapError(what + " (at byte " + std::to_string(record_at_) + ")");
}

bool McapReader::BrokenOff() {
  if (ends_well_) Fail("a record of it is damaged: it ends behind the file's end");
  part_ = Part::kEnd;
  complete_ = false;
  return false;
}

bool McapReader::ReadRecord() {
  record_at_ = position_;
  if (size_ - position_ < kRecordHead) return false;
  std::string head(kRecordHead, '\0');
  if (!in_.read(head.data(), static_cast<std::streamsize>(head.size()))) Fail("it cannot be read");
  Fields fields(head);
  opcode_ = fields.Take<std::uint8_t>();
  const auto length = fields.Take<std::uint64_t>();
  if (length > size_ - position_ - kRecordHead) return false;
  content_.resize(length);
  if (!in_.read(content_.data(), static_cast<std::streamsize>(length))) Fail("it cannot be read");
  position_ += kRecordHead + length;
  // The two checksums in the file cover what stands before them.
  if (opcode_ == kDataEnd && part_ == Part::kData) return true;
  if (opcode_ == kFooter && length == kFooterLength) {
    footer_crc_ = Crc(Crc(crc_, head), std::string_view(content_).substr(0, kFooterLength - 4));
    return true;
  }
  crc_ = Crc(Crc(crc_, head), content_);
  return true;
}

bool McapReader::Next(McapMessage* message) {
  while (part_ != Part::kEnd) {
    if (!chunk_.empty()) {
      if (NextInChunk(message)) return true;
      continue;
    }
    if (!ReadRecord()) return BrokenOff();
    if (part_ == Part::kSummary) {
      switch (opcode_) {
        case kSchema:
        case kChannel:
        case kStatistics:
        case kChunkIndex:
        case kSummaryOffset:
          break;  // for those who look something up; its checksum stands in the footer
        case kFooter:
          ReadFooter();
          break;
        default:
          Fail("its summary is damaged");
      }
      continue;
    }
    switch (opcode_) {
      case kSchema:
      case kChannel:
        ReadDefinition(opcode_, content_);
        break;
      case kMessage:
        Fail("it has messages outside of chunks, which are not protected by a checksum");
      case kChunk:
        ReadChunk();
        break;
      case kMessageIndex:
        break;
      case kDataEnd:
        ReadDataEnd();
        break;
      default:
        Fail("a record of it is damaged or of a kind that is not known here");
    }
  }
  return false;
}

bool McapReader::NextInChunk(McapMessage* message) {
  Fields fields(chunk_);
  const auto opcode = fields.Take<std::uint8_t>();
  const std::string_view content = fields.Bytes(fields.Take<std::uint64_t>());
  if (!fields.whole()) Fail("a chunk of it holds a damaged record");
  chunk_ = fields.rest();
  switch (opcode) {
    case kSchema:
    case kChannel:
      ReadDefinition(opcode, content);
      return false;
    case kMessage:
      TakeMessage(content, message);
      return true;
    default:
      Fail("a chunk of it holds a record of a kind that is not known here");
  }
}

void McapReader::ReadChunk() {
  Fields fields(content_);
  fields.Bytes(8 + 8);  // the times of its messages, which they hold themselves
  const auto size = fields.Take<std::uint64_t>();
  const auto crc = fields.Take<std::uint32_t>();
  const std::string compression = fields.String();
  const std::string_view records = fields.Bytes(fields.Take<std::uint64_t>());
  if (!fields.whole() || !fields.rest().empty()) Fail("a chunk of it is damaged");
  if (!compression.empty()) {
    Fail("a chunk of it is compressed by '" + compression.substr(0, 20) +
         "', which is not known here, or damaged");
  }
  if (size != records.size() || crc != Crc(0, records)) {
    Fail("a chunk of it is damaged: its checksum is wrong");
  }
  chunk_ = records;
}

void McapReader::ReadDataEnd() {
  Fields fields(content_);
  const auto crc = fields.Take<std::uint32_t>();
  if (!fields.whole() || !fields.rest().empty() || crc != crc_) {
    Fail("its data are damaged: their checksum is wrong");
  }
  part_ = Part::kSummary;
  summary_at_ = position_;
  crc_ = 0;
}

void McapReader::ReadFooter() {
  Fields fields(content_);
  const auto summary_at = fields.Take<std::uint64_t>();
  fields.Bytes(8);  // where the summary's offsets are
  const auto crc = fields.Take<std::uint32_t>();
  if (!fields.whole() || !fields.rest().empty() || summary_at != summary_at_ ||
      crc != footer_crc_) {
    Fail("its summary is damaged: its checksum is wrong");
  }
  record_at_ = position_;
  std::string rest(size_ - position_ < 64 ? size_ - position_ : 64, '\0');
  if (!in_.read(rest.data(), static_cast<std::streamsize>(rest.size()))) Fail("it cannot be read");
  if (rest.size() < kMagic.size() && rest == kMagic.substr(0, rest.size())) {
    BrokenOff();
    return;
  }
  if (rest != kMagic) Fail("its last bytes are damaged");
  part_ = Part::kEnd;
  complete_ = true;
}

void McapReader::ReadDefinition(std::uint8_t opcode, std::string_view content) {
  Fields fields(content);
  const auto id = fields.Take<std::uint16_t>();
  if (opcode == kSchema) {
    schemas_[id] = fields.String();
    fields.String();                             // encoding
    fields.Bytes(fields.Take<std::uint32_t>());  // the schema itself
  } else {
    const auto schema = fields.Take<std::uint16_t>();
    McapChannel channel;
    channel.id = id;
    channel.topic = fields.String();
    channel.encoding = fields.String();
    fields.Bytes(fields.Take<std::uint32_t>());  // metadata
    const auto known = schemas_.find(schema);
    if (schema != 0 && known == schemas_.end()) Fail("a topic of it has an unknown schema");
    if (schema != 0) channel.schema = known->second;
    // A channel stays what it was: messages handed out refer to it.
    channels_.try_emplace(id, std::move(channel));
  }
  if (!fields.whole()) Fail("a schema or topic of it is damaged");
}

void McapReader::TakeMessage(std::string_view content, McapMessage* message) const {
  Fields fields(content);
  const auto channel = channels_.find(fields.Take<std::uint16_t>());
  message->sequence = fields.Take<std::uint32_t>();
  message->log_time = fields.Take<std::uint64_t>();
  fields.Bytes(8);  // publish time
  message->data = fields.rest();
  if (!fields.whole()) Fail("a message of it is damaged");
  if (channel == channels_.end()) Fail("a message of it has an unknown topic");
  message->channel = &channel->second;
}

}  // namespace ccmorse::wire
