#pragma once

#include "base/pose.h"
#include "scene/scenario.h"
#include "sim/component.h"
#include "sim/noise.h"

namespace ccmorse::sim {

/// Where the sensor is in the world, at the robot's origin unless it is mounted elsewhere: MORSE's
/// Pose (specs: morse.md B.2), without error unless the scenario gives it noise. Data in m and rad.
class PoseSensor : public Sensor {
 public:
  /// With the robot's pose_noise, or one of its own.
  PoseSensor(Robot& robot, const std::string& name, std::uint64_t seed);
  PoseSensor(Robot& robot, const std::string& name, std::uint64_t seed,
             const scene::PoseNoiseDef& noise);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;
  NumberForm number_form() const override { return NumberForm::kPose; }
  void AppendNumbers(std::vector<double>& out) const override;

 private:
  void AppendFields(std::string& out) const override;
  void Read();

  Noise noise_;
  scene::PoseNoiseDef deviation_;
  Pose2 pose_;
  double z_ = 0.0;      // m
  double pitch_ = 0.0;  // rad
  double roll_ = 0.0;   // rad
};

}  // namespace ccmorse::sim
