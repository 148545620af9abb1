#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "wire/player/frame.h"

namespace ccmorse::wire::player {

/// The body of a message as words with a blank between, for logs that people read: its fields in
/// the order of the wire, the count of an array before its elements; numbers in decimal, with as
/// many digits as tell them apart; bytes and texts in hexadecimal digits, without their count, "-"
/// for none. Nothing when the message is not known or its body is wrong. A reply's body has the
/// type of its request.
std::optional<std::string> ToText(std::uint16_t interface_code, MessageType type,
                                  std::uint8_t subtype, std::span<const std::uint8_t> body);

/// The body that ToText() made that text of, to the byte. Nothing where the text is none such.
std::optional<Bytes> FromText(std::uint16_t interface_code, MessageType type, std::uint8_t subtype,
                              std::string_view text);

}  // namespace ccmorse::wire::player
