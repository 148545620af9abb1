// The given part of CPlanner: what is the same in every solution. planner.cc is yours.

#include <cmath>
#include <cstdlib>

#include "planner.h"

namespace imr {

void CPlanner::setMap(const CMapGrid& map) {
  width = map.getWidth();
  height = map.getHeight();
  free.assign(map.cells().size(), 0);
  path.clear();
  smooth.clear();
  inflateMap(map);
}

bool CPlanner::plan(int startX, int startY, int goalX, int goalY) {
  path.clear();
  smooth.clear();
  if (!isFree(startX, startY) || !isFree(goalX, goalY)) return false;
  if (!dijkstra({startX, startY}, {goalX, goalY})) {
    path.clear();
    return false;
  }
  smooth_path();
  return true;
}

double CPlanner::lengthOf(const std::vector<SCell>& cells) {
  int straight = 0;
  int diagonal = 0;
  double other = 0.0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const int dx = std::abs(cells[i].x - cells[i - 1].x);
    const int dy = std::abs(cells[i].y - cells[i - 1].y);
    if (dx == 0 || dy == 0) {
      straight += dx + dy;
    } else if (dx == dy) {
      diagonal += dx;
    } else {
      other += std::hypot(dx, dy);
    }
  }
  return straight + diagonal * std::sqrt(2.0) + other;
}

}  // namespace imr
