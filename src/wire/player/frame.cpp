#include "wire/player/frame.h"

#include <array>

namespace ccmorse::wire::player {
namespace {

struct Interface {
  std::string_view name;
  std::uint16_t code;
};

#define PLAYER_INTERFACE(name, code) Interface{#name, code},
constexpr std::array kInterfaces = {CCMORSE_PLAYER_INTERFACES};
#undef PLAYER_INTERFACE

template <typename Body>
std::optional<Bytes> RecodeAs(std::span<const std::uint8_t> bytes) {
  Body body;
  if (!Decode(bytes, body)) return {};
  return Encode(body);
}

struct XdrMessage {
  std::uint16_t code;
  std::uint8_t type;
  std::uint8_t subtype;
  std::optional<Bytes> (*recode)(std::span<const std::uint8_t>);
};

#define PLAYER_MESSAGE(interface, code, type, subtype, name, body) \
  XdrMessage{code, type, subtype, &RecodeAs<body>},
constexpr std::array kXdrMessages = {CCMORSE_PLAYER_MESSAGES};
#undef PLAYER_MESSAGE

}  // namespace

std::string Banner(std::string_view version) {
  std::string banner = "Player v." + std::string(version);
  banner.resize(kBannerSize, '\0');
  return banner;
}

void Append(Header header, std::span<const std::uint8_t> body, std::string& out) {
  header.size = static_cast<std::uint32_t>(body.size());
  Bytes bytes;
  bytes.reserve(kHeaderSize);
  XdrWriter writer(bytes);
  writer.Value(header.address);
  writer.Value(static_cast<std::uint8_t>(header.type));
  writer.Value(header.subtype);
  writer.Value(header.time);
  writer.Value(header.sequence);
  writer.Value(header.size);
  out.append(bytes.begin(), bytes.end());
  out.append(body.begin(), body.end());
}

void FrameReader::Append(std::string_view bytes) {
  if (broken_) return;
  buffer_.erase(0, start_);
  start_ = 0;
  buffer_.append(bytes);
}

std::optional<Message> FrameReader::Next() {
  const std::size_t left = buffer_.size() - start_;
  if (broken_ || left < kHeaderSize) return {};
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): chars as bytes
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(buffer_.data()) + start_;
  XdrReader reader(std::span(bytes, kHeaderSize));
  Message message;
  std::uint32_t type = 0;
  reader.Value(message.header.address);
  reader.Value(type);
  reader.Value(message.header.subtype);
  reader.Value(message.header.time);
  reader.Value(message.header.sequence);
  reader.Value(message.header.size);
  if (type < 1 || type > 6 || message.header.size > longest_body_) {
    broken_ = true;
    return {};
  }
  if (left - kHeaderSize < message.header.size) return {};
  message.header.type = static_cast<MessageType>(type);
  message.body = std::span(bytes + kHeaderSize, message.header.size);
  start_ += kHeaderSize + message.header.size;
  return message;
}

std::optional<std::uint16_t> InterfaceCode(std::string_view name) {
  for (const Interface& each : kInterfaces) {
    if (each.name == name) return each.code;
  }
  return {};
}

std::string_view InterfaceName(std::uint16_t code) {
  for (const Interface& each : kInterfaces) {
    if (each.code == code) return each.name;
  }
  return "";
}

std::optional<Bytes> Recode(std::uint16_t interface_code, MessageType type, std::uint8_t subtype,
                            std::span<const std::uint8_t> body) {
  for (const XdrMessage& kind : kXdrMessages) {
    if (kind.code == interface_code && kind.type == static_cast<std::uint8_t>(type) &&
        kind.subtype == subtype) {
      return kind.recode(body);
    }
  }
  return {};
}

}  // namespace ccmorse::wire::player
