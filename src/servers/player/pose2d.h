#pragma once

#include <cmath>

#include "base/pose.h"
#include "wire/player/messages.h"

namespace ccmorse::servers::player {

namespace wire = ccmorse::wire::player;

// Poses in the plane, between Player's messages and ours; m, rad. Any thread.

inline bool IsFinite(const wire::Pose2d& pose) {
  return std::isfinite(pose.px) && std::isfinite(pose.py) && std::isfinite(pose.pa);
}

inline Pose2 ToPose(const wire::Pose2d& pose) { return {pose.px, pose.py, pose.pa}; }

inline wire::Pose2d ToWire(const Pose2& pose) { return {pose.x, pose.y, pose.yaw}; }

}  // namespace ccmorse::servers::player
