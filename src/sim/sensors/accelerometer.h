#pragma once

#include <string>

#include "sim/component.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

/// MORSE's Accelerometer (specs: morse.md B.2): `distance` since the last activation, m;
/// `velocity`, m/s, and `acceleration`, m/s^2, in the sensor's frame, without gravity. 60 Hz.
class Accelerometer : public Sensor {
 public:
  Accelerometer(Robot& robot, const std::string& name);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  std::string mode_ = "Automatic";  // ComputationMode
  SensorMotion motion_;
  double distance_ = 0.0;  // m
  Vec3 velocity_;
  Vec3 acceleration_;
};

}  // namespace ccmorse::sim
