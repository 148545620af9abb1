#include "libCCMorse/Paint.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "libCCMorse/MorseError.h"

namespace CCMorse {

Color_t Paint_t::FromBytes(int r, int g, int b) {
  const auto channel = [](int c) { return static_cast<unsigned char>(std::clamp(c, 0, 255)); };
  return Color_t{channel(r), channel(g), channel(b)};
}

Color_t Paint_t::FromDecimals(double r, double g, double b) {
  const auto channel = [](double c) {
    return static_cast<unsigned char>(c > 0.0 ? std::lround(std::min(c, 1.0) * 255.0) : 0);
  };
  return Color_t{channel(r), channel(g), channel(b)};
}

Color_t Paint_t::FromText(const std::string& text) {
  if (text.size() != 7 || text[0] != '#' ||
      text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos) {
    throw MorseError("\"" + text + "\" is no colour; write it as \"#34AAFF\"",
                     "Paint_t::Paint_t()");
  }
  const auto value = std::strtoul(text.c_str() + 1, nullptr, 16);
  return Color_t{static_cast<unsigned char>(value >> 16U & 0xFFU),
                 static_cast<unsigned char>(value >> 8U & 0xFFU),
                 static_cast<unsigned char>(value & 0xFFU)};
}

}  // namespace CCMorse
