// Y. Kanayama et al., "A stable tracking control method for an autonomous mobile robot", ICRA 1990:
//   v = vr cos(et) + kx ex        w = wr + vr (ky ey + kt sin(et))

#include "trajectory.h"

imr::SSpeed follow(const imr::SPose& pose, const SWanted& wanted) {
  constexpr double kx = 1.5;   // 1/s
  constexpr double ky = 40.0;  // 1/m^2
  constexpr double kt = 12.0;  // 1/m: critically damped, kt^2 = 4 ky, but for the samples' delay
  const double dx = wanted.pose.x - pose.x;
  const double dy = wanted.pose.y - pose.y;
  const double ex = std::cos(pose.yaw) * dx + std::sin(pose.yaw) * dy;
  const double ey = std::cos(pose.yaw) * dy - std::sin(pose.yaw) * dx;
  const double et = wanted.pose.yaw - pose.yaw;
  return {wanted.v * std::cos(et) + kx * ex, wanted.w + wanted.v * (ky * ey + kt * std::sin(et))};
}
