#pragma once

#include <string>

#include "scene/scenario.h"
#include "sim/actuators/body_forces.h"
#include "sim/component.h"

namespace ccmorse::sim {

/// What MORSE's RotorcraftVelocity and RotorcraftWaypoint have in common (specs: morse.md B.3):
/// gains as properties, and a rotorcraft that banks by them and keeps its height. Throws Error
/// unless the robot is dynamic.
class RotorcraftPilot : public Actuator {
 public:
  void AddToHash(StateHash&) const override {}  // what becomes of the robot counts
  void Reset() override;

 protected:
  /// Of the properties of these names; what the horizontal and vertical ones are of, and so their
  /// units, is the derived class's.
  struct Gains {
    double horizontal_p, horizontal_d;  // HorizontalPgain, HorizontalDgain
    double vertical_p, vertical_d;      // VerticalPgain, VerticalDgain
    double yaw_p, yaw_d;                // YawPgain, 1/s^2; YawDgain, 1/s
    double roll_pitch_p = 9.7;          // RollPitchPgain, 1/s^2
    double roll_pitch_d = 2.0;          // RollPitchDgain, 1/s
  };

  RotorcraftPilot(Robot& robot, const std::string& name, const std::string& type,
                  const scene::Scenario& scenario, const Gains& gains);

  const Gains& gains() const { return gains_; }
  double Bank(double angle) const;       // rad, within MaxBankAngle
  double fall() const { return fall_; }  // m/s^2, what keeps its height
  /// Turns the robot to roll, pitch and yaw, rad, and pushes it up by `up`, m/s^2, whatever its
  /// tilt. `step`: s of the tick.
  void Fly(const Vec3& angles, double up, double step);

 private:
  Gains gains_;
  double max_bank_;  // MaxBankAngle, rad
  double fall_;      // m/s^2
  AttitudeLoops loops_;
};

}  // namespace ccmorse::sim
