#pragma once

#include <string>

#include "sim/component.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

/// Drives in any direction: MORSE's MotionXYW (specs: morse.md B.3). Data and stream: x and y in
/// m/s, in the robot's frame, w in rad/s; a command holds until the next. A robot that cannot go
/// sideways does not. ControlType changes nothing: robots have the speed that they are told.
class MotionXYW : public Actuator {
 public:
  MotionXYW(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // the robot's speed counts
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  Twist speed_;
  std::string control_ = "Velocity";  // ControlType
};

}  // namespace ccmorse::sim
