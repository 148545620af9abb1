#pragma once

#include <string>

#include "sim/component.h"

namespace ccmorse::sim {

/// MORSE's ExternalForce (specs: morse.md B.3), wind or a current, say: pushes a dynamic robot
/// every tick by `force` (N) through its origin and `torque` (Nm), lists of three numbers in the
/// world's frame. 60 Hz.
class ExternalForce : public Actuator {
 public:
  ExternalForce(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // what becomes of the robot counts
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  Vec3 force_;
  Vec3 torque_;
};

}  // namespace ccmorse::sim
