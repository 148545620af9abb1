// The reference solution: Dijkstra's algorithm, and smoothing by lines of sight.

#include "planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "imr-h/dijkstra_heap.h"

namespace imr {

bool CPlanner::dijkstra(SCell start, SCell goal) {
  constexpr std::array<SCell, 8> steps = {SCell{1, 0}, SCell{0, 1},  SCell{-1, 0},  SCell{0, -1},
                                          SCell{1, 1}, SCell{-1, 1}, SCell{-1, -1}, SCell{1, -1}};
  const int count = width * height;
  std::vector<double> cost(free.size(), std::numeric_limits<double>::infinity());
  std::vector<int> previous(free.size(), -1);
  dijkstra::CHeap<double> heap(count);
  cost[at(start)] = 0.0;
  heap.add(static_cast<int>(at(start)), 0.0);
  for (int node = heap.getFirst(); node != -1; node = heap.getFirst()) {
    const SCell cell{node % width, node / width};
    if (cell == goal) break;
    for (const SCell& step : steps) {
      const SCell next{cell.x + step.x, cell.y + step.y};
      if (!isFree(next.x, next.y)) continue;
      const bool diagonal = step.x != 0 && step.y != 0;
      if (diagonal && (!isFree(next.x, cell.y) || !isFree(cell.x, next.y))) continue;
      const double reached = cost[at(cell)] + (diagonal ? std::sqrt(2.0) : 1.0);
      if (reached >= cost[at(next)]) continue;
      cost[at(next)] = reached;
      previous[at(next)] = node;
      heap.update(static_cast<int>(at(next)), reached);
    }
  }
  if (!(cost[at(goal)] < std::numeric_limits<double>::infinity())) return false;
  for (int node = static_cast<int>(at(goal)); node != -1;
       node = previous[static_cast<std::size_t>(node)]) {
    path.push_back({node % width, node / width});
  }
  std::reverse(path.begin(), path.end());
  return true;
}

// From each corner on straight to the farthest cell of the path that it sees.
void CPlanner::smooth_path() {
  smooth.push_back(path.front());
  for (std::size_t from = 0; from + 1 < path.size();) {
    std::size_t to = path.size() - 1;
    while (to > from + 1 && !bresenham(path[from], path[to])) --to;
    smooth.push_back(path[to]);
    from = to;
  }
}

}  // namespace imr
