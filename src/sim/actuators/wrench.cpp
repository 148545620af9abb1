#include "sim/actuators/wrench.h"

#include "sim/actuators/body_forces.h"

namespace ccmorse::sim {

Wrench::Wrench(Robot& robot, const std::string& name, const std::string& type)
    : Actuator(robot, name, type, 60.0) {
  NeedBody(*this);
}

void Wrench::Receive(const Json& message) {
  const Vec3 force = VectorMember(message, "force");
  torque_ = VectorMember(message, "torque");
  force_ = force;
  DataChanged(timestamp());
}

void Wrench::Reset() {
  Actuator::Reset();
  force_ = {};
  torque_ = {};
}

void Wrench::AppendFields(std::string& out) const {
  AppendField(out, "force", force_);
  AppendField(out, "torque", torque_);
}

}  // namespace ccmorse::sim
