#include "sim/actuators/force_torque.h"

#include "sim/actuators/body_forces.h"

namespace ccmorse::sim {

ForceTorque::ForceTorque(Robot& robot, const std::string& name)
    : Actuator(robot, name, "ForceTorque", 60.0) {
  NeedBody(*this);
  AddProperty("RobotFrame", robot_frame_);
}

void ForceTorque::Receive(const Json& message) {
  const Vec3 force = VectorMember(message, "force");
  torque_ = VectorMember(message, "torque");
  force_ = force;
  DataChanged(timestamp());
}

void ForceTorque::Act(const Instant& now) {
  DataChanged(now.time);
  Vec3 force = force_;
  Vec3 torque = torque_;
  if (!robot_frame_) {
    force = Rotate(mount_rotation(), force);
    torque = Rotate(mount_rotation(), torque) + Cross(mount(), force);
  }
  robot().Push(Rotate(robot().rotation(), force), Rotate(robot().rotation(), torque));
}

void ForceTorque::Reset() {
  Actuator::Reset();
  force_ = {};
  torque_ = {};
}

void ForceTorque::AppendFields(std::string& out) const {
  AppendField(out, "force", force_);
  AppendField(out, "torque", torque_);
}

}  // namespace ccmorse::sim
