// Of the directions in which there is room, takes the one nearest to the goal, and where the goal's
// own is blocked, prefers the right: two robots that meet then pass each other left to left.

#include <algorithm>
#include <cmath>

#include "swap.h"

namespace {

constexpr double TURN = 2 * 3.14159265358979323846;
constexpr double SPEED = 0.25;      // m/s
constexpr double AHEAD = 0.60;      // m that should be free, or as much as it is to the goal
constexpr double CLEARANCE = 0.17;  // m beside the robot's middle: 0.098 m and what the other moves
constexpr double LEFT_COSTS = 0.6;  // rad that a direction to the left counts more

class CPolite : public imr::CBehaviour {
 public:
  explicit CPolite(imr::SPoint to) : goal(to) {}

  imr::SSpeed step(const imr::SSenses& senses, imr::CSketch&) override {
    const double dx = goal.x - senses.pose.x;
    const double dy = goal.y - senses.pose.y;
    const double distance = std::hypot(dx, dy);
    arrived = distance < 0.03;
    const double wish = std::remainder(std::atan2(dy, dx) - senses.pose.yaw, TURN);
    double best = wish;
    double least = 100.0;
    for (double bearing = -2.0; bearing <= 2.0; bearing += 0.05) {
      if (room(senses.scan, bearing) < std::min(AHEAD, distance)) continue;
      const double aside = std::remainder(bearing - wish, TURN);
      const double cost = aside > 0.03 ? aside + LEFT_COSTS : std::fabs(aside);
      if (cost < least) {
        least = cost;
        best = bearing;
      }
    }
    if (least == 100.0) return {0.0, -1.0};  // no way: look to the right
    const double v = SPEED * std::max(0.0, std::cos(1.5 * std::clamp(best, -1.0, 1.0)));
    return {std::min({v, distance, room(senses.scan, 0.0)}), std::clamp(3.0 * best, -2.0, 2.0)};
  }
  bool done() const override { return arrived; }

 private:
  // How far the robot could go in a direction, m.
  static double room(const imr::SScan& scan, double bearing) {
    double farthest = scan.maxRange;
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const imr::SPoint point = scan.point(i);
      const double along = std::cos(bearing) * point.x + std::sin(bearing) * point.y;
      const double across = std::cos(bearing) * point.y - std::sin(bearing) * point.x;
      if (along > 0.0 && std::fabs(across) < CLEARANCE) {
        farthest = std::min(farthest, std::max(0.0, along - CLEARANCE));
      }
    }
    return farthest;
  }

  imr::SPoint goal;
  bool arrived = false;
};

}  // namespace

std::unique_ptr<imr::CBehaviour> makeBehaviour(imr::SPoint goal) {
  return std::make_unique<CPolite>(goal);
}
