#pragma once

#include <string>

#include "scene/scenario.h"
#include "sim/actuators/body_forces.h"
#include "sim/component.h"

namespace ccmorse::sim {

/// Flies a rotorcraft to a point: MORSE's RotorcraftWaypoint (specs: morse.md B.3). Data and
/// stream: x, y, z, m, and yaw, rad, in the world; tolerance, m. Where it is at the first tick it
/// stays until it is told. From the errors of the place, and the velocity, come roll and pitch
/// (MaxBankAngle at most) and thrust, from those of the angles the torques. Services: goto,
/// answered "Arrived" once its origin is within the tolerance (a new one preempts it), setdest,
/// get_status. Without RemainAtDestination it stays where it is on arrival. 60 Hz.
class RotorcraftWaypoint : public Actuator {
 public:
  RotorcraftWaypoint(Robot& robot, const std::string& name, const scene::Scenario& scenario);
  ~RotorcraftWaypoint() override;
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // what becomes of the robot counts
  void Reset() override;

  /// Ends a pending goto as PREEMPTED; the robot stays where it is.
  void Interrupt() override;

 private:
  struct Target {
    Vec3 point;              // m
    double yaw = 0.0;        // rad
    double tolerance = 0.2;  // m
  };

  void AppendFields(std::string& out) const override;
  static Target TargetFrom(Arguments arguments);
  static void Check(const Target& target);  // throws WrongArgument
  void FlyTo(const Target& target);
  void StayHere();
  bool Arrived() const;
  void Finish(Outcome outcome, const char* text);

  double fall_;  // m/s^2
  Target target_;
  bool under_way_ = false;
  const char* status_ = "Stop";
  Completion pending_;  // of a goto
  AttitudeLoops loops_;

  double horizontal_p_;              // HorizontalPgain, rad/m
  double horizontal_d_;              // HorizontalDgain, rad s/m
  double vertical_p_ = 8.0;          // VerticalPgain, 1/s^2
  double vertical_d_ = 8.0;          // VerticalDgain, 1/s
  double yaw_p_ = 12.0;              // YawPgain, 1/s^2
  double yaw_d_ = 6.0;               // YawDgain, 1/s
  double roll_pitch_p_ = 9.7;        // RollPitchPgain, 1/s^2
  double roll_pitch_d_ = 2.0;        // RollPitchDgain, 1/s
  double max_bank_;                  // MaxBankAngle, rad
  bool remain_ = true;               // RemainAtDestination
  std::string shown_ = "wp_target";  // Target: of no effect
};

}  // namespace ccmorse::sim
