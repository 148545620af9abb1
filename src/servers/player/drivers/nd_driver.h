#pragma once

#include "navigation/nd.h"
#include "servers/player/drivers/goal_driver.h"

namespace ccmorse::servers::player {

/// Player's "nd": nearness diagram navigation (specs: player.md G.3), a GoalDriver with a laser, a
/// sonar or both. Options: goal_tol, max_speed and min_speed, tuples of a length and an angle, and
/// those of navigation::NdOptions, lengths and angles in the file's units (degrees unless it says
/// otherwise); sonar_buffer (20): for how many of its readings hits of the sonar are remembered, at
/// least laser_buffer where there is a laser; sonar_bad_transducers (none): a list of sonars, from
/// 0, that do not count; robot_radius (m; by default from the size of the output); sonar_max_range
/// (m, 5: a sonar does not tell).
class NdDriver : public GoalDriver {
 public:
  NdDriver(const DriverDef& def, const DeviceContext& context, const DeviceList& devices);

 protected:
  void SetGoal(const Pose2& goal) override { nd_.SetGoal(goal); }
  void ClearGoal() override { nd_.ClearGoal(); }
  bool HasGoal() const override { return nd_.goal().has_value(); }
  navigation::Drive Decide(const navigation::RobotState& state) override {
    return nd_.Step(state, Hits());
  }

 private:
  navigation::NdOptions ReadOptions(const DriverOptions& options);

  navigation::Nd nd_;
};

}  // namespace ccmorse::servers::player
