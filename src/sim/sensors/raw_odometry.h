#pragma once

#include <string>

#include "sim/component.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

/// MORSE's Odometry at level raw (specs: morse.md B.2): `dS`, m, the way since the last activation.
/// 60 Hz.
class RawOdometry : public Sensor {
 public:
  RawOdometry(Robot& robot, const std::string& name);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  Vec3 last_;         // m, where it was
  double way_ = 0.0;  // m
};

}  // namespace ccmorse::sim
