// The better solution: not the nearest frontier, but the one that promises most for the way; H. H.
// Gonzalez-Banos and J.-C. Latombe, "Navigation strategies for exploring indoor environments",
// 2002.

#include <algorithm>
#include <cmath>

#include "exploration.h"

namespace imr {
namespace {

constexpr int kReach = 20;        // cells: how far around a frontier the unknown counts
constexpr double kDecay = 0.025;  // 1/cell: what a way costs of what is gained at its end

}  // namespace

int CExploration::chooseFrontier(const std::vector<SCell>& frontiers) {
  // Unknown cells in the rectangle from (0, 0) to each corner, so that any sum takes four of them.
  const int width = map.getWidth() + 1;
  std::vector<int> sums(
      static_cast<std::size_t>(width) * (static_cast<std::size_t>(map.getHeight()) + 1), 0);
  const auto sum = [&](int x, int y) -> int& {
    return sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)];
  };
  for (int y = 0; y < map.getHeight(); ++y) {
    for (int x = 0; x < map.getWidth(); ++x) {
      const bool unknown = map.getCell(x, y) == CMapGrid::UNKNOWN;
      sum(x + 1, y + 1) = sum(x, y + 1) + sum(x + 1, y) - sum(x, y) + (unknown ? 1 : 0);
    }
  }
  int chosen = -1;
  double most = -1.0;
  for (std::size_t i = 0; i < frontiers.size(); ++i) {
    const SCell cell = frontiers[i];
    const double way = cost[at(cell.x, cell.y)];
    if (!std::isfinite(way)) continue;
    const int left = std::max(cell.x - kReach, 0);
    const int right = std::min(cell.x + kReach + 1, map.getWidth());
    const int bottom = std::max(cell.y - kReach, 0);
    const int top = std::min(cell.y + kReach + 1, map.getHeight());
    const int gain = sum(right, top) - sum(left, top) - sum(right, bottom) + sum(left, bottom);
    const double worth = gain * std::exp(-kDecay * way);
    if (worth <= most) continue;
    most = worth;
    chosen = static_cast<int>(i);
  }
  return chosen;
}

}  // namespace imr
