#pragma once

#include <cmath>
#include <memory>

#include "imr-h/robot_program.h"

/// Where the robot should be at a moment, and how fast it should go there.
struct SWanted {
  imr::SPose pose;
  double v = 0.0;  ///< m/s
  double w = 0.0;  ///< rad/s
};

/// The wanted trajectory: a lying eight around (1.62, 2.40), 1.8 m x 0.8 m, once in 60 s.
inline SWanted wantedAt(double seconds) {
  const double turn = 2 * 3.14159265358979323846 / 60.0;
  const double angle = turn * seconds;
  const double dx = 0.9 * turn * std::cos(angle);
  const double dy = 0.8 * turn * std::cos(2 * angle);
  const double ddx = -0.9 * turn * turn * std::sin(angle);
  const double ddy = -1.6 * turn * turn * std::sin(2 * angle);
  SWanted wanted;
  wanted.pose = {1.62 + 0.9 * std::sin(angle), 2.40 + 0.4 * std::sin(2 * angle),
                 std::atan2(dy, dx)};
  wanted.v = std::hypot(dx, dy);
  wanted.w = (dx * ddy - dy * ddx) / (dx * dx + dy * dy);
  return wanted;
}

/// What follow.cc is to write: the speed that brings the robot, which is at `pose`, back to the
/// trajectory and along it.
imr::SSpeed follow(const imr::SPose& pose, const SWanted& wanted);
