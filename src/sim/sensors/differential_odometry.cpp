#include "sim/sensors/differential_odometry.h"

#include "base/trig.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

DifferentialOdometry::DifferentialOdometry(Robot& robot, const std::string& name)
    : Sensor(robot, name, "Odometry", 60.0) {
  AddData("dx", moved_.x);
  AddData("dy", moved_.y);
  AddData("dz", moved_.z);
  AddData("dyaw", turned_);
}

void DifferentialOdometry::Sample(const Instant& now) {
  const MountPlace here = PlaceOfMount(*this);
  moved_ = RotateBack(start_.rotation, here.position - last_);
  turned_ = NormalizeAngle(here.euler.z - last_yaw_);
  last_ = here.position;
  last_yaw_ = here.euler.z;
  DataChanged(now.time);
}

void DifferentialOdometry::Reset() {
  Sensor::Reset();
  start_ = PlaceOfMount(*this);
  last_ = start_.position;
  last_yaw_ = start_.euler.z;
  moved_ = {};
  turned_ = 0.0;
}

void DifferentialOdometry::AddToHash(StateHash& hash) const {
  hash.Add(moved_.x);
  hash.Add(moved_.y);
  hash.Add(moved_.z);
  hash.Add(turned_);
}

void DifferentialOdometry::AppendFields(std::string& out) const {
  AppendField(out, "dx", moved_.x);
  AppendField(out, "dy", moved_.y);
  AppendField(out, "dz", moved_.z);
  AppendField(out, "dyaw", turned_);
  AppendField(out, "dpitch", 0.0);
  AppendField(out, "droll", 0.0);
}

}  // namespace ccmorse::sim
