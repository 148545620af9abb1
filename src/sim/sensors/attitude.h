#pragma once

#include <string>

#include "scene/scenario.h"
#include "sim/component.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

/// MORSE's Attitude (specs: morse.md B.2): `rotation`, an object of yaw, pitch and roll in the
/// world, rad, and `angular_velocity` in the sensor's frame, rad/s. With UseAngleAgainstNorth yaw
/// is minus the compass heading: what it is clockwise from north, the other way round. 60 Hz.
class Attitude : public Sensor {
 public:
  Attitude(Robot& robot, const std::string& name, const scene::Scenario& scenario);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  std::string mode_ = "Automatic";  // ComputationMode
  SensorMotion motion_;
  bool against_north_ = false;  // UseAngleAgainstNorth
  scene::GeodesyDef geodesy_;
  Vec3 euler_;
  Vec3 angular_;
};

}  // namespace ccmorse::sim
