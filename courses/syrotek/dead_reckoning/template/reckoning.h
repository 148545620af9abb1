#pragma once

#include "imr-h/robot_program.h"

/// Dead reckoning: what reckoning.cc is to write. The odometry counts wrong: every metre and every
/// radian by a factor that is another one in each run, between 0.95 and 1.05.
class CReckoning {
 public:
  /// Where the robot starts in the world.
  void begin(const imr::SPose& start) { pose = start; }

  /// The robot has turned on the spot to the left, by about one whole turn. `before` and `after`
  /// are scans before and after it, `counted` what the odometry says that it turned, rad.
  void calibrateTurn(const imr::SScan& before, const imr::SScan& after, double counted);

  /// The robot has gone straight ahead towards a wall. `before` and `after` are scans before and
  /// after it, `counted` what the odometry says that it went, m.
  void calibrateWay(const imr::SScan& before, const imr::SScan& after, double counted);

  /// The odometry went from `last` to `now`, poses in its own frame: moves `pose`.
  void advance(const imr::SPose& last, const imr::SPose& now);

  /// Where the robot is in the world, as far as it knows.
  const imr::SPose& getPose() const { return pose; }

 private:
  imr::SPose pose;
  // Both are for you to use.
  [[maybe_unused]] double wayFactor = 1.0;   // m driven for 1 m counted
  [[maybe_unused]] double turnFactor = 1.0;  // rad turned for 1 rad counted
};
