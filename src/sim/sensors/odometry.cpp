#include "sim/sensors/odometry.h"

namespace ccmorse::sim {

OdometrySensor::OdometrySensor(Robot& robot, const std::string& name)
    : Sensor(robot, name, "IntegratedOdometry", 60.0),
      start_(robot.pose()),
      start_angle_(SinCos(start_.yaw)) {}

void OdometrySensor::Sample(const Instant& now) {
  const Pose2& pose = robot().pose();
  const auto [s, c] = start_angle_;
  const Vec2 d{pose.x - start_.x, pose.y - start_.y};
  moved_ = {c * d.x + s * d.y, c * d.y - s * d.x, NormalizeAngle(pose.yaw - start_.yaw)};
  twist_ = robot().twist();
  stalled_ = robot().stalled();
  DataChanged(now.time);
}

void OdometrySensor::Reset() {
  Sensor::Reset();
  start_ = robot().pose();
  start_angle_ = SinCos(start_.yaw);
  moved_ = {};
  twist_ = {};
  stalled_ = false;
}

void OdometrySensor::AddToHash(StateHash& hash) const {
  hash.Add(moved_.x);
  hash.Add(moved_.y);
  hash.Add(moved_.yaw);
  hash.Add(twist_.v);
  hash.Add(twist_.w);
  hash.Add(static_cast<std::uint64_t>(stalled_));
}

void OdometrySensor::AppendNumbers(std::vector<double>& out) const {
  out.insert(out.end(), {moved_.x, moved_.y, 0.0, 0.0, 0.0, moved_.yaw});
  out.insert(out.end(), {twist_.v, 0.0, 0.0, 0.0, 0.0, twist_.w, stalled_ ? 1.0 : 0.0});
}

void OdometrySensor::AppendFields(std::string& out) const {
  AppendField(out, "x", moved_.x);
  AppendField(out, "y", moved_.y);
  AppendField(out, "z", 0.0);
  AppendField(out, "yaw", moved_.yaw);
  AppendField(out, "pitch", 0.0);
  AppendField(out, "roll", 0.0);
  AppendField(out, "vx", twist_.v);
  AppendField(out, "vy", 0.0);
  AppendField(out, "vz", 0.0);
  AppendField(out, "wz", twist_.w);
  AppendField(out, "wy", 0.0);
  AppendField(out, "wx", 0.0);
  AppendField(out, "stall", stalled_);
}

}  // namespace ccmorse::sim
