#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/pose.h"
#include "grade/grid.h"

namespace ccmorse::grade {

/// A map that a program has handed in.
struct MapAnswer {
  int width = 0;
  int height = 0;
  double cell_size = 0.0;  ///< m
  Vec2 origin;             ///< m, the bottom-left cell's bottom-left corner
  std::string cells;       ///< '0' free, '1' wall, '?' unknown, row by row from the bottom

  /// What it says of a place; '?' outside.
  char At(Vec2 point) const;
};

/// Reads an answer's JSON. Throws Error that says what is wrong with it.
MapAnswer ReadMap(const std::string& text);
/// [[x, y], ...], m, two points or more. Throws Error that says what is wrong with it.
std::vector<Vec2> ReadPath(const std::string& text);
/// [x, y, yaw]. Throws Error that says what is wrong with it.
Pose2 ReadPose(const std::string& text);

/// The cells that a robot at `start` can come to: those that its disc covers, driving from there
/// wherever there is room, and that are no wall.
Grid ReachableFloor(const scene::World& world, Vec2 start);

/// How a map compares with the truth. `reachable` is ReachableFloor().
struct MapScores {
  double explored = 0.0;  ///< share of the reachable cells that the map knows
  double accuracy = 0.0;  ///< share of them that it knows to be free
  double iou = 0.0;       ///< intersection over union of the walls, with kTolerance cells of play
};
inline constexpr int kTolerance = 2;
MapScores CompareMap(const MapAnswer& map, const scene::World& world, const Grid& reachable);

}  // namespace ccmorse::grade
