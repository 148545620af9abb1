#pragma once

#include <cstdint>
#include <string>

#include "libCCMorse/MorseProxy.h"
#include "libCCMorse/PlayerClient.h"
#include "libCCMorse/Types.h"
#include "libplayerc++/motion.h"
#include "libplayerc++/operators.h"

namespace CCMorse {

/// A robot that moves in the plane (thesis 3.1.3): Player's Position2dProxy. Of a simulated robot
/// it joins the pose sensor, the odometry and the motion actuator; the index decides where
/// positions come from: the robot's configuration says which index means the pose in the world and
/// which the odometry (thesis 3.2). Commands leave with the next Read() and are ignored while the
/// motors are off, which stops the robot at once. A robot with two wheels drops speeds to the side.
/// GoTo() goes in a straight line, by the waypoint actuator, and does not control the heading at
/// the goal. SetOdometry() moves the frame of positions; without data yet, it holds for the first
/// ones. A number that is not finite, and what the robot cannot do, is a MorseError. Owned by the
/// program. Any thread.
class Position2dProxy : public PlayerCc::Position2dProxy {
 public:
  /// `robot`: name of the simulated robot; empty takes the first that has this index. Throws
  /// MorseError that lists the indexes when there is none.
  explicit Position2dProxy(PlayerClient* client, std::uint32_t index = 0,
                           const std::string& robot = "");
  ~Position2dProxy() override;

  /// Position and heading in one consistent copy, m and rad.
  player_pose2d_t GetPose() const;
};

}  // namespace CCMorse
