#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "imr-h/robot_program.h"

/// What both solutions know of their own size.
namespace intro {

/// As near as the robot's middle may come to anything, m: the S1R's corners are 0.098 m from it,
/// and ranges are not exact.
constexpr double CLEARANCE = 0.108;

constexpr double PI = 3.14159265358979323846;

/// How far a robot of the radius CLEARANCE could go straight in a direction, m; 0 when it would
/// touch at once. The direction is a bearing, rad counter-clockwise from straight ahead.
inline double room(const imr::SScan& scan, double bearing) {
  const double c = std::cos(bearing);
  const double s = std::sin(bearing);
  double farthest = scan.maxRange;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (scan.ranges[i] >= scan.maxRange) continue;
    const imr::SPoint point = scan.point(i);
    const double along = c * point.x + s * point.y;
    const double across = c * point.y - s * point.x;
    if (along <= 0.0 || std::fabs(across) >= CLEARANCE) continue;
    const double touch = along - std::sqrt(CLEARANCE * CLEARANCE - across * across);
    farthest = std::min(farthest, std::max(0.0, touch));
  }
  return farthest;
}

/// The speed with as much less of v as it takes to touch nothing until the next scan but one.
inline imr::SSpeed careful(const imr::SScan& scan, imr::SSpeed speed) {
  const double ahead = std::min({room(scan, 0.0), room(scan, 0.1 * speed.w),
                                 room(scan, 0.2 * speed.w)});
  speed.v = std::clamp(speed.v, 0.0, ahead / 0.25);
  return speed;
}

}  // namespace intro
