#include "sim/sensors/velocity.h"

#include "sim/robots/robot.h"

namespace ccmorse::sim {

namespace {}  // namespace

Velocity::Velocity(Robot& robot, const std::string& name)
    : Sensor(robot, name, "Velocity", 60.0), motion_(*this) {
  AddProperty("ComputationMode", mode_, SensorMotion::Modes());
}

void Velocity::Sample(const Instant& now) {
  const SensorMotion::State& motion = motion_.Update(now, mode_);
  linear_ = RotateBack(motion.place.rotation, motion.velocity);
  angular_ = motion.angular_velocity;
  world_ = motion.velocity;
  DataChanged(now.time);
}

void Velocity::Reset() {
  Sensor::Reset();
  motion_.Reset();
  linear_ = {};
  angular_ = {};
  world_ = {};
}

void Velocity::AddToHash(StateHash& hash) const {
  hash.Add(linear_);
  hash.Add(angular_);
  hash.Add(world_);
}

void Velocity::AppendFields(std::string& out) const {
  AppendField(out, "linear_velocity", linear_);
  AppendField(out, "angular_velocity", angular_);
  AppendField(out, "world_linear_velocity", world_);
}

}  // namespace ccmorse::sim
