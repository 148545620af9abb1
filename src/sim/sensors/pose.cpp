#include "sim/sensors/pose.h"

#include <array>

#include "base/trig.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

PoseSensor::PoseSensor(Robot& robot, const std::string& name, std::uint64_t seed)
    : Sensor(robot, name, "Pose", 60.0), noise_(seed, full_name()) {
  Read();
}

void PoseSensor::Read() {
  pose_ = robot().pose();
  z_ = robot().position().z;
}

void PoseSensor::Sample(const Instant& now) {
  Read();
  const scene::PoseNoiseDef& noise = robot().def().pose_noise;
  if (noise.pos_std > 0.0) {
    std::array<double, 2> off{};
    noise_.AddGaussian(now.tick, noise.pos_std, off.data(), off.size());
    pose_.x += off[0];
    pose_.y += off[1];
  }
  if (noise.rot_std > 0.0) {
    double off = 0.0;
    noise_.AddGaussian(now.tick, noise.rot_std, &off, 1, 2);
    pose_.yaw = NormalizeAngle(pose_.yaw + off);
  }
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
