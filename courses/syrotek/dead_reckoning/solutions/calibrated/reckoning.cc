// Dead reckoning by arcs, with factors from the laser.

#include "reckoning.h"

#include <cmath>
#include <limits>

namespace {

constexpr double FULL_TURN = 2 * 3.14159265358979323846;

// How different two scans are when beam i of the one is compared with i + shift of the other, with
// the beams between two taken on the line between them: the mean absolute difference, m.
double difference(const imr::SScan& one, const imr::SScan& other, double shift) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < one.ranges.size(); ++i) {
    const double at = static_cast<double>(i) + shift;
    const double low = std::floor(at);
    if (low < 0.0 || low + 1.0 >= static_cast<double>(other.ranges.size())) continue;
    const std::size_t k = static_cast<std::size_t>(low);
    const double range = other.ranges[k] + (at - low) * (other.ranges[k + 1] - other.ranges[k]);
    sum += std::fabs(range - one.ranges[i]);
    ++count;
  }
  return count == 0 ? std::numeric_limits<double>::infinity() : sum / count;
}

// The distance of what is straight ahead, m, as the middle of some beams: the wall is flat.
double ahead(const imr::SScan& scan) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (std::fabs(scan.bearing(i)) > 0.05) continue;
    sum += scan.ranges[i] * std::cos(scan.bearing(i));
    ++count;
  }
  return sum / count;
}

}  // namespace

void CReckoning::advance(const imr::SPose& last, const imr::SPose& now) {
  const double turn = turnFactor * std::remainder(now.yaw - last.yaw, FULL_TURN);
  // Forward in the odometry's frame is the chord's direction there.
  const double middle = last.yaw + std::remainder(now.yaw - last.yaw, FULL_TURN) / 2;
  const double way =
      wayFactor * ((now.x - last.x) * std::cos(middle) + (now.y - last.y) * std::sin(middle));
  pose.x += way * std::cos(pose.yaw + turn / 2);
  pose.y += way * std::sin(pose.yaw + turn / 2);
  pose.yaw = std::remainder(pose.yaw + turn, FULL_TURN);
}

void CReckoning::calibrateTurn(const imr::SScan& before, const imr::SScan& after, double counted) {
  // The robot turned on by `shift` beams more than once: what beam i saw, beam i - shift sees now.
  double best = 0.0;
  for (double shift = -100.0; shift <= 100.0; shift += 0.1) {
    if (difference(before, after, -shift) < difference(before, after, -best)) best = shift;
  }
  const double turned = FULL_TURN + best * before.resolution;
  // What has been turned already counts with the factor, too.
  pose.yaw = std::remainder(pose.yaw + turned - turnFactor * counted, FULL_TURN);
  turnFactor = turned / counted;
}

void CReckoning::calibrateWay(const imr::SScan& before, const imr::SScan& after, double counted) {
  const double went = ahead(before) - ahead(after);
  pose.x += (went - wayFactor * counted) * std::cos(pose.yaw);
  pose.y += (went - wayFactor * counted) * std::sin(pose.yaw);
  wayFactor = went / counted;
}
