#include "sim/sensors/pose.h"

#include "sim/robots/robot.h"

namespace ccmorse::sim {

PoseSensor::PoseSensor(Robot& robot, const std::string& name) : Sensor(robot, name, "Pose", 60.0) {
  Read();
}

void PoseSensor::Read() {
  pose_ = robot().pose();
  z_ = robot().position().z;
}

void PoseSensor::Sample(const Instant& now) {
  Read();
  DataChanged(now.time);
}

void PoseSensor::Reset() {
  Sensor::Reset();
  Read();
}

void PoseSensor::AddToHash(StateHash& hash) const {
  hash.Add(pose_.x);
  hash.Add(pose_.y);
  hash.Add(pose_.yaw);
}

void PoseSensor::AppendNumbers(std::vector<double>& out) const {
  out.insert(out.end(), {pose_.x, pose_.y, z_, 0.0, 0.0, pose_.yaw});
}

void PoseSensor::AppendFields(std::string& out) const {
  AppendField(out, "x", pose_.x);
  AppendField(out, "y", pose_.y);
  AppendField(out, "z", z_);
  AppendField(out, "yaw", pose_.yaw);
  AppendField(out, "pitch", 0.0);
  AppendField(out, "roll", 0.0);
}

}  // namespace ccmorse::sim
