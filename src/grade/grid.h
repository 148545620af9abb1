#pragma once

#include <cstdint>
#include <vector>

#include "base/pose.h"
#include "scene/scenario.h"

namespace ccmorse::grade {

/// Edge of a cell of the grader's grids, m: that of the course's maps.
inline constexpr double kCell = 0.02;
/// What a robot keeps between its middle and that of a wall's cell, cells, by the course's rules
/// (courses/par/planning/README.md): more than so many.
inline constexpr int kDilation = 5;

/// A cell: column from the left, row from the bottom.
struct Cell {
  int x = 0;
  int y = 0;
  bool operator==(const Cell&) const = default;
};

/// Cells that are set or not, from the world's origin on, row by row from the bottom. A plain
/// value.
struct Grid {
  Grid(int columns, int rows)
      : width(columns),
        height(rows),
        cells(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0) {}
  bool Inside(Cell cell) const {
    return cell.x >= 0 && cell.x < width && cell.y >= 0 && cell.y < height;
  }
  std::size_t At(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(cell.x);
  }
  /// False outside.
  bool Has(Cell cell) const { return Inside(cell) && cells[At(cell)] != 0; }
  void Set(Cell cell) {
    if (Inside(cell)) cells[At(cell)] = 1;
  }
  int Count() const;

  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> cells;
};

Cell CellOf(Vec2 point);
Vec2 MiddleOf(Cell cell);

/// The cells whose middle is in a solid box that stands, or no more than `margin`, m, beside it
/// along the box's own axes.
Grid Walls(const scene::World& world, double margin);

/// All cells no farther than `radius` cells from a set one, middle to middle.
Grid Grown(const Grid& grid, int radius);

/// The complement.
Grid Inverted(const Grid& grid);

/// The cells of `free` that are connected with `start` over their sides; none where it is not free.
Grid Connected(const Grid& free, Cell start);

/// Cost of the cheapest way between two cells over free ones, in cells; infinity where there is
/// none: steps to the eight neighbours for 1 and sqrt(2), a diagonal one only where both cells
/// beside it are free. Dijkstra's algorithm; sums count sides and diagonals apart, so that equal
/// ways have equal costs.
double ShortestWay(const Grid& free, Cell start, Cell goal);

/// m from a point to the nearest solid box that stands, 0 inside; infinity without any.
double WallDistance(const scene::World& world, Vec2 point);

/// m from a point to a line of one or more corners.
double LineDistance(const std::vector<Vec2>& corners, Vec2 point);

/// m between two convex polygons; 0 where they overlap.
double PolygonDistance(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

}  // namespace ccmorse::grade
