#include "sim/sensors/airspeed.h"

#include "sim/robots/robot.h"

namespace ccmorse::sim {

namespace {

constexpr double kAirDensity = 1.225;  // kg/m^3 (specs: morse.md B.2)

}  // namespace

Airspeed::Airspeed(Robot& robot, const std::string& name)
    : Sensor(robot, name, "Airspeed", 60.0), motion_(*this) {
  AddProperty("ComputationMode", mode_, SensorMotion::Modes());
}

void Airspeed::Sample(const Instant& now) {
  const SensorMotion::State& motion = motion_.Update(now, mode_);
  const double speed = mode_ == "Position" ? motion.velocity.x
                                           : RotateBack(motion.place.rotation, motion.velocity).x;
  pressure_ = 0.5 * kAirDensity * speed * speed;
  DataChanged(now.time);
}

void Airspeed::Reset() {
  Sensor::Reset();
  motion_.Reset();
  pressure_ = 0.0;
}

void Airspeed::AddToHash(StateHash& hash) const { hash.Add(pressure_); }

void Airspeed::AppendFields(std::string& out) const {
  AppendField(out, "diff_pressure", pressure_);
}

}  // namespace ccmorse::sim
