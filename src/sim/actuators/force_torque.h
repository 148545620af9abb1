#pragma once

#include <string>

#include "sim/component.h"

namespace ccmorse::sim {

/// MORSE's ForceTorque (specs: morse.md B.3): pushes a dynamic robot every tick by `force` (N) and
/// `torque` (Nm), vectors in the actuator's frame, where it is mounted; with the property
/// RobotFrame in the robot's frame, at its origin. Each is a list of three numbers. 60 Hz.
class ForceTorque : public Actuator {
 public:
  ForceTorque(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // what becomes of the robot counts
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  Vec3 force_;
  Vec3 torque_;
  bool robot_frame_ = false;  // RobotFrame
};

}  // namespace ccmorse::sim
