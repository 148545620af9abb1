#pragma once

#include <cstdint>
#include <vector>

#include "base/image.h"
#include "base/pose.h"

namespace ccmorse::navigation {

/// What is known of a cell, with the numbers of Player's map interface.
enum class Cell : std::int8_t { kFree = -1, kUnknown = 0, kOccupied = 1 };

/// A place in the grid: column from the left, row from the bottom.
struct CellIndex {
  int x = 0;
  int y = 0;
  bool operator==(const CellIndex&) const = default;
};

/// A map of square cells (Player's map interface). Cell (0, 0) is the bottom-left one. A plain
/// value: several threads may read it.
class OccupancyGrid {
 public:
  /// All cells unknown. `scale`: m, side of a cell; `origin`: m, bottom-left corner of cell (0, 0)
  /// in the world. Throws Error when the size or the scale is not positive, or there would be more
  /// than 2^28 cells.
  OccupancyGrid(int width, int height, double scale, Vec2 origin = {});

  /// From a picture, as Player's driver mapfile reads it: a pixel a cell, the top row the last one;
  /// dark is occupied, light is free, what is between is unknown. `negate`: light is occupied.
  static OccupancyGrid FromImage(const Image& image, double scale, bool negate = false,
                                 Vec2 origin = {});

  int width() const { return width_; }
  int height() const { return height_; }
  double scale() const { return scale_; }
  Vec2 origin() const { return origin_; }
  /// Row by row from the bottom (height x width).
  const std::vector<Cell>& cells() const { return cells_; }

  bool Contains(CellIndex cell) const {
    return cell.x >= 0 && cell.x < width_ && cell.y >= 0 && cell.y < height_;
  }
  /// Place of a cell in cells(); the cell must be inside.
  std::size_t IndexOf(CellIndex cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.x);
  }
  /// Unknown outside the map.
  Cell At(CellIndex cell) const { return Contains(cell) ? cells_[IndexOf(cell)] : Cell::kUnknown; }
  /// Nothing happens outside the map.
  void Set(CellIndex cell, Cell value) {
    if (Contains(cell)) cells_[IndexOf(cell)] = value;
  }
  /// The cell that holds the point (m), maybe outside the map.
  CellIndex CellOf(Vec2 point) const;
  /// Middle of the cell, m.
  Vec2 CentreOf(CellIndex cell) const;

  /// For each cell the distance of its middle from that of the nearest occupied cell, m, at most
  /// `limit`, which must be finite and positive. Exact: Felzenszwalb and Huttenlocher, "Distance
  /// transforms of sampled functions", 2012.
  std::vector<double> ObstacleDistances(double limit) const;

  /// The map with every cell occupied that lies within `radius` (m) of an occupied one.
  OccupancyGrid Inflated(double radius) const;

  /// Distance from `from` (m) in the direction `angle` (rad) to the first occupied cell, m, at most
  /// `range`; unknown cells and what is outside the map let it through. Exact to where the ray
  /// enters that cell.
  double CastRay(Vec2 from, double angle, double range) const;

 private:
  int width_;
  int height_;
  double scale_;
  Vec2 origin_;
  std::vector<Cell> cells_;
};

}  // namespace ccmorse::navigation
