#pragma once

#include <string>

#include "sim/component.h"
#include "sim/world.h"

namespace ccmorse::sim {

/// MORSE's Thermometer (specs: morse.md B.2): `temperature`, degrees Celsius: DefaultTemperature,
/// and F exp(-Alpha d) for each robot or passive object that has a property FireTag and is d <
/// Range away, m; F is the property's value where it is a number, else FireTemperature. 60 Hz.
class Thermometer : public Sensor {
 public:
  Thermometer(Robot& robot, const std::string& name, const World& world);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  const World& world_;
  std::string tag_ = "Fire";  // FireTag
  double default_ = 15.0;     // DefaultTemperature
  double fire_ = 200.0;       // FireTemperature
  double range_;              // Range, m
  double alpha_ = 0.2;        // Alpha, 1/m
  double temperature_ = 0.0;
};

}  // namespace ccmorse::sim
