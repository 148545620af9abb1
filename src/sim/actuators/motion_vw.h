#pragma once

#include "sim/component.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

/// Drives by forward speed and turn rate: MORSE's MotionVW (specs: morse.md B.3). Data and stream:
/// v in m/s, w in rad/s; a command holds until the next. Services set_speed(v, w) and stop().
/// Speeds beyond the robot's limits are clamped; NaN and infinity are refused. Where the robot is
/// omnidirectional, both take a third number, side, m/s to the left, 0 where it is left out.
class MotionVW : public Actuator {
 public:
  MotionVW(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // the robot's speed counts
  void Reset() override;

  /// The command, as from a client. Precondition: finite.
  void SetSpeed(const Twist& speed);

 private:
  void AppendFields(std::string& out) const override;

  Twist speed_;
  std::string control_ = "Velocity";  // ControlType: of no effect
};

}  // namespace ccmorse::sim
