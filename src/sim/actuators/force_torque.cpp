#include "sim/actuators/force_torque.h"

#include "sim/robots/robot.h"

namespace ccmorse::sim {

ForceTorque::ForceTorque(Robot& robot, const std::string& name)
    : Wrench(robot, name, "ForceTorque") {
  AddProperty("RobotFrame", robot_frame_);
}

void ForceTorque::Act(const Instant& now) {
  DataChanged(now.time);
  Vec3 force = Wrench::force();
  Vec3 torque = Wrench::torque();
  if (!robot_frame_) {
    force = Rotate(mount_rotation(), force);
    torque = Rotate(mount_rotation(), torque) + Cross(mount(), force);
  }
  robot().Push(Rotate(robot().rotation(), force), Rotate(robot().rotation(), torque));
}

}  // namespace ccmorse::sim
