#pragma once

#include <vector>

namespace imr {

/// A cell of the map: column from the left, row from the bottom.
struct SCell {
  int x = 0;
  int y = 0;
  bool operator==(const SCell& other) const { return x == other.x && y == other.y; }
};

/// Where the robot is in the world: m, rad counter-clockwise from the x axis.
struct SPosition {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;
};

/// What CExploration tells CControl to do, and what there is to draw of it.
struct SPlan {
  std::vector<SPosition> path;   ///< corners of the way, in order; yaw means nothing
  std::vector<SCell> inflated;   ///< cells of the dilated obstacles
  std::vector<SCell> frontiers;  ///< cells at the border of the unknown
  bool done = false;             ///< nothing is left to explore
};

}  // namespace imr
