#include "sim/actuators/external_force.h"

#include "sim/actuators/body_forces.h"

namespace ccmorse::sim {

ExternalForce::ExternalForce(Robot& robot, const std::string& name)
    : Actuator(robot, name, "ExternalForce", 60.0) {
  NeedBody(*this);
}

void ExternalForce::Receive(const Json& message) {
  const Vec3 force = VectorMember(message, "force");
  torque_ = VectorMember(message, "torque");
  force_ = force;
  DataChanged(timestamp());
}

void ExternalForce::Act(const Instant& now) {
  DataChanged(now.time);
  robot().Push(force_, torque_);
}

void ExternalForce::Reset() {
  Actuator::Reset();
  force_ = {};
  torque_ = {};
}

void ExternalForce::AppendFields(std::string& out) const {
  AppendField(out, "force", force_);
  AppendField(out, "torque", torque_);
}

}  // namespace ccmorse::sim
