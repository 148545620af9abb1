#include "base/base64.h"

#include <array>
#include <cstdint>

#include "base/error.h"

namespace ccmorse {
namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string ToBase64(std::string_view bytes) {
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  char* to = text.data();
  const auto byte = [&](std::size_t at) -> std::uint32_t {
    return static_cast<unsigned char>(bytes[at]);
  };
  // The first digits of three bytes; whole canvases come this way, so no digit is asked whether it
  // is the last.
  const auto write = [&](std::uint32_t three, std::size_t digits) {
    for (std::size_t k = 0; k < digits; ++k) *to++ = kDigits[three >> (18 - 6 * k) & 63U];
  };
  std::size_t i = 0;
  for (; i + 3 <= bytes.size(); i += 3) {
    write(byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2), 4);
  }
  if (bytes.size() - i == 1) write(byte(i) << 16U, 2);
  if (bytes.size() - i == 2) write(byte(i) << 16U | byte(i + 1) << 8U, 3);
  return text;
}

std::string FromBase64(std::string_view text) {
  static const std::array<int, 256> values = [] {
    std::array<int, 256> table;
    table.fill(-1);
    for (std::size_t i = 0; i < kDigits.size(); ++i) {
      table[static_cast<unsigned char>(kDigits[i])] = static_cast<int>(i);
    }
    return table;
  }();
  std::size_t digits = text.size();
  while (digits > 0 && text.size() - digits < 2 && text[digits - 1] == '=') --digits;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < digits; ++i) {
    const int value = values[static_cast<unsigned char>(text[i])];
    if (value < 0) throw Error("base64: an unexpected character at " + std::to_string(i));
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    // A byte is whole after the second, third and fourth digit of each four.
    if (i % 4 != 0) bytes += static_cast<char>(bits >> (6 - 2 * (i % 4)) & 255U);
  }
  // The length, the padding and the bits that no byte takes leave only one way to write it.
  if (text.size() % 4 != 0 || ToBase64(bytes) != text)
    throw Error("base64: cut short or padded wrongly");
  return bytes;
}

}  // namespace ccmorse
