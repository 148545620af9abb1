// What a scan tells of cells.

#include "imr-h/map_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace imr {

// A hit is worth more than a beam that went by: lines of cells graze walls where beams do not. A
// few hits make a free cell a wall, not one: it may be noise.
void CMapGrid::updateCell(int x, int y, double occupied) {
  if (!contains(x, y)) return;
  const double step = occupied > UNKNOWN ? 0.25 : -0.05;
  setCell(x, y, std::clamp(getCell(x, y) + step, EMPTY, OCCUPIED));
}

// J. E. Bresenham, "Algorithm for computer control of a digital plotter", 1965.
void CMapGrid::updateCells(int rx, int ry, int cx, int cy, double dist) {
  const int dx = std::abs(cx - rx);
  const int dy = -std::abs(cy - ry);
  const int stepX = rx < cx ? 1 : -1;
  const int stepY = ry < cy ? 1 : -1;
  int error = dx + dy;
  for (int x = rx, y = ry; x != cx || y != cy;) {
    // Up to the cell of the hit: noise sets cells before a wall, and only the beams that cross them
    // on their way to the wall clear them again. Else walls grow until no robot fits between them.
    updateCell(x, y, EMPTY);
    const int twice = 2 * error;
    if (twice >= dy) {
      error += dy;
      x += stepX;
    }
    if (twice <= dx) {
      error += dx;
      y += stepY;
    }
  }
  if (std::isfinite(dist)) updateCell(cx, cy, OCCUPIED);
}

}  // namespace imr
