#include "navigation/scan.h"

#include <algorithm>
#include <cmath>

#include "base/polygon.h"
#include "base/trig.h"

namespace ccmorse::navigation {

double CleanRange(double range, double range_max) {
  return range >= 0.0 && range < range_max ? range : range_max;
}

std::vector<Vec2> HitPoints(const ScanView& scan) {
  std::vector<Vec2> points;
  points.reserve(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = CleanRange(scan.ranges[i], scan.range_max);
    if (range >= scan.range_max) continue;
    const auto [sine, cosine] = SinCos(scan.min_angle + static_cast<double>(i) * scan.resolution);
    points.push_back(Transform(scan.mount, {range * cosine, range * sine}));
  }
  return points;
}

Scan CentreScan(const ScanView& scan) {
  const int count = std::max(1, static_cast<int>(std::lround(2.0 * kPi / scan.resolution)));
  const int ahead = count / 2;
  Scan centred{-ahead * scan.resolution, scan.resolution, scan.range_max,
               std::vector<double>(static_cast<std::size_t>(count), scan.range_max)};
  const auto put = [&](int sector, double distance) {
    double& range = centred.ranges[static_cast<std::size_t>(((sector % count) + count) % count)];
    range = std::min(range, distance);
  };
  int last_sector = 0;
  double last_distance = 0.0;
  bool last_hit = false;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = CleanRange(scan.ranges[i], scan.range_max);
    const bool hit = range < scan.range_max;
    if (hit) {
      const auto [sine, cosine] = SinCos(scan.min_angle + static_cast<double>(i) * scan.resolution);
      const Vec2 point = Transform(scan.mount, {range * cosine, range * sine});
      const double distance = std::sqrt(Dot(point, point));
      const int sector =
          static_cast<int>(std::lround(Atan2(point.y, point.x) / scan.resolution)) + ahead;
      put(sector, distance);
      if (last_hit) {
        int steps = (sector - last_sector) % count;
        if (steps > count / 2) steps -= count;
        if (steps < -count / 2) steps += count;
        const int direction = steps < 0 ? -1 : 1;
        for (int k = 1; k < std::abs(steps); ++k) {
          put(last_sector + direction * k, std::max(distance, last_distance));
        }
      }
      last_sector = sector;
      last_distance = distance;
    }
    last_hit = hit;
  }
  return centred;
}

}  // namespace ccmorse::navigation
