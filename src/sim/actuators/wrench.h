#pragma once

#include <string>

#include "sim/component.h"

namespace ccmorse::sim {

/// An actuator that is told a force and a torque and keeps pushing by them, each a list of three
/// numbers: `force` (N) and `torque` (Nm). In which frame they are says Act(). Throws Error unless
/// its robot is dynamic.
class Wrench : public Actuator {
 public:
  Wrench(Robot& robot, const std::string& name, const std::string& type);
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // what becomes of the robot counts
  void Reset() override;

 protected:
  const Vec3& force() const { return force_; }
  const Vec3& torque() const { return torque_; }

 private:
  void AppendFields(std::string& out) const override;

  Vec3 force_;
  Vec3 torque_;
};

}  // namespace ccmorse::sim
