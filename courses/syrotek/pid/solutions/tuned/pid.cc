// Gains found as the README tells: P until it swings, D until it does not, I until nothing remains.

#include "pid.h"

#include <algorithm>

double CPid::control(double error, double dt) {
  constexpr double P = 6.0;
  constexpr double I = 1.5;
  constexpr double D = 8.0;
  constexpr double MOST = 0.15;  // m s: as much as I needs against the pull, and not much more
  const double change = dt > 0.0 ? (error - last) / dt : 0.0;
  last = error;
  // A step of the line is no change of the robot's.
  const double calm = std::clamp(change, -0.15, 0.15);
  sum = std::clamp(sum + error * dt, -MOST, MOST);
  return P * std::clamp(error, -0.12, 0.12) + I * sum + D * calm;
}
