#pragma once

#include <string>

#include "sim/component.h"
#include "sim/world.h"

namespace ccmorse::sim {

/// MORSE's RadarAltimeter (specs: morse.md B.2): `z`, m, from the sensor straight down to what is
/// there, its own robot aside; Infinity beyond MaxRange. 60 Hz.
class RadarAltimeter : public Sensor {
 public:
  RadarAltimeter(Robot& robot, const std::string& name, const World& world);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  const World& world_;
  double max_range_ = 30.0;  // MaxRange, m
  double z_ = 0.0;
};

}  // namespace ccmorse::sim
