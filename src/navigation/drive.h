#pragma once

#include "base/pose.h"

namespace ccmorse::navigation {

/// What the algorithms that look at more than a scan want to know of the robot.
struct RobotState {
  Pose2 pose;              ///< m and rad, in the frame of the goal
  double speed = 0.0;      ///< m/s, forward
  double turn_rate = 0.0;  ///< rad/s, counter-clockwise
  bool stalled = false;    ///< it pushes against something
  double time = 0.0;       ///< s; never goes back
};

/// What a step of an algorithm wants the robot to do until the next one.
struct Drive {
  double speed = 0.0;      ///< m/s, forward
  double turn_rate = 0.0;  ///< rad/s, counter-clockwise
  bool at_goal = false;    ///< within both tolerances of the goal: done until the next goal
  bool stalled = false;    ///< has a goal and cannot go on: too near to something, or no way out
};

}  // namespace ccmorse::navigation
