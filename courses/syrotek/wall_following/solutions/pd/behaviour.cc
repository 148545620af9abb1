// A PD controller on the distance of the nearest point of the wall, with the angle of that point.

#include <algorithm>
#include <cmath>

#include "wall.h"

namespace {

constexpr double RIGHT = -1.5707963267948966;  // rad, where the wall should be
constexpr double SPEED = 0.2;                  // m/s
constexpr double P = 6.0;                      // rad/s for 1 m
constexpr double D = 1.0;                      // rad/s for 1 m/s
constexpr double ANGLE = 2.0;                  // rad/s for 1 rad

class CWallFollower : public imr::CBehaviour {
 public:
  imr::SSpeed step(const imr::SSenses& senses, imr::CSketch& sketch) override {
    const imr::SScan& scan = senses.scan;
    // Nearest to the robot's middle, which is not where the laser is.
    imr::SPoint point = {100.0, 0.0};
    for (std::size_t i = 2; i + 2 < scan.ranges.size() && scan.bearing(i) < 0.4; ++i) {
      // The mean of five beams: the smallest of many noisy ranges is smaller than the wall is near.
      imr::SPoint mean;
      for (std::size_t k = i - 2; k <= i + 2; ++k) {
        mean.x += scan.point(k).x / 5;
        mean.y += scan.point(k).y / 5;
      }
      if (std::hypot(mean.x, mean.y) < std::hypot(point.x, point.y)) point = mean;
    }
    const double distance = std::hypot(point.x, point.y);
    const double angle = std::atan2(point.y, point.x);

    const double yaw = senses.pose.yaw;
    sketch.clear(NEAREST);
    sketch.line(NEAREST, {senses.pose.x, senses.pose.y},
                {senses.pose.x + std::cos(yaw) * point.x - std::sin(yaw) * point.y,
                 senses.pose.y + std::sin(yaw) * point.x + std::cos(yaw) * point.y});

    const double error = WALL_DISTANCE - distance;  // positive: too near, turn left
    const double change = senses.since > 0.0 ? (error - last) / senses.since : 0.0;
    last = error;
    // Far from any wall only the way to it counts, and no wall is farther away than half a metre.
    const double w = P * std::clamp(error, -0.1, 0.1) + D * std::clamp(change, -0.2, 0.2) +
                     ANGLE * std::remainder(angle - RIGHT, 6.283185307179586);
    // A wall ahead: the turn begins so early that the middle keeps its distance.
    const double ahead = scan.nearestRange(-0.35, 0.35) + scan.mount;
    if (ahead < WALL_DISTANCE + 0.12) {
      return {ahead < WALL_DISTANCE ? 0.0 : 0.5 * SPEED, std::max(w, 1.2)};
    }
    return {SPEED, std::clamp(w, -1.5, 1.5)};
  }

 private:
  static constexpr imr::CSketch::SInk NEAREST = {"nearest", 255, 165, 0};
  double last = 0.0;  // the error, m
};

}  // namespace

std::unique_ptr<imr::CBehaviour> makeBehaviour() { return std::make_unique<CWallFollower>(); }
