#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "wire/player/messages.h"
#include "wire/player/xdr.h"

namespace ccmorse::wire::player {

/// What a message is (specs: player.md B.2).
enum class MessageType : std::uint8_t {
  kData = 1,
  kCommand = 2,
  kRequest = 3,
  kAck = 4,
  kSynch = 5,
  kNack = 6,
};

inline constexpr std::size_t kBannerSize = 32;  ///< bytes a server sends first
inline constexpr std::size_t kHeaderSize = 40;  ///< bytes before each body
/// Longest body that Player allows, bytes.
inline constexpr std::size_t kLongestBody = std::size_t{32} << 20U;

/// Universal requests of any interface (B.4).
inline constexpr std::uint8_t kCapabilities = 255;
inline constexpr std::uint8_t kGetInt = 254;
inline constexpr std::uint8_t kSetInt = 253;
inline constexpr std::uint8_t kGetDouble = 252;
inline constexpr std::uint8_t kSetDouble = 251;
inline constexpr std::uint8_t kGetString = 250;
inline constexpr std::uint8_t kSetString = 249;
inline constexpr std::uint8_t kGetBool = 248;
inline constexpr std::uint8_t kSetBool = 247;

/// "Player v." and the version, padded with NULs to kBannerSize.
std::string Banner(std::string_view version);

/// The header of each message (B.2).
struct Header {
  Devaddr address;
  MessageType type = MessageType::kData;
  std::uint8_t subtype = 0;
  double time = 0.0;  ///< s, of data: simulated time
  std::uint32_t sequence = 0;
  std::uint32_t size = 0;  ///< bytes of the body
};

/// Appends a message; its header's size is the body's.
void Append(Header header, std::span<const std::uint8_t> body, std::string& out);

struct Message {
  Header header;
  std::span<const std::uint8_t> body;  ///< valid until the next call of the reader
};

/// Cuts a stream of bytes into messages, however it arrives. Not for several threads at once.
class FrameReader {
 public:
  /// `longest_body`, bytes: what says it is longer makes broken() true.
  explicit FrameReader(std::size_t longest_body = kLongestBody) : longest_body_(longest_body) {}

  void Append(std::string_view bytes);
  /// The next whole message; nothing when it has not all arrived, or after broken().
  std::optional<Message> Next();
  /// The stream holds a header that cannot be true: an unknown type or too long a body. Nothing
  /// after it can be trusted.
  bool broken() const { return broken_; }

 private:
  std::size_t longest_body_;
  std::string buffer_;
  std::size_t start_ = 0;  // of what is not yet read in buffer_
  bool broken_ = false;
};

/// Code of the interface "laser", nothing when there is no such.
std::optional<std::uint16_t> InterfaceCode(std::string_view name);
/// Name of the interface 6, "" when there is no such.
std::string_view InterfaceName(std::uint16_t code);

/// Decodes the body of a message that carries one and encodes it again, for tests and for checks of
/// what came: nothing when the message is not known or its body is wrong.
std::optional<Bytes> Recode(std::uint16_t interface_code, MessageType type, std::uint8_t subtype,
                            std::span<const std::uint8_t> body);

}  // namespace ccmorse::wire::player
