#pragma once

#include <string>

#include "sim/component.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

/// Puts its robot somewhere: MORSE's Teleport (specs: morse.md B.3). Data and stream: x, y, z in m,
/// yaw, pitch, roll in rad, of the actuator. In every tick the robot stands so that the actuator is
/// there: where it is at the start until told otherwise, so that nothing else moves the robot.
/// Robots stay upright on the floor: z, pitch and roll are only kept. Services translate(x, y, z)
/// and rotate(roll, pitch, yaw) add to them.
class Teleport : public Actuator {
 public:
  Teleport(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // the robot's pose counts
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;
  void SetTarget(const Vec3& position, const Vec3& euler);  // throws WrongArgument

  Vec3 position_;  // m
  Vec3 euler_;     // roll, pitch, yaw, rad
};

}  // namespace ccmorse::sim
