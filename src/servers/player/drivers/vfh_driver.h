#pragma once

#include "navigation/vfh.h"
#include "servers/player/drivers/goal_driver.h"

namespace ccmorse::servers::player {

/// Player's "vfh": vector field histogram plus (specs: player.md G.2), a GoalDriver with exactly
/// one laser, sonar or ranger. Options: those of navigation::VfhOptions, lengths and angles in the
/// file's units (degrees unless it says otherwise); robot_radius (m; by default from the size of
/// the output); sonar_max_range (m, 5: a sonar does not tell). `synchronous` has no effect: it
/// always steps with the scan.
class VfhDriver : public GoalDriver {
 public:
  VfhDriver(const DriverDef& def, const DeviceContext& context, const DeviceList& devices);

 protected:
  void SetGoal(const Pose2& goal) override { vfh_.SetGoal(goal); }
  void ClearGoal() override { vfh_.ClearGoal(); }
  bool HasGoal() const override { return vfh_.goal().has_value(); }
  navigation::Drive Decide(const navigation::RobotState& state) override {
    return vfh_.Step(state, Hits());
  }

 private:
  navigation::VfhOptions ReadOptions(const DriverOptions& options);

  navigation::Vfh vfh_;
};

}  // namespace ccmorse::servers::player
