#pragma once

#include <string>

#include "scene/scenario.h"
#include "sim/actuators/body_forces.h"
#include "sim/component.h"

namespace ccmorse::sim {

/// Holds a rotorcraft's attitude: MORSE's RotorcraftAttitude (specs: morse.md B.3). Data and
/// stream, in the conventions of autopilots (x forward, y right, z down): `roll`, positive right
/// side down, `pitch`, positive nose up, rad; `yaw`, clockwise, its rate (rad/s) or, without
/// YawRateControl, the angle itself (rad) from the world's x axis, or from north with
/// UseAngleAgainstNorth; `thrust`, 0..1, of ThrustFactor newtons (its square without LinearThrust).
/// Torques are inertia times what the gains make of the errors, times the thrust: without thrust it
/// falls. 60 Hz.
class RotorcraftAttitude : public Actuator {
 public:
  RotorcraftAttitude(Robot& robot, const std::string& name, const scene::Scenario& scenario);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // what becomes of the robot counts
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  double north_;  // rad, clockwise from north to the world's x axis
  double roll_ = 0.0;
  double pitch_ = 0.0;
  double yaw_ = 0.0;
  double thrust_ = 0.0;
  double wanted_yaw_ = 0.0;  // rad, counter-clockwise, by the rates so far
  AttitudeLoops loops_;

  double roll_pitch_p_ = 100.0;  // RollPitchPgain, 1/s^2
  double roll_pitch_d_ = 20.0;   // RollPitchDgain, 1/s
  double yaw_p_ = 16.0;          // YawPgain
  double yaw_d_ = 4.0;           // YawDgain
  double factor_ = 40.0;         // ThrustFactor, N
  bool linear_ = true;           // LinearThrust
  bool rate_ = true;             // YawRateControl
  bool against_north_ = false;   // UseAngleAgainstNorth
};

}  // namespace ccmorse::sim
