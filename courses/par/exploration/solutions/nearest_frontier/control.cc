// Gathering data and driving.

#include "control.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace imr {

void CControl::updateMap() {
  const double mount = laser->GetPose().px;
  const double x = position.x + mount * std::cos(position.yaw);
  const double y = position.y + mount * std::sin(position.yaw);
  for (unsigned i = 0; i < laser->GetCount(); ++i) {
    const double range = laser->GetRange(i);
    const bool hit = range < laser->GetMaxRange();
    // Half a cell into what was hit: surfaces lie on the lines between cells, and noise of a
    // quarter of a cell must not move them to the cell before.
    const double length = hit ? range + map.getCellSize() / 2 : range;
    const double angle = position.yaw + laser->GetBearing(i);
    map.updateCells(map.getX(x), map.getY(y), map.getX(x + length * std::cos(angle)),
                    map.getY(y + length * std::sin(angle)),
                    hit ? range : std::numeric_limits<double>::infinity());
  }
}

// Turns on the spot towards a corner before it goes there, so that it never leaves the path: the
// path keeps clear of obstacles, and what lies beside it may not.
void CControl::followPath(double& v, double& w) {
  constexpr double near = 0.02;      // m
  constexpr double aside = 0.15;     // rad
  constexpr double fastest = 0.35;   // m/s
  constexpr double fastestTurn = 2;  // rad/s
  v = 0.0;
  w = 0.0;
  while (next < plan.path.size()) {
    const double dx = plan.path[next].x - position.x;
    const double dy = plan.path[next].y - position.y;
    const double distance = std::hypot(dx, dy);
    if (distance < near) {
      ++next;
      continue;
    }
    const double turn = std::remainder(std::atan2(dy, dx) - position.yaw, 2 * M_PI);
    // A tenth of a second until the next scan: neither farther nor round more than needed.
    w = std::clamp(5.0 * turn, -fastestTurn, fastestTurn);
    if (std::fabs(turn) < aside) v = std::min(fastest, 5.0 * distance);
    return;
  }
  // At the end of the path, the laser, which does not see what is behind, looks around.
  w = fastestTurn;
}

}  // namespace imr
