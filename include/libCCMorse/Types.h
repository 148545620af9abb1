#pragma once

#include <cstdint>

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

// Value types with the names and the order of fields that programs for Player know and
// brace-initialise.

/// A point in the plane.
struct player_point_2d_t {
  double px = 0.0;  ///< m
  double py = 0.0;  ///< m
};

/// A pose, or a velocity, in the plane.
struct player_pose2d_t {
  double px = 0.0;  ///< m or m/s
  double py = 0.0;  ///< m or m/s
  double pa = 0.0;  ///< rad or rad/s, counter-clockwise
};

/// A pose in space.
struct player_pose3d_t {
  double px = 0.0;      ///< m
  double py = 0.0;      ///< m
  double pz = 0.0;      ///< m
  double proll = 0.0;   ///< rad, about x
  double ppitch = 0.0;  ///< rad, about y
  double pyaw = 0.0;    ///< rad, about z
};

/// The size of a box.
struct player_bbox3d_t {
  double sw = 0.0;  ///< width, m (across)
  double sl = 0.0;  ///< length, m (along x)
  double sh = 0.0;  ///< height, m
};

/// Address of a Player device.
struct player_devaddr_t {
  std::uint32_t host = 0;    ///< IPv4 address; 0 here
  std::uint32_t robot = 0;   ///< port of the server
  std::uint16_t interf = 0;  ///< interface code: 4 position2d, 6 laser
  std::uint16_t index = 0;   ///< index of the device, as proxies take it
};

/// An entry of PlayerClient::GetDeviceList().
struct playerc_device_info_t {
  player_devaddr_t addr;     ///< how a proxy names the device
  char drivername[64] = "";  ///< the device's name in the simulation, "s1r.hokuyo"
};

}  // namespace CCMorse
