#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace ccmorse::wire {

/// The fast link's bytes, version 1 (docs/protocols/fast-link.md): frames of a header of 8 bytes -
/// size of the payload (u32), type (u8), three zeros - and the payload. Whole numbers are
/// little-endian, doubles IEEE 754 binary64, little-endian.
inline constexpr int kFastLinkVersion = 1;

enum class FrameType : std::uint8_t {
  kLines = 1,       ///< both ways: bytes of the line protocol
  kCommand = 2,     ///< to the server: a declared service with numbers
  kDeclare = 3,     ///< to the server: a number for a service
  kSubscribe = 4,   ///< to the server: a number and a form for a device's data
  kRead = 5,        ///< to the server: the next data, please
  kImage = 6,       ///< to the server: what has changed in the whole canvas
  kPixels = 7,      ///< to the server: cells of the canvas
  kData = 8,        ///< to the client: the answer to a read
  kReadFailed = 9,  ///< to the client: a read that brings nothing, and why
  kRefused = 10,    ///< to the client: a command, image or pixels that failed, and why
};

/// How a device's data travel.
enum class DataForm : std::uint8_t {
  kText = 0,      ///< the JSON of get_local_data
  kPose = 1,      ///< x, y, z, m; roll, pitch, yaw, rad
  kOdometry = 2,  ///< as kPose; vx, vy, vz, m/s; wx, wy, wz, rad/s; stall, 0 or 1
  kScan = 3,      ///< ranges, m
  kNone = 255,    ///< not at all: ends a subscription
};

inline constexpr std::size_t kFrameHeader = 8;
inline constexpr std::size_t kMostNumbers = 16;     ///< of one command
inline constexpr std::size_t kMostDeclared = 4096;  ///< services, and devices, of one connection
inline constexpr std::size_t kMostClientFrame = 4U << 20;   ///< bytes of payload, to the server
inline constexpr std::size_t kMostServerFrame = 64U << 20;  ///< bytes of payload, to the client

/// A frame as it was received; the view is valid until the splitter gets more bytes.
struct Frame {
  FrameType type = FrameType::kLines;
  std::string_view payload;
};

/// Cuts a stream of bytes into frames. Bytes are received straight into its buffer.
class FrameSplitter {
 public:
  /// `longest`: bytes of payload that a frame may have.
  explicit FrameSplitter(std::size_t longest) : longest_(longest) {}

  /// Room for `size` more bytes behind those that are there; Commit() says how many came.
  char* Space(std::size_t size);
  void Commit(std::size_t size) { end_ += size; }
  void Append(std::string_view bytes);

  /// kBroken: these are no frames (unknown type, zeros missing, too long); for good.
  enum class Result { kFrame, kNeedMore, kBroken };
  Result Next(Frame* frame);

  std::size_t buffered() const { return end_ - begin_; }

 private:
  std::size_t longest_;
  std::unique_ptr<char[]> buffer_;
  std::size_t capacity_ = 0;
  std::size_t begin_ = 0;  // of what was not handed out yet
  std::size_t end_ = 0;
};

/// Writes one frame behind what `out` holds; it is whole once the writer has gone.
class FrameWriter {
 public:
  FrameWriter(std::string& out, FrameType type);
  ~FrameWriter();
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  void Byte(std::uint8_t value);
  void Short(std::uint16_t value);
  void Long(std::uint32_t value);
  void Double(double value);
  void Doubles(const double* values, std::size_t count);
  void Bytes(std::string_view bytes) { out_ += bytes; }

 private:
  std::string& out_;
  std::size_t start_;
};

/// Takes values from the front of bytes. Once something is missing, ok() is false and everything
/// read is 0 or empty.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  std::uint8_t Byte();
  std::uint16_t Short();
  std::uint32_t Long();
  double Double();
  std::string_view Bytes(std::size_t size);

  std::string_view rest() const { return rest_; }
  bool ok() const { return ok_; }

 private:
  std::string_view rest_;
  bool ok_ = true;
};

/// kCommand's payload.
struct CommandMessage {
  std::uint16_t service = 0;
  std::size_t count = 0;
  std::array<double, kMostNumbers> numbers{};
};
bool ParseCommand(std::string_view payload, CommandMessage* message);

/// kDeclare's payload.
struct DeclareMessage {
  std::uint16_t id = 0;
  std::string_view component;
  std::string_view service;
};
bool ParseDeclare(std::string_view payload, DeclareMessage* message);

/// kSubscribe's payload.
struct SubscribeMessage {
  std::uint16_t id = 0;
  DataForm form = DataForm::kText;
  std::string_view device;
};
bool ParseSubscribe(std::string_view payload, SubscribeMessage* message);

/// One device's part of kData's payload, which begins with the simulated time (a double).
struct DataEntry {
  std::uint16_t id = 0;
  DataForm form = DataForm::kText;
  double timestamp = 0.0;  ///< s
  std::string_view bytes;  ///< JSON, or doubles
};
/// Takes the next entry; false at the end and for what is none (`reader.ok()` tells them apart).
bool NextDataEntry(ByteReader& reader, DataEntry* entry);

/// The doubles that little-endian bytes hold. Precondition: 8 * count bytes at `bytes`.
void CopyDoubles(const char* bytes, std::size_t count, double* to);

}  // namespace ccmorse::wire
