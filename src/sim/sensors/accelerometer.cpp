#include "sim/sensors/accelerometer.h"

#include "sim/robots/robot.h"

namespace ccmorse::sim {

namespace {}  // namespace

Accelerometer::Accelerometer(Robot& robot, const std::string& name)
    : Sensor(robot, name, "Accelerometer", 60.0), motion_(*this) {
  AddProperty("ComputationMode", mode_, SensorMotion::Modes());
}

void Accelerometer::Sample(const Instant& now) {
  const SensorMotion::State& motion = motion_.Update(now, mode_);
  const Rotation& sensor = motion.place.rotation;
  distance_ = motion.distance;
  velocity_ = RotateBack(sensor, motion.velocity);
  acceleration_ = RotateBack(sensor, motion.acceleration) + motion.lever_acceleration;
  DataChanged(now.time);
}

void Accelerometer::Reset() {
  Sensor::Reset();
  motion_.Reset();
  distance_ = 0.0;
  velocity_ = {};
  acceleration_ = {};
}

void Accelerometer::AddToHash(StateHash& hash) const {
  hash.Add(distance_);
  hash.Add(velocity_);
  hash.Add(acceleration_);
}

void Accelerometer::AppendFields(std::string& out) const {
  AppendField(out, "distance", distance_);
  AppendField(out, "velocity", velocity_);
  AppendField(out, "acceleration", acceleration_);
}

}  // namespace ccmorse::sim
