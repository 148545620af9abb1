#pragma once

#include <string>

#include "scene/scenario.h"
#include "sim/actuators/body_forces.h"
#include "sim/component.h"

namespace ccmorse::sim {

/// Flies a rotorcraft at a velocity: MORSE's RotorcraftVelocity (specs: morse.md B.3). Data and
/// stream: `vx` forwards, `vy` to the left, `vz` up, m/s, level whatever its tilt, each MaxVelocity
/// at most; `vyaw`, rad/s, counter-clockwise; `tolerance`, of no effect. From the errors of the
/// velocity come roll and pitch (MaxBankAngle at most) and thrust, from those of the angles the
/// torques. It hovers until it is told. Service setvel(vx, vy, vz, vyaw, tolerance = 0.1). 60 Hz.
class RotorcraftVelocity : public Actuator {
 public:
  RotorcraftVelocity(Robot& robot, const std::string& name, const scene::Scenario& scenario);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // what becomes of the robot counts
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  double fall_;  // m/s^2
  Vec3 velocity_;
  double turn_ = 0.0;       // vyaw
  double tolerance_ = 0.2;  // m/s
  double wanted_yaw_;       // rad
  PdLoop forward_;
  PdLoop left_;
  PdLoop up_;
  AttitudeLoops loops_;

  double horizontal_p_ = 0.2;  // HorizontalPgain, rad s/m
  double horizontal_d_ = 0.8;  // HorizontalDgain, rad s^2/m
  double vertical_p_ = 8.0;    // VerticalPgain, 1/s
  double vertical_d_ = 2.0;    // VerticalDgain, 1
  double yaw_p_ = 12.0;        // YawPgain, 1/s^2
  double yaw_d_ = 8.0;         // YawDgain, 1/s
  double roll_pitch_p_ = 9.7;  // RollPitchPgain, 1/s^2
  double roll_pitch_d_ = 2.0;  // RollPitchDgain, 1/s
  double max_bank_;            // MaxBankAngle, rad
  double max_velocity_ = 2.0;  // MaxVelocity, m/s
};

}  // namespace ccmorse::sim
