#include "imr-h/map_grid.h"

#include <algorithm>
#include <cmath>

namespace imr {
namespace {

// Far outside is outside; converting would overflow.
int cellOf(double cells) { return static_cast<int>(std::floor(std::clamp(cells, -1e9, 1e9))); }

}  // namespace

CMapGrid::CMapGrid(int width, int height, double cellSize) {
  assert_argument(width > 0 && height > 0 && height <= (1 << 26) / width,
                  "a map must have between 1 and 2^26 cells");
  assert_argument(std::isfinite(cellSize) && cellSize > 0.0,
                  "the cells of a map must have a positive size");
  map_.width = width;
  map_.height = height;
  map_.cellSize = cellSize;
  map_.cells.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), UNKNOWN);
}

CMapGrid::CMapGrid(const std::string& file, double cellSize) : map_(loadMap(file, cellSize)) {}

void CMapGrid::setCell(int x, int y, double value) {
  ASSERT_ARGUMENT(value >= 0.0 && value <= 1.0, "a cell is between 0 and 1");
  map_.cells[checked(x, y)] = value;
}

void CMapGrid::fill(double value) {
  ASSERT_ARGUMENT(value >= 0.0 && value <= 1.0, "a cell is between 0 and 1");
  std::fill(map_.cells.begin(), map_.cells.end(), value);
}

int CMapGrid::getX(double metres) const { return cellOf((metres - map_.originX) / map_.cellSize); }

int CMapGrid::getY(double metres) const { return cellOf((metres - map_.originY) / map_.cellSize); }

void CMapGrid::copyTo(double* cells) const {
  std::copy(map_.cells.begin(), map_.cells.end(), cells);
}

std::size_t CMapGrid::checked(int x, int y) const {
  ASSERT_ARGUMENT(contains(x, y),
                  "cell (" + std::to_string(x) + ", " + std::to_string(y) + ") is outside the map");
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(map_.width) +
         static_cast<std::size_t>(x);
}

}  // namespace imr
