#include "sim/sensors/imu.h"

#include "sim/robots/robot.h"

namespace ccmorse::sim {
namespace {

constexpr double kMorseGravity = 9.81;  // m/s^2, whatever the scene's is, as in MORSE

Vec3 AsVector(const std::array<double, 3>& parts) { return {parts[0], parts[1], parts[2]}; }

}  // namespace

Imu::Imu(Robot& robot, const std::string& name, const scene::Scenario& scenario)
    : Sensor(robot, name, "IMU", 60.0), motion_(*this) {
  if (scenario.geodesy) felt_.emplace(*this, scenario);
  AddProperty("ComputationMode", mode_, SensorMotion::Modes());
  AddData("angular_velocity", angular_velocity_);
  AddData("linear_acceleration", acceleration_);
  AddData("magnetic_field", magnetic_field_);
}

void Imu::Sample(const Instant& now) {
  const SensorMotion::State& motion = motion_.Update(now, mode_);
  const Vec3& turning = motion.angular_velocity;
  const Vec3 felt =
      RotateBack(motion.place.rotation, motion.acceleration + Vec3{0, 0, kMorseGravity}) +
      motion.lever_acceleration;
  const Vec3 field = felt_ ? felt_->Now({}) : Vec3{};
  angular_velocity_ = {turning.x, turning.y, turning.z};
  acceleration_ = {felt.x, felt.y, felt.z};
  magnetic_field_ = {field.x, field.y, field.z};
  DataChanged(now.time);
}

void Imu::Reset() {
  Sensor::Reset();
  motion_.Reset();
  angular_velocity_ = acceleration_ = magnetic_field_ = {};
}

void Imu::AddToHash(StateHash& hash) const {
  for (const auto& parts : {angular_velocity_, acceleration_, magnetic_field_}) {
    for (const double part : parts) hash.Add(part);
  }
}

void Imu::AppendFields(std::string& out) const {
  AppendField(out, "angular_velocity", AsVector(angular_velocity_));
  AppendField(out, "linear_acceleration", AsVector(acceleration_));
  AppendField(out, "magnetic_field", AsVector(magnetic_field_));
}

}  // namespace ccmorse::sim
