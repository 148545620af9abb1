#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/image.h"

namespace ccmorse::assets {

/// A picture of a material, small: enough for the colours of the faces that it lies on.
struct Picture {
  int width = 0;              ///< pixels, 1..256
  int height = 0;             ///< likewise
  std::vector<Color> pixels;  ///< (height x width), row 0 at the top
  Color mean;                 ///< of all of them, as far as they are opaque

  /// The pixel at texture coordinates, which repeat: (0, 0) is the bottom left corner, (1, 1) the
  /// top right one. Any finite numbers.
  Color At(double u, double v) const;
};

/// Reads a PNG, a JPEG (by libjpeg, at a lower resolution where it is large) or a TGA (Truevision,
/// types 2 and 10), of at most 16384 pixels a side. Nothing where the bytes are no such thing or
/// broken. Thread safe.
std::optional<Picture> ReadPicture(std::span<const std::uint8_t> bytes);

}  // namespace ccmorse::assets
