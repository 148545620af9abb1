#pragma once

#include <string>
#include <vector>

#include "scene/scenario.h"
#include "sim/component.h"

namespace ccmorse::sim {

/// MORSE's Battery (specs: morse.md B.2): `charge`, %, falls by DischargingRate %/s and rises by as
/// much in a zone of type Charging; `status` is "Discharging", "Charging" or "Charged". 60 Hz.
class Battery : public Sensor {
 public:
  Battery(Robot& robot, const std::string& name, const scene::Scenario& scenario);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  std::vector<scene::ZoneDef> zones_;  // that charge
  double rate_ = 0.05;                 // DischargingRate, %/s
  double charge_ = 100.0;              // %
  double last_time_ = 0.0;             // s
  const char* status_ = "Charged";
};

}  // namespace ccmorse::sim
