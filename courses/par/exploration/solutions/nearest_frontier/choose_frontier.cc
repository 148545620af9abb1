#include <limits>

#include "exploration.h"

namespace imr {

// The nearest by the way to go.
int CExploration::chooseFrontier(const std::vector<SCell>& frontiers) {
  int chosen = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < frontiers.size(); ++i) {
    const double way = cost[at(frontiers[i].x, frontiers[i].y)];
    if (way >= least) continue;
    least = way;
    chosen = static_cast<int>(i);
  }
  return chosen;
}

}  // namespace imr
