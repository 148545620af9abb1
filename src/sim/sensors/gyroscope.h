#pragma once

#include <string>

#include "sim/component.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

/// MORSE's Gyroscope (specs: morse.md B.2): yaw, pitch and roll of the sensor in the world, rad. 60
/// Hz.
class Gyroscope : public Sensor {
 public:
  Gyroscope(Robot& robot, const std::string& name);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  Vec3 euler_;
};

}  // namespace ccmorse::sim
