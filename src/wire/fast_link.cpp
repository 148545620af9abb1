#include "wire/fast_link.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace ccmorse::wire {
namespace {

constexpr std::size_t kSmallestBuffer = std::size_t{64} << 10;

// The value that little-endian bytes hold, whatever the machine's own order is.
template <typename Word>
Word FromLittle(const char* bytes) {
  Word word = 0;
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(&word, bytes, sizeof word);
  } else {
    for (std::size_t i = sizeof word; i-- > 0;) {
      word = static_cast<Word>(word << 8U | static_cast<unsigned char>(bytes[i]));
    }
  }
  return word;
}

template <typename Word>
void ToLittle(Word word, char* bytes) {
  for (std::size_t i = 0; i < sizeof word; ++i) {
    bytes[i] = static_cast<char>(static_cast<unsigned char>(word >> (8U * i)));
  }
}

template <typename Word>
void AppendLittle(std::string& out, Word word) {
  char bytes[sizeof word];
  ToLittle(word, bytes);
  out.append(bytes, sizeof word);
}

}  // namespace

char* FrameSplitter::Space(std::size_t size) {
  if (begin_ == end_) begin_ = end_ = 0;
  if (end_ + size <= capacity_) return buffer_.get() + end_;
  const std::size_t held = buffered();
  if (held + size > capacity_) {
    capacity_ = std::max({kSmallestBuffer, held + size, 2 * capacity_});
    // Not make_unique, which would clear what is about to be overwritten.
    std::unique_ptr<char[]> larger(new char[capacity_]);
    if (held > 0) std::memcpy(larger.get(), buffer_.get() + begin_, held);
    buffer_ = std::move(larger);
  } else {
    std::memmove(buffer_.get(), buffer_.get() + begin_, held);
  }
  begin_ = 0;
  end_ = held;
  return buffer_.get() + end_;
}

void FrameSplitter::Append(std::string_view bytes) {
  if (bytes.empty()) return;
  std::memcpy(Space(bytes.size()), bytes.data(), bytes.size());
  Commit(bytes.size());
}

FrameSplitter::Result FrameSplitter::Next(Frame* frame) {
  if (buffered() < kFrameHeader) return Result::kNeedMore;
  const char* const header = buffer_.get() + begin_;
  const auto size = FromLittle<std::uint32_t>(header);
  const auto type = static_cast<unsigned char>(header[4]);
  if (size > longest_ || type < static_cast<unsigned char>(FrameType::kLines) ||
      type > static_cast<unsigned char>(FrameType::kRefused) || header[5] != 0 || header[6] != 0 ||
      header[7] != 0) {
    return Result::kBroken;
  }
  if (buffered() < kFrameHeader + size) return Result::kNeedMore;
  frame->type = static_cast<FrameType>(type);
  frame->payload = std::string_view(header + kFrameHeader, size);
  begin_ += kFrameHeader + size;
  return Result::kFrame;
}

FrameWriter::FrameWriter(std::string& out, FrameType type) : out_(out), start_(out.size()) {
  out_.append(4, '\0');
  out_ += static_cast<char>(type);
  out_.append(3, '\0');
}

FrameWriter::~FrameWriter() {
  ToLittle(static_cast<std::uint32_t>(out_.size() - start_ - kFrameHeader), out_.data() + start_);
}

void FrameWriter::Byte(std::uint8_t value) { out_ += static_cast<char>(value); }
void FrameWriter::Short(std::uint16_t value) { AppendLittle(out_, value); }
void FrameWriter::Long(std::uint32_t value) { AppendLittle(out_, value); }
void FrameWriter::Double(double value) { AppendLittle(out_, std::bit_cast<std::uint64_t>(value)); }

void FrameWriter::Doubles(const double* values, std::size_t count) {
  if constexpr (std::endian::native == std::endian::little) {
    out_.append(reinterpret_cast<const char*>(values), count * sizeof(double));
  } else {
    for (std::size_t i = 0; i < count; ++i) Double(values[i]);
  }
}

std::string_view ByteReader::Bytes(std::size_t size) {
  if (size > rest_.size()) {
    ok_ = false;
    rest_ = {};
    return {};
  }
  const std::string_view bytes = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return bytes;
}

std::uint8_t ByteReader::Byte() {
  const std::string_view bytes = Bytes(1);
  return bytes.empty() ? std::uint8_t{0} : static_cast<std::uint8_t>(bytes[0]);
}

std::uint16_t ByteReader::Short() {
  const std::string_view bytes = Bytes(sizeof(std::uint16_t));
  return bytes.empty() ? std::uint16_t{0} : FromLittle<std::uint16_t>(bytes.data());
}

std::uint32_t ByteReader::Long() {
  const std::string_view bytes = Bytes(sizeof(std::uint32_t));
  return bytes.empty() ? 0 : FromLittle<std::uint32_t>(bytes.data());
}

double ByteReader::Double() {
  const std::string_view bytes = Bytes(sizeof(double));
  return bytes.empty() ? 0.0 : std::bit_cast<double>(FromLittle<std::uint64_t>(bytes.data()));
}

bool ParseCommand(std::string_view payload, CommandMessage* message) {
  ByteReader reader(payload);
  message->service = reader.Short();
  message->count = reader.rest().size() / sizeof(double);
  if (!reader.ok() || reader.rest().size() % sizeof(double) != 0 || message->count > kMostNumbers) {
    return false;
  }
  CopyDoubles(reader.rest().data(), message->count, message->numbers.data());
  return true;
}

bool ParseDeclare(std::string_view payload, DeclareMessage* message) {
  ByteReader reader(payload);
  message->id = reader.Short();
  message->component = reader.Bytes(reader.Short());
  message->service = reader.rest();
  return reader.ok() && message->id < kMostDeclared;
}

bool ParseSubscribe(std::string_view payload, SubscribeMessage* message) {
  ByteReader reader(payload);
  message->id = reader.Short();
  message->form = static_cast<DataForm>(reader.Byte());
  message->device = reader.rest();
  return reader.ok() && message->id < kMostDeclared &&
         (message->form <= DataForm::kScan || message->form == DataForm::kNone);
}

bool NextDataEntry(ByteReader& reader, DataEntry* entry) {
  if (!reader.ok() || reader.rest().empty()) return false;
  entry->id = reader.Short();
  entry->form = static_cast<DataForm>(reader.Byte());
  const std::uint32_t size = reader.Long();
  entry->timestamp = reader.Double();
  entry->bytes = reader.Bytes(size);
  return reader.ok();
}

void CopyDoubles(const char* bytes, std::size_t count, double* to) {
  if constexpr (std::endian::native == std::endian::little) {
    if (count > 0) std::memcpy(to, bytes, count * sizeof(double));
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      to[i] = std::bit_cast<double>(FromLittle<std::uint64_t>(bytes + i * sizeof(double)));
    }
  }
}

}  // namespace ccmorse::wire
