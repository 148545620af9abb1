#include "grade/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "base/polygon.h"

namespace ccmorse::grade {
namespace {

// A micrometre for roundings: most edges lie on the lines between cells.
constexpr double kRounding = 1e-6;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double SegmentDistance(Vec2 a, Vec2 b, Vec2 point) {
  const Vec2 along = b - a;
  const double square = Dot(along, along);
  const double share = square > 0.0 ? std::clamp(Dot(point - a, along) / square, 0.0, 1.0) : 0.0;
  const Vec2 off = point - (a + share * along);
  return std::hypot(off.x, off.y);
}

bool Stands(const scene::Box& box) { return box.raised && box.solid; }

}  // namespace

int Grid::Count() const { return static_cast<int>(std::count(cells.begin(), cells.end(), 1)); }

Cell CellOf(Vec2 point) {
  return {static_cast<int>(std::floor(std::clamp(point.x / kCell, -1e8, 1e8))),
          static_cast<int>(std::floor(std::clamp(point.y / kCell, -1e8, 1e8)))};
}

Vec2 MiddleOf(Cell cell) { return {(cell.x + 0.5) * kCell, (cell.y + 0.5) * kCell}; }

Grid Walls(const scene::World& world, double margin) {
  Grid walls(static_cast<int>(std::floor(world.size_x / kCell + kRounding)),
             static_cast<int>(std::floor(world.size_y / kCell + kRounding)));
  for (const scene::Box& box : world.boxes) {
    if (!Stands(box)) continue;
    const double reach = std::hypot(box.size_x, box.size_y) / 2.0 + margin + kCell;
    const Cell low = CellOf({box.pose.x - reach, box.pose.y - reach});
    const Cell high = CellOf({box.pose.x + reach, box.pose.y + reach});
    for (int y = std::max(low.y, 0); y <= std::min(high.y, walls.height - 1); ++y) {
      for (int x = std::max(low.x, 0); x <= std::min(high.x, walls.width - 1); ++x) {
        const Vec2 at = InverseTransform(box.pose, MiddleOf({x, y}));
        if (std::fabs(at.x) <= box.size_x / 2.0 + margin + kRounding &&
            std::fabs(at.y) <= box.size_y / 2.0 + margin + kRounding) {
          walls.Set({x, y});
        }
      }
    }
  }
  return walls;
}

Grid Grown(const Grid& grid, int radius) {
  std::vector<Cell> disc;
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      if (x * x + y * y <= radius * radius) disc.push_back({x, y});
    }
  }
  Grid grown(grid.width, grid.height);
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      if (!grid.Has({x, y})) continue;
      for (const Cell& off : disc) grown.Set({x + off.x, y + off.y});
    }
  }
  return grown;
}

Grid Inverted(const Grid& grid) {
  Grid inverted = grid;
  for (std::uint8_t& cell : inverted.cells) cell = cell == 0 ? 1 : 0;
  return inverted;
}

Grid Connected(const Grid& free, Cell start) {
  Grid connected(free.width, free.height);
  if (!free.Has(start)) return connected;
  std::vector<Cell> next = {start};
  connected.Set(start);
  while (!next.empty()) {
    const Cell cell = next.back();
    next.pop_back();
    for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      const Cell to{cell.x + dx, cell.y + dy};
      if (!free.Has(to) || connected.Has(to)) continue;
      connected.Set(to);
      next.push_back(to);
    }
  }
  return connected;
}

double ShortestWay(const Grid& free, Cell start, Cell goal) {
  if (!free.Has(start) || !free.Has(goal)) return kInfinity;
  struct Way {
    int sides = 0;
    int diagonals = 0;
    double Cost() const { return sides + diagonals * std::sqrt(2.0); }
  };
  std::vector<double> best(free.cells.size(), kInfinity);
  using Entry = std::pair<double, std::pair<std::size_t, Way>>;
  const auto later = [](const Entry& a, const Entry& b) { return a.first > b.first; };
  std::priority_queue<Entry, std::vector<Entry>, decltype(later)> open(later);
  best[free.At(start)] = 0.0;
  open.push({0.0, {free.At(start), {}}});
  while (!open.empty()) {
    const auto [cost, state] = open.top();
    open.pop();
    const auto& [index, way] = state;
    if (cost > best[index]) continue;
    if (index == free.At(goal)) return cost;
    const int width = free.width;
    const Cell cell{static_cast<int>(index) % width, static_cast<int>(index) / width};
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell to{cell.x + dx, cell.y + dy};
        const bool diagonal = dx != 0 && dy != 0;
        if ((dx == 0 && dy == 0) || !free.Has(to)) continue;
        if (diagonal && (!free.Has({to.x, cell.y}) || !free.Has({cell.x, to.y}))) continue;
        const Way on{way.sides + (diagonal ? 0 : 1), way.diagonals + (diagonal ? 1 : 0)};
        if (on.Cost() >= best[free.At(to)]) continue;
        best[free.At(to)] = on.Cost();
        open.push({on.Cost(), {free.At(to), on}});
      }
    }
  }
  return kInfinity;
}

double WallDistance(const scene::World& world, Vec2 point) {
  double nearest = kInfinity;
  for (const scene::Box& box : world.boxes) {
    if (!Stands(box)) continue;
    const Vec2 at = InverseTransform(box.pose, point);
    nearest = std::min(nearest, std::hypot(std::max(std::fabs(at.x) - box.size_x / 2.0, 0.0),
                                           std::max(std::fabs(at.y) - box.size_y / 2.0, 0.0)));
  }
  return nearest;
}

double LineDistance(const std::vector<Vec2>& corners, Vec2 point) {
  double nearest = kInfinity;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    nearest = std::min(nearest, SegmentDistance(corners[i == 0 ? 0 : i - 1], corners[i], point));
  }
  return nearest;
}

double PolygonDistance(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  if (ConvexOverlap(a, b)) return 0.0;
  double nearest = kInfinity;
  for (const auto& [edges, corners] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (std::size_t i = 0; i < edges->size(); ++i) {
      for (const Vec2& corner : *corners) {
        nearest = std::min(nearest,
                           SegmentDistance((*edges)[i], (*edges)[(i + 1) % edges->size()], corner));
      }
    }
  }
  return nearest;
}

}  // namespace ccmorse::grade
