#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ccmorse {

/// A colour, 8 bits a channel (sRGB).
struct Color {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  bool operator==(const Color&) const = default;
};

/// A picture, row 0 at the top, pixels (height x width).
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Color> pixels;
};

/// Writes an 8-bit RGB PNG; the file appears whole or not at all. Throws Error that names the path.
void WritePng(const Image& image, const std::string& path);

/// Reads a PNG of any kind as RGB. Throws Error that names the path.
Image ReadPng(const std::string& path);

}  // namespace ccmorse
