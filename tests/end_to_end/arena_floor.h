#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/scenario.h"

namespace ccmorse::testing {

/// The arena's floor in cells of 2 cm, as the course's maps have it: row by row from the bottom.
constexpr int kFloorWidth = 171;
constexpr int kFloorHeight = 186;
constexpr double kFloorCell = 0.02;  ///< m

using Floor = std::vector<std::uint8_t>;  ///< kFloorWidth x kFloorHeight, 1: set

inline std::size_t FloorAt(int x, int y) {
  return static_cast<std::size_t>(y) * kFloorWidth + static_cast<std::size_t>(x);
}
inline bool OnFloor(int x, int y) {
  return x >= 0 && x < kFloorWidth && y >= 0 && y < kFloorHeight;
}

/// Where the middle of a cell is in a box that is up.
Floor TrueWalls(const scene::World& world);

/// All cells within `radius` cells of one that is set.
Floor Grown(const Floor& cells, int radius);

/// Where the middle of a robot can be: 5 cells or more from walls, wherever it can drive to from
/// (1.20, 2.00).
Floor ReachableMiddles(const scene::World& world);

/// The cells that the robot can come to: those that a disc of its size covers, driving from there
/// wherever there is room. What a robot can only look into, such as a dock bay, is not reached.
Floor Reachable(const scene::World& world);

}  // namespace ccmorse::testing
