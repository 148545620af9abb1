#pragma once

#include <string>

#include "sim/component.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

/// MORSE's Velocity (specs: morse.md B.2): `linear_velocity`, m/s, and `angular_velocity`, rad/s,
/// in the sensor's frame; `world_linear_velocity`, m/s, in the world's. In mode Position they are
/// differences, with the sign that MORSE's later versions have (1.4 had it wrong). 60 Hz.
class Velocity : public Sensor {
 public:
  Velocity(Robot& robot, const std::string& name);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  std::string mode_ = "Automatic";  // ComputationMode
  SensorMotion motion_;
  Vec3 linear_;
  Vec3 angular_;
  Vec3 world_;
};

}  // namespace ccmorse::sim
