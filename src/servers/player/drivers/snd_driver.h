#pragma once

#include "navigation/snd.h"
#include "servers/player/drivers/goal_driver.h"

namespace ccmorse::servers::player {

/// Player's "snd": smooth nearness diagram navigation (specs: player.md G.1), a GoalDriver with a
/// laser. Options: those of navigation::SndOptions, lengths and angles in the file's units (degrees
/// unless it says otherwise).
class SndDriver : public GoalDriver {
 public:
  SndDriver(const DriverDef& def, const DeviceContext& context, const DeviceList& devices);

 protected:
  void SetGoal(const Pose2& goal) override { snd_.SetGoal(goal); }
  void ClearGoal() override { snd_.ClearGoal(); }
  bool HasGoal() const override { return snd_.goal().has_value(); }
  navigation::Drive Decide(const navigation::RobotState& state) override;

 private:
  navigation::Snd snd_;
};

/// The goal driver that SyRoTek's robots have as position2d:1 (specs: syrotek.md A), with settings
/// for the S1R; `settings`, the scenario's robots[].drivers.snd, overrules them: by name, m and
/// degrees.
DriverDef SyrotekSnd(const Json::Object& settings);

}  // namespace ccmorse::servers::player
