#pragma once

#include <string>

#include "sim/component.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

/// MORSE's Odometry at level differential (specs: morse.md B.2): how the sensor's pose has changed
/// since the last activation, `dx`, `dy`, `dz`, m, and `dyaw`, `dpitch`, `droll`, rad, all in the
/// frame of its pose at the start. 60 Hz.
class DifferentialOdometry : public Sensor {
 public:
  DifferentialOdometry(Robot& robot, const std::string& name);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  MountPlace start_;
  Vec3 last_;  // m, in the world
  double last_yaw_ = 0.0;
  Vec3 moved_;           // m
  double turned_ = 0.0;  // rad
};

}  // namespace ccmorse::sim
