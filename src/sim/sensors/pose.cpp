#include "sim/sensors/pose.h"

#include <array>

#include "base/polygon.h"
#include "base/trig.h"
#include "sim/robots/robot.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

PoseSensor::PoseSensor(Robot& robot, const std::string& name, std::uint64_t seed)
    : PoseSensor(robot, name, seed, robot.def().pose_noise) {}

PoseSensor::PoseSensor(Robot& robot, const std::string& name, std::uint64_t seed,
                       const scene::PoseNoiseDef& noise)
    : Sensor(robot, name, "Pose", 60.0), noise_(seed, full_name()), deviation_(noise) {
  AddData("x", pose_.x);
  AddData("y", pose_.y);
  AddData("z", z_);
  AddData("yaw", pose_.yaw);
  AddData("pitch", pitch_);
  AddData("roll", roll_);
  Read();
}

void PoseSensor::Read() {
  roll_ = mount_euler().x;
  pitch_ = mount_euler().y;
  if (robot().tilted()) {
    const MountPlace place = PlaceOfMount(*this);
    pose_ = {place.position.x, place.position.y, place.euler.z};
    z_ = place.position.z;
    roll_ = place.euler.x;
    pitch_ = place.euler.y;
    return;
  }
  pose_ = robot().pose();
  z_ = robot().position().z;
  const Vec3 at = mount();
  // Rz(robot) Rz Ry Rx of the mount: its yaw is added, roll and pitch are the mount's own.
  if (at.x != 0.0 || at.y != 0.0) {
    const Vec2 place = Transform(pose_, {at.x, at.y});
    pose_.x = place.x;
    pose_.y = place.y;
  }
  z_ += at.z;
  const Vec3 euler = mount_euler();
  if (euler.z != 0.0) pose_.yaw = NormalizeAngle(pose_.yaw + euler.z);
  pitch_ = euler.y;
  roll_ = euler.x;
}

void PoseSensor::Sample(const Instant& now) {
  Read();
  const scene::PoseNoiseDef& noise = deviation_;
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
  if (!robot().dynamic()) return;  // of others the rest does not change
  hash.Add(z_);
  hash.Add(roll_);
  hash.Add(pitch_);
}

void PoseSensor::AppendNumbers(std::vector<double>& out) const {
  out.insert(out.end(), {pose_.x, pose_.y, z_, roll_, pitch_, pose_.yaw});
}

void PoseSensor::AppendFields(std::string& out) const {
  AppendField(out, "x", pose_.x);
  AppendField(out, "y", pose_.y);
  AppendField(out, "z", z_);
  AppendField(out, "yaw", pose_.yaw);
  AppendField(out, "pitch", pitch_);
  AppendField(out, "roll", roll_);
}

}  // namespace ccmorse::sim
