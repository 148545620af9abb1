#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "imr-h/map_grid.h"

namespace imr {

/// A cell of the map: column from the left, row from the bottom.
struct SCell {
  int x = 0;
  int y = 0;
  bool operator==(const SCell& other) const { return x == other.x && y == other.y; }
};

/// Plans paths of the robot in a grid map (thesis 4.3.2): obstacles are dilated by the robot's
/// radius, the shortest way of cells is found, and then smoothed.
///
/// A step goes to one of the eight cells around; it costs 1 to the side and sqrt(2) diagonally, and
/// a diagonal step needs both cells beside it to be free, too, so that no corner is cut. One
/// thread.
class CPlanner {
 public:
  /// Obstacles are dilated by so many cells: 0.098 m, the radius around the S1R, is 4.9 of them.
  static constexpr int DILATION = 5;

  /// Takes a copy of the map, and dilates its obstacles. What is unknown is no place to go, either.
  void setMap(const CMapGrid& map);

  /// Plans from the start to the goal, in cells; false if there is no way, or an end is outside the
  /// map or in a dilated obstacle. The paths below are then empty.
  bool plan(int startX, int startY, int goalX, int goalY);

  /// Whether a cell can be gone to: inside the map, and no obstacle was dilated over it.
  bool isFree(int x, int y) const {
    return x >= 0 && x < width && y >= 0 && y < height && free[at({x, y})] != 0;
  }

  int getWidth() const { return width; }    ///< columns of the map
  int getHeight() const { return height; }  ///< rows of the map

  /// The path found, cell by cell, from the start to the goal.
  const std::vector<SCell>& getPath() const { return path; }
  /// The smoothed path: the corners of a line through free cells only.
  const std::vector<SCell>& getSmoothPath() const { return smooth; }

  /// Length of a path as a line from cell to cell, in cells. Steps to the side and diagonal ones
  /// are counted, and not summed up, so that equal paths have equal lengths.
  static double lengthOf(const std::vector<SCell>& cells);

 private:
  std::size_t at(SCell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(cell.x);
  }

  // --- What a student writes, in planner.cc

  /// Writes into `free` which cells the robot's middle may be in.
  void inflateMap(const CMapGrid& map);
  /// Writes the cheapest path into `path`; false when there is none.
  bool dijkstra(SCell start, SCell goal);
  /// Writes the smoothed `path` into `smooth`.
  void smooth_path();
  /// Whether the straight line between the middles of two cells meets free cells only.
  bool bresenham(SCell from, SCell to) const;

  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> free;  // height x width, row by row from the bottom; 1: free
  std::vector<SCell> path;
  std::vector<SCell> smooth;
};

}  // namespace imr
