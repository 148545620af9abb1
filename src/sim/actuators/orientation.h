#pragma once

#include <limits>
#include <string>

#include "sim/component.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

/// Turns its robot: MORSE's Orientation (specs: morse.md B.3). Data and stream: yaw, pitch and
/// roll, rad. With the delivered speed, infinity, the robot has this yaw in every tick; with a
/// finite one, rad/s, it turns there, until yaw is within `tolerance`, rad. Robots stay upright:
/// pitch and roll are only kept.
class Orientation : public Actuator {
 public:
  Orientation(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // the robot's pose counts
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  Vec3 target_;                                             // roll, pitch, yaw
  double speed_ = std::numeric_limits<double>::infinity();  // rad/s
  double tolerance_ = 0.02;                                 // rad
  std::string control_ = "Velocity";                        // ControlType: of no effect
};

}  // namespace ccmorse::sim
