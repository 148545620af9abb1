#include "sim/spatial_grid.h"

#include <algorithm>
#include <cmath>

namespace ccmorse::sim {
namespace {

constexpr double kSmallestCell = 0.5;  // m

}  // namespace

void SpatialGrid::Build(std::span<const Circle> circles) {
  circles_.assign(circles.begin(), circles.end());
  largest_radius_ = 0.0;
  columns_ = rows_ = 0;
  if (circles_.empty()) return;

  Vec2 low = circles_[0].centre;
  Vec2 high = low;
  for (const Circle& circle : circles_) {
    low = {std::min(low.x, circle.centre.x), std::min(low.y, circle.centre.y)};
    high = {std::max(high.x, circle.centre.x), std::max(high.y, circle.centre.y)};
    largest_radius_ = std::max(largest_radius_, circle.radius);
  }
  corner_ = low;
  // About two cells a circle, however far apart a few of them lie.
  const double width = high.x - low.x;
  const double height = high.y - low.y;
  const auto most_cells = static_cast<double>(2 * circles_.size() + 16);
  cell_ = std::max({kSmallestCell, std::sqrt(width * height / most_cells), width / most_cells,
                    height / most_cells});
  columns_ = static_cast<int>(width / cell_) + 1;
  rows_ = static_cast<int>(height / cell_) + 1;

  // Counting sort by cell, which keeps the order of indexes within a cell.
  cells_.resize(circles_.size());
  // Where circles move, the grid's shape changes from one Build() to the next, within this.
  starts_.reserve(8 * circles_.size() + 64);
  starts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (std::size_t i = 0; i < circles_.size(); ++i) {
    const Vec2 centre = circles_[i].centre;
    cells_[i] = static_cast<std::uint32_t>(Row(centre.y) * columns_ + Column(centre.x));
    ++starts_[cells_[i] + 1];
  }
  for (std::size_t cell = 1; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
  items_.resize(circles_.size());
  for (std::size_t i = circles_.size(); i-- > 0;) {
    // From behind, so that each cell fills from its end: starts_[cell + 1] walks back to its start.
    items_[--starts_[cells_[i] + 1]] = static_cast<std::uint32_t>(i);
  }
  // Every entry but the first now holds the start of the cell before it: move them back.
  for (std::size_t cell = 0; cell + 1 < starts_.size(); ++cell) starts_[cell] = starts_[cell + 1];
  starts_.back() = static_cast<std::uint32_t>(items_.size());
}

}  // namespace ccmorse::sim
