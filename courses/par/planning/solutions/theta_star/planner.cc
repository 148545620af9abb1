// The better solution: A*, which looks at fewer cells than Dijkstra's algorithm for the same path,
// and Theta*, which finds a path that is smooth from the start: a cell's predecessor may be any
// cell that sees it. P. E. Hart, N. J. Nilsson and B. Raphael, "A formal basis for the heuristic
// determination of minimum cost paths", 1968; A. Nash, K. Daniel, S. Koenig and A. Felner, "Theta*:
// any-angle path planning on grids", 2007.

#include "planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "imr-h/dijkstra_heap.h"

namespace imr {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

double straight(SCell from, SCell to) { return std::hypot(to.x - from.x, to.y - from.y); }

// Least cost of steps to the side and diagonal ones between two cells.
double octile(SCell from, SCell to) {
  const int dx = std::abs(to.x - from.x);
  const int dy = std::abs(to.y - from.y);
  return std::abs(dx - dy) + std::min(dx, dy) * std::sqrt(2.0);
}

/// The best first search that both have in common; its predecessors make the path.
class CSearch {
 public:
  CSearch(const CPlanner& planner, double (*estimate)(SCell, SCell))
      : planner_(planner), width_(planner.getWidth()), estimate_(estimate) {
    const int count = width_ * planner.getHeight();
    cost_.assign(static_cast<std::size_t>(count), kNever);
    previous_.assign(static_cast<std::size_t>(count), -1);
  }

  /// `sees`: whether a cell may follow another that is not beside it; empty for steps only.
  std::vector<SCell> run(SCell start, SCell goal, const std::function<bool(SCell, SCell)>& sees) {
    constexpr std::array<SCell, 8> steps = {SCell{1, 0}, SCell{0, 1},  SCell{-1, 0},  SCell{0, -1},
                                            SCell{1, 1}, SCell{-1, 1}, SCell{-1, -1}, SCell{1, -1}};
    dijkstra::CHeap<double> heap(static_cast<int>(cost_.size()));
    cost_[at(start)] = 0.0;
    heap.add(static_cast<int>(at(start)), estimate_(start, goal));
    for (int node = heap.getFirst(); node != -1; node = heap.getFirst()) {
      const SCell cell = cellOf(node);
      if (cell == goal) break;
      const int before = previous_[at(cell)];
      for (const SCell& step : steps) {
        const SCell next{cell.x + step.x, cell.y + step.y};
        if (!planner_.isFree(next.x, next.y) || !planner_.isFree(next.x, cell.y) ||
            !planner_.isFree(cell.x, next.y)) {
          continue;
        }
        // Straight from the cell's own predecessor, where that sees the next cell.
        const bool shortcut = sees && before != -1 && sees(cellOf(before), next);
        const SCell from = shortcut ? cellOf(before) : cell;
        const double reached = cost_[at(from)] + straight(from, next);
        // Sums in another order differ by a rounding: that is no better way.
        if (!(reached < cost_[at(next)] - 1e-12)) continue;
        cost_[at(next)] = reached;
        previous_[at(next)] = static_cast<int>(at(from));
        heap.update(static_cast<int>(at(next)), reached + estimate_(next, goal));
      }
    }
    std::vector<SCell> path;
    if (!(cost_[at(goal)] < kNever)) return path;
    for (int node = static_cast<int>(at(goal)); node != -1;
         node = previous_[static_cast<std::size_t>(node)]) {
      path.push_back(cellOf(node));
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

 private:
  std::size_t at(SCell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.x);
  }
  SCell cellOf(int node) const { return {node % width_, node / width_}; }

  const CPlanner& planner_;
  const int width_;
  double (*const estimate_)(SCell, SCell);
  std::vector<double> cost_;
  std::vector<int> previous_;
};

}  // namespace

// A*: with an estimate that never says too much, the path found is a shortest one.
bool CPlanner::dijkstra(SCell start, SCell goal) {
  path = CSearch(*this, octile).run(start, goal, {});
  return !path.empty();
}

void CPlanner::smooth_path() {
  smooth = CSearch(*this, straight).run(path.front(), path.back(), [this](SCell from, SCell to) {
    return bresenham(from, to);
  });
  // Theta* is not always the shortest, now and then even longer than the path of steps: that one,
  // its corners cut where lines of sight allow it, is never longer.
  std::vector<SCell> cut = {path.front()};
  for (std::size_t from = 0; from + 1 < path.size();) {
    std::size_t to = path.size() - 1;
    while (to > from + 1 && !bresenham(path[from], path[to])) --to;
    cut.push_back(path[to]);
    from = to;
  }
  if (lengthOf(cut) < lengthOf(smooth)) smooth = std::move(cut);
}

}  // namespace imr
