#pragma once

#include <string>

#include "sim/component.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

/// MORSE's Barometer (specs: morse.md B.2): `pressure`, Pa, at the sensor, by the standard
/// atmosphere from ReferencePressure at its height at the start. 60 Hz.
class Barometer : public Sensor {
 public:
  Barometer(Robot& robot, const std::string& name);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  double reference_ = 101325.0;  // ReferencePressure, Pa
  double start_ = 0.0;           // m, its z then
  double pressure_ = 0.0;        // Pa
};

}  // namespace ccmorse::sim
