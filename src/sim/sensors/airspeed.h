#pragma once

#include <string>

#include "sim/component.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

/// MORSE's Airspeed (specs: morse.md B.2): `diff_pressure`, Pa, of air of 1.225 kg/m^3 at the speed
/// along the sensor's x, or along the world's in mode Position. There is no wind. 60 Hz.
class Airspeed : public Sensor {
 public:
  Airspeed(Robot& robot, const std::string& name);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  std::string mode_ = "Automatic";  // ComputationMode
  SensorMotion motion_;
  double pressure_ = 0.0;  // Pa
};

}  // namespace ccmorse::sim
