#pragma once

#include <cstdint>
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

/// How a map compares with the truth, where the robot saw it: what nobody saw was not mapped, and a
/// map that is right there was guessed, or brought along.
struct MapScores {
  double accuracy = 0.0;  ///< share of the reachable cells that were seen, and that it calls free
  double iou = 0.0;       ///< intersection over union of the walls, with kTolerance cells of play
};
inline constexpr int kTolerance = 2;

/// `reachable` is ReachableFloor(), `seen` the cells that the robot saw.
MapScores CompareMap(const MapAnswer& map, const scene::World& world, const Grid& reachable,
                     const Grid& seen);

/// Each cell of the world as a map has it, for a picture.
struct MapPicture {
  enum Kind : std::uint8_t {
    kUnknown,       ///< the map does not know
    kFree,          ///< free, and so it says
    kWall,          ///< a wall is there, or no more than kTolerance cells away, and so it says
    kInventedWall,  ///< it says that there is a wall, and there is none
    kMissedWall,    ///< it says that it is free, and it is a wall
    kNotSeen        ///< it says something that the robot did not see
  };
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> cells;  ///< (height, width) of Kind, row by row from the bottom
};
MapPicture PictureOf(const MapAnswer& map, const scene::World& world, const Grid& seen);

}  // namespace ccmorse::grade
