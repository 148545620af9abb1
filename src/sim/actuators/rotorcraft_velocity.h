#pragma once

#include <string>

#include "scene/scenario.h"
#include "sim/actuators/rotorcraft_pilot.h"

namespace ccmorse::sim {

/// Flies a rotorcraft at a velocity: MORSE's RotorcraftVelocity (specs: morse.md B.3). Data and
/// stream: `vx` forwards, `vy` to the left, `vz` up, m/s, level whatever its tilt, each MaxVelocity
/// at most; `vyaw`, rad/s, counter-clockwise; `tolerance`, of no effect. From the errors of the
/// velocity come roll and pitch (MaxBankAngle at most) and thrust, from those of the angles the
/// torques. It hovers until it is told. Service setvel(vx, vy, vz, vyaw, tolerance = 0.1). 60 Hz.
class RotorcraftVelocity : public RotorcraftPilot {
 public:
  RotorcraftVelocity(Robot& robot, const std::string& name, const scene::Scenario& scenario);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  Vec3 velocity_;
  double turn_ = 0.0;       // vyaw
  double tolerance_ = 0.2;  // m/s
  double wanted_yaw_;       // rad
  PdLoop forward_;
  PdLoop left_;
  PdLoop up_;
  double max_velocity_ = 2.0;  // MaxVelocity, m/s
};

}  // namespace ccmorse::sim
