// What every planner needs to know of the map: which cells are free, and which see each other.

#include <algorithm>
#include <cstdlib>

#include "planner.h"

namespace imr {

void CPlanner::inflateMap(const CMapGrid& map) {
  std::fill(free.begin(), free.end(), std::uint8_t{1});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (map.getCell(x, y) == CMapGrid::FLOOR) continue;
      // A disc of cells around the obstacle. The middle of a thick wall adds nothing, and costs
      // little.
      for (int dy = -DILATION; dy <= DILATION; ++dy) {
        for (int dx = -DILATION; dx <= DILATION; ++dx) {
          if (dx * dx + dy * dy > DILATION * DILATION || !map.contains(x + dx, y + dy)) continue;
          free[at({x + dx, y + dy})] = 0;
        }
      }
    }
  }
}

// Bresenham's line has one cell a column or row; a robot's way touches the others, too. So this
// goes from cell to cell as the line does, and where it passes exactly between two, looks at both.
bool CPlanner::bresenham(SCell from, SCell to) const {
  const int nx = std::abs(to.x - from.x);
  const int ny = std::abs(to.y - from.y);
  const int stepX = to.x > from.x ? 1 : -1;
  const int stepY = to.y > from.y ? 1 : -1;
  int x = from.x;
  int y = from.y;
  if (!isFree(x, y)) return false;
  for (int ix = 0, iy = 0; ix < nx || iy < ny;) {
    // Which border of the cell the line meets first; whole numbers, so nothing is rounded.
    const long long upright = (1LL + 2LL * ix) * ny;
    const long long level = (1LL + 2LL * iy) * nx;
    if (upright == level && (!isFree(x + stepX, y) || !isFree(x, y + stepY))) return false;
    if (upright <= level) {
      x += stepX;
      ++ix;
    }
    if (level <= upright) {
      y += stepY;
      ++iy;
    }
    if (!isFree(x, y)) return false;
  }
  return true;
}

}  // namespace imr
