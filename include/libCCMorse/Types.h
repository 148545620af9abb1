#pragma once

#include <cstdint>
#include <string>

#include "libplayerc/playerc.h"

namespace CCMorse {

/// A cell of the canvas: column x from the left and row y from the bottom (thesis listing C.2,
/// line 116). A plain value.
struct ImagePoint_t {
  int x = 0;  ///< cells from the left edge
  int y = 0;  ///< cells from the bottom edge

  ImagePoint_t() = default;
  ImagePoint_t(int column, int row) : x(column), y(row) {}
};

inline bool operator==(const ImagePoint_t& a, const ImagePoint_t& b) {
  return a.x == b.x && a.y == b.y;
}

/// A colour of the canvas, 0..255 a channel (thesis 4.2.2).
struct Color_t {
  unsigned char r = 0;  ///< red
  unsigned char g = 0;  ///< green
  unsigned char b = 0;  ///< blue
};

inline bool operator==(const Color_t& a, const Color_t& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

/// A cell and its new colour, for updates of many cells at once (thesis 4.2.1).
struct PixelUpdate_t {
  ImagePoint_t point;  ///< which cell
  Color_t color;       ///< its new colour
};

/// A layer of the canvas, as the simulator lists it for its view (docs/canvas.md).
struct CanvasLayer_t {
  std::string name;
  int priority = 0;     ///< a higher one lies above
  bool visible = true;  ///< as the program wants it
  bool shown = true;    ///< as people who look at the view want it; seen is what both want
};

// Player's value types, which programs brace-initialise.
using ::player_bbox3d_t;
using ::player_devaddr_t;
using ::player_point_2d_t;
using ::player_pose2d_t;
using ::player_pose3d_t;
using ::playerc_device_info_t;

}  // namespace CCMorse
