#pragma once

#include <string>

#include "sim/component.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

/// MORSE's Clock (specs: morse.md B.2): the timestamp and nothing else. 60 Hz.
class Clock : public Sensor {
 public:
  Clock(Robot& robot, const std::string& name);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;
};

}  // namespace ccmorse::sim
