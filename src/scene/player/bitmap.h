#pragma once

#include <string>
#include <vector>

#include "base/image.h"

namespace ccmorse::scene {

/// Reads a PNG or a PNM (P1 to P6, 8 or 16 bits) of at most 64 million pixels. Throws Error that
/// names the path and, for other kinds of pictures, what to do.
Image ReadBitmap(const std::string& path);

/// Reads the content of a PNM called `name` in messages. Throws Error.
Image ParsePnm(const std::string& bytes, const std::string& name);

/// Some columns and rows of a picture, row 0 at the top.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// Rectangles that together are exactly the dark pixels, whose first channel is at most 127 (specs:
/// player.md C.3). A greedy sweep in reading order: each as large as can be about the first pixel
/// not covered yet, so they may overlap.
std::vector<PixelRect> DarkRectangles(const Image& image);

}  // namespace ccmorse::scene
