#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace imr {

/// A picture of grey levels, row 0 at the top.
struct SGrayImage {
  int width = 0;
  int height = 0;
  std::vector<double> light;  ///< height x width, 0 black .. 1 white; transparent pixels are white
};

/// Decodes a PNG (ISO/IEC 15948) of any colour type and depth, not interlaced; colours become the
/// mean of their channels. The library stands alone, so it has a decoder of its own (RFC 1950 and
/// 1951). Checksums are not looked at. Throws io_error without the file's name; at most 2^26
/// pixels.
SGrayImage decodePng(const std::string& bytes);

}  // namespace imr
