#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "imr-h/robot_program.h"

/// What both solutions know of their own size.
namespace intro {

/// As near as the robot's middle may come to anything, m: the S1R's corners are 0.098 m from it,
/// and ranges are not exact.
constexpr double CLEARANCE = 0.103;

/// How near it goes where it has the choice, m: doors are 0.28 m wide.
constexpr double COMFORT = 0.12;

constexpr double PI = 3.14159265358979323846;

/// Takes noise out of a scan: each range becomes the median of it and its neighbours.
inline void smooth(imr::SScan& scan) {
  double before = 0.0;
  for (std::size_t i = 1; i + 1 < scan.ranges.size(); ++i) {
    const double last = i == 1 ? scan.ranges[0] : before;
    before = scan.ranges[i];
    scan.ranges[i] =
        std::max(std::min(last, before), std::min(std::max(last, before), scan.ranges[i + 1]));
  }
}

/// How far a robot of that radius could go straight in a direction, m; 0 when it would touch at
/// once. The direction is a bearing, rad counter-clockwise from straight ahead.
inline double room(const imr::SScan& scan, double bearing, double radius = CLEARANCE) {
  const double c = std::cos(bearing);
  const double s = std::sin(bearing);
  double farthest = scan.maxRange;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (scan.ranges[i] >= scan.maxRange) continue;
    const imr::SPoint point = scan.point(i);
    const double along = c * point.x + s * point.y;
    const double across = c * point.y - s * point.x;
    if (along <= 0.0 || std::fabs(across) >= radius) continue;
    const double touch = along - std::sqrt(radius * radius - across * across);
    farthest = std::min(farthest, std::max(0.0, touch));
  }
  return farthest;
}

/// Where a point in the world is, as a bearing.
inline double bearingOf(const imr::SPose& pose, imr::SPoint point) {
  return std::remainder(std::atan2(point.y - pose.y, point.x - pose.x) - pose.yaw, 2 * PI);
}

/// m that have to be free in a direction to take it.
constexpr double AHEAD = 0.12;

/// Finds the bearing nearest to `wish` in which there is room; false when there is none near it.
inline bool freeBearing(const imr::SScan& scan, double wish, double& bearing) {
  for (double aside = 0.0; aside < 0.8; aside += 0.05) {
    for (const double candidate : {wish - aside, wish + aside}) {
      bearing = candidate;
      if (room(scan, bearing, COMFORT) >= AHEAD) return true;
    }
  }
  bearing = wish;
  return false;
}

/// The speed with as much less of v as it takes to touch nothing until the next scan but one.
inline imr::SSpeed careful(const imr::SScan& scan, imr::SSpeed speed) {
  const double ahead =
      std::min({room(scan, 0.0), room(scan, 0.1 * speed.w), room(scan, 0.2 * speed.w)});
  speed.v = std::clamp(speed.v, 0.0, ahead / 0.25);
  return speed;
}

}  // namespace intro
