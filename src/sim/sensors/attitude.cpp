#include "sim/sensors/attitude.h"

#include "base/trig.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

Attitude::Attitude(Robot& robot, const std::string& name, const scene::Scenario& scenario)
    : Sensor(robot, name, "Attitude", 60.0),
      motion_(*this),
      geodesy_(scenario.geodesy.value_or(scene::GeodesyDef{})) {
  AddProperty("UseAngleAgainstNorth", against_north_);
  AddProperty("ComputationMode", mode_, SensorMotion::Modes());
}

void Attitude::Sample(const Instant& now) {
  const SensorMotion::State& motion = motion_.Update(now, mode_);
  euler_ = motion.place.euler;
  // Clockwise from north to the sensor it is angle_against_north - yaw.
  if (against_north_) {
    euler_.z = NormalizeAngle(euler_.z - Radians(geodesy_.angle_against_north));
  }
  angular_ = motion.angular_velocity;
  DataChanged(now.time);
}

void Attitude::Reset() {
  Sensor::Reset();
  motion_.Reset();
  euler_ = {};
  angular_ = {};
}

void Attitude::AddToHash(StateHash& hash) const {
  for (const Vec3& v : {euler_, angular_}) {
    hash.Add(v.x);
    hash.Add(v.y);
    hash.Add(v.z);
  }
}

void Attitude::AppendFields(std::string& out) const {
  out += ", \"rotation\": {\"yaw\": ";
  AppendJson(out, euler_.z);
  out += ", \"pitch\": ";
  AppendJson(out, euler_.y);
  out += ", \"roll\": ";
  AppendJson(out, euler_.x);
  out += '}';
  AppendField(out, "angular_velocity", angular_);
}

}  // namespace ccmorse::sim
