// Planning to frontiers. Which of them is what choose_frontier.cc decides.

#include "exploration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "imr-h/dijkstra_heap.h"

namespace imr {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kFree = 0.4;    // less: seen, and free
constexpr double kWall = 0.6;    // more: an obstacle
constexpr int kFewestCells = 2;  // of a frontier: the narrowest way through a gate is as wide

constexpr int kLooks = 5;  // a second each; a turn on the spot takes three

constexpr std::array<SCell, 8> kAround = {SCell{1, 0}, SCell{0, 1},  SCell{-1, 0},  SCell{0, -1},
                                          SCell{1, 1}, SCell{-1, 1}, SCell{-1, -1}, SCell{1, -1}};

}  // namespace

SPlan CExploration::plan(const CMapGrid& seen, const SPosition& position) {
  map = seen;
  SPlan made;
  inflateMap(made);
  detectFrontiers(made);
  dijkstra(freeCellNear({map.getX(position.x), map.getY(position.y)}));
  const int chosen = chooseFrontier(made.frontiers);
  if (chosen < 0) {
    // Noise may close a narrow way for a moment: before it is done, the robot looks around, which
    // it does without a path.
    made.done = ++without >= kLooks;
    return made;
  }
  without = 0;
  const SCell goal = made.frontiers[static_cast<std::size_t>(chosen)];
  std::vector<SCell> path;
  for (int node = static_cast<int>(at(goal.x, goal.y)); node != -1;
       node = previous[static_cast<std::size_t>(node)]) {
    path.push_back({node % map.getWidth(), node / map.getWidth()});
  }
  std::reverse(path.begin(), path.end());
  for (const SCell& corner : smooth(path)) {
    made.path.push_back({map.getPosX(corner.x), map.getPosY(corner.y), 0.0});
  }
  // The robot is in the first cell already, unless it has to leave a dilated place.
  if (made.path.size() > 1 && path.front() == SCell{map.getX(position.x), map.getY(position.y)}) {
    made.path.erase(made.path.begin());
  }
  return made;
}

void CExploration::inflateMap(SPlan& made) {
  const int width = map.getWidth();
  const int height = map.getHeight();
  std::vector<std::uint8_t> dilated(map.cells().size(), 0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (map.getCell(x, y) < kWall) continue;
      for (int dy = -DILATION; dy <= DILATION; ++dy) {
        for (int dx = -DILATION; dx <= DILATION; ++dx) {
          if (dx * dx + dy * dy > DILATION * DILATION || !map.contains(x + dx, y + dy)) continue;
          dilated[at(x + dx, y + dy)] = 1;
        }
      }
    }
  }
  free.assign(map.cells().size(), 0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double cell = map.getCell(x, y);
      if (dilated[at(x, y)] == 0) {
        free[at(x, y)] = cell < kFree ? 1 : 0;
      } else if (cell < kWall) {
        made.inflated.push_back({x, y});
      }
    }
  }
}

void CExploration::detectFrontiers(SPlan& made) {
  const int width = map.getWidth();
  const int height = map.getHeight();
  std::vector<std::uint8_t> border(free.size(), 0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (free[at(x, y)] == 0) continue;
      for (std::size_t i = 0; i < 4; ++i) {
        const SCell next{x + kAround[i].x, y + kAround[i].y};
        if (!map.contains(next.x, next.y)) continue;
        const double cell = map.getCell(next.x, next.y);
        if (cell >= kFree && cell <= kWall) border[at(x, y)] = 1;
      }
    }
  }
  // Groups of cells side by side; small ones are left out.
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (border[at(x, y)] == 0) continue;
      std::vector<SCell> group = {{x, y}};
      border[at(x, y)] = 0;
      for (std::size_t i = 0; i < group.size(); ++i) {
        for (const SCell& step : kAround) {
          const SCell next{group[i].x + step.x, group[i].y + step.y};
          if (!map.contains(next.x, next.y) || border[at(next.x, next.y)] == 0) continue;
          border[at(next.x, next.y)] = 0;
          group.push_back(next);
        }
      }
      if (group.size() < kFewestCells) continue;
      made.frontiers.insert(made.frontiers.end(), group.begin(), group.end());
    }
  }
}

SCell CExploration::freeCellNear(SCell cell) const {
  SCell best = cell;
  int nearest = std::numeric_limits<int>::max();
  constexpr int kReach = 2 * DILATION;
  for (int dy = -kReach; dy <= kReach; ++dy) {
    for (int dx = -kReach; dx <= kReach; ++dx) {
      const int distance = dx * dx + dy * dy;
      if (distance >= nearest || !map.contains(cell.x + dx, cell.y + dy) ||
          free[at(cell.x + dx, cell.y + dy)] == 0) {
        continue;
      }
      nearest = distance;
      best = {cell.x + dx, cell.y + dy};
    }
  }
  return best;
}

void CExploration::dijkstra(SCell start) {
  cost.assign(free.size(), kNever);
  previous.assign(free.size(), -1);
  if (!map.contains(start.x, start.y)) return;
  dijkstra::CHeap<double> heap(static_cast<int>(free.size()));
  cost[at(start.x, start.y)] = 0.0;
  heap.add(static_cast<int>(at(start.x, start.y)), 0.0);
  const auto isFree = [this](int x, int y) { return map.contains(x, y) && free[at(x, y)] != 0; };
  for (int node = heap.getFirst(); node != -1; node = heap.getFirst()) {
    const SCell cell{node % map.getWidth(), node / map.getWidth()};
    for (const SCell& step : kAround) {
      const SCell next{cell.x + step.x, cell.y + step.y};
      if (!isFree(next.x, next.y)) continue;
      const bool diagonal = step.x != 0 && step.y != 0;
      if (diagonal && (!isFree(next.x, cell.y) || !isFree(cell.x, next.y))) continue;
      const double reached = cost[at(cell.x, cell.y)] + (diagonal ? std::sqrt(2.0) : 1.0);
      if (reached >= cost[at(next.x, next.y)]) continue;
      cost[at(next.x, next.y)] = reached;
      previous[at(next.x, next.y)] = node;
      heap.update(static_cast<int>(at(next.x, next.y)), reached);
    }
  }
}

// From each corner on straight to the farthest cell of the path that it sees: all cells that the
// line meets are free.
std::vector<SCell> CExploration::smooth(const std::vector<SCell>& path) const {
  const auto isFree = [this](int x, int y) { return map.contains(x, y) && free[at(x, y)] != 0; };
  const auto sees = [&](SCell from, SCell to) {
    const int nx = std::abs(to.x - from.x);
    const int ny = std::abs(to.y - from.y);
    const int stepX = to.x > from.x ? 1 : -1;
    const int stepY = to.y > from.y ? 1 : -1;
    for (int ix = 0, iy = 0; ix < nx || iy < ny;) {
      const int upright = (1 + 2 * ix) * ny;
      const int level = (1 + 2 * iy) * nx;
      if (upright == level &&
          (!isFree(from.x + stepX, from.y) || !isFree(from.x, from.y + stepY))) {
        return false;
      }
      if (upright <= level) {
        from.x += stepX;
        ++ix;
      }
      if (level <= upright) {
        from.y += stepY;
        ++iy;
      }
      if (!isFree(from.x, from.y)) return false;
    }
    return true;
  };
  std::vector<SCell> corners = {path.front()};
  for (std::size_t from = 0; from + 1 < path.size();) {
    std::size_t to = path.size() - 1;
    while (to > from + 1 && !sees(path[from], path[to])) --to;
    corners.push_back(path[to]);
    from = to;
  }
  return corners;
}

}  // namespace imr
