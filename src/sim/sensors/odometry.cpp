#include "sim/sensors/odometry.h"

#include <array>

#include "base/polygon.h"
#include "sim/noise.h"

namespace ccmorse::sim {

namespace {

// The place that the numbers of a pose count from, so that `pose` is `reported` there.
Pose2 FrameOf(const Pose2& pose, const Pose2& reported) {
  if (reported.x == 0.0 && reported.y == 0.0 && reported.yaw == 0.0) return pose;
  const double yaw = NormalizeAngle(pose.yaw - reported.yaw);
  const Vec2 origin = Transform({pose.x, pose.y, yaw}, {-reported.x, -reported.y});
  return {origin.x, origin.y, yaw};
}

}  // namespace

OdometrySensor::OdometrySensor(Robot& robot, const std::string& name, std::uint64_t seed)
    : Sensor(robot, name, "IntegratedOdometry", 60.0),
      exact_(true),
      gain_{1.0, 1.0, 1.0},
      last_(robot.pose()),
      start_(FrameOf(robot.pose(), robot.def().odometry.start)),
      start_angle_(SinCos(start_.yaw)),
      moved_(robot.def().odometry.start) {
  const Vec3& error = robot.def().odometry.error;
  exact_ = error.x == 0.0 && error.y == 0.0 && error.z == 0.0;
  const std::array<double, 3> share = Noise(seed, full_name()).Shares();
  gain_.x += error.x * (share[0] - 0.5);
  gain_.y += error.y * (share[1] - 0.5);
  gain_.z += error.z * (share[2] - 0.5);
  shown_ = moved_;
  AddData("x", shown_.x);
  AddData("y", shown_.y);
  AddData("z", rest_.x);
  AddData("yaw", shown_.yaw);
  AddData("pitch", rest_.y);
  AddData("roll", rest_.z);
  AddData("vx", twist_.v);
  AddData("vy", twist_.side);
  AddData("wz", twist_.w);
}

void OdometrySensor::DeadReckon() {
  const Pose2& pose = robot().pose();
  const auto [s, c] = SinCos(last_.yaw);
  const Vec2 d{pose.x - last_.x, pose.y - last_.y};
  const Vec2 counted{gain_.x * (c * d.x + s * d.y), gain_.y * (c * d.y - s * d.x)};
  const Vec2 at = Transform(moved_, counted);
  const double turned = gain_.z * NormalizeAngle(pose.yaw - last_.yaw);
  moved_ = {at.x, at.y, NormalizeAngle(moved_.yaw + turned)};
  last_ = pose;
}

void OdometrySensor::Sample(const Instant& now) {
  if (exact_) {
    const Pose2& pose = robot().pose();
    const auto [s, c] = start_angle_;
    const Vec2 d{pose.x - start_.x, pose.y - start_.y};
    moved_ = {c * d.x + s * d.y, c * d.y - s * d.x, NormalizeAngle(pose.yaw - start_.yaw)};
  } else {
    DeadReckon();
  }
  shown_ = moved_;
  rest_ = {};
  // Speeds are what it counts a second, with the same errors.
  twist_ = robot().twist();
  twist_ = {gain_.x * twist_.v, gain_.z * twist_.w, gain_.y * twist_.side};
  stalled_ = robot().stalled();
  DataChanged(now.time);
}

void OdometrySensor::Reset() {
  Sensor::Reset();
  last_ = robot().pose();
  start_ = FrameOf(last_, robot().def().odometry.start);
  start_angle_ = SinCos(start_.yaw);
  moved_ = shown_ = robot().def().odometry.start;
  rest_ = {};
  twist_ = {};
  stalled_ = false;
}

void OdometrySensor::AddToHash(StateHash& hash) const {
  hash.Add(shown_.x);
  hash.Add(shown_.y);
  hash.Add(shown_.yaw);
  hash.Add(twist_.v);
  hash.Add(twist_.w);
  hash.Add(static_cast<std::uint64_t>(stalled_));
}

void OdometrySensor::AppendNumbers(std::vector<double>& out) const {
  out.insert(out.end(), {shown_.x, shown_.y, rest_.x, rest_.z, rest_.y, shown_.yaw});
  out.insert(out.end(), {twist_.v, twist_.side, 0.0, 0.0, 0.0, twist_.w, stalled_ ? 1.0 : 0.0});
}

void OdometrySensor::AppendFields(std::string& out) const {
  AppendField(out, "x", shown_.x);
  AppendField(out, "y", shown_.y);
  AppendField(out, "z", rest_.x);
  AppendField(out, "yaw", shown_.yaw);
  AppendField(out, "pitch", rest_.y);
  AppendField(out, "roll", rest_.z);
  AppendField(out, "vx", twist_.v);
  AppendField(out, "vy", twist_.side);
  AppendField(out, "vz", 0.0);
  AppendField(out, "wz", twist_.w);
  AppendField(out, "wy", 0.0);
  AppendField(out, "wx", 0.0);
  AppendField(out, "stall", stalled_);
}

}  // namespace ccmorse::sim
