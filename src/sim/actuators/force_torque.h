#pragma once

#include <string>

#include "sim/actuators/wrench.h"

namespace ccmorse::sim {

/// MORSE's ForceTorque (specs: morse.md B.3): pushes a dynamic robot every tick by `force` (N) and
/// `torque` (Nm), vectors in the actuator's frame, where it is mounted; with the property
/// RobotFrame in the robot's frame, at its origin. Each is a list of three numbers. 60 Hz.
class ForceTorque : public Wrench {
 public:
  ForceTorque(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;

 private:
  bool robot_frame_ = false;  // RobotFrame
};

}  // namespace ccmorse::sim
