#pragma once

#include <string>

#include "sim/actuators/wrench.h"

namespace ccmorse::sim {

/// MORSE's ExternalForce (specs: morse.md B.3), wind or a current, say: pushes a dynamic robot
/// every tick by `force` (N) through its origin and `torque` (Nm), lists of three numbers in the
/// world's frame. 60 Hz.
class ExternalForce : public Wrench {
 public:
  ExternalForce(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
};

}  // namespace ccmorse::sim
