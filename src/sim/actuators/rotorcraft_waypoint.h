#pragma once

#include <string>

#include "scene/scenario.h"
#include "sim/actuators/rotorcraft_pilot.h"

namespace ccmorse::sim {

/// Flies a rotorcraft to a point: MORSE's RotorcraftWaypoint (specs: morse.md B.3). Data and
/// stream: x, y, z, m, and yaw, rad, in the world; tolerance, m. Where it is at the first tick it
/// stays until it is told. From the errors of the place, and the velocity, come roll and pitch
/// (MaxBankAngle at most) and thrust, from those of the angles the torques. Services: goto,
/// answered "Arrived" once its origin is within the tolerance (a new one preempts it), setdest,
/// get_status. Without RemainAtDestination it stays where it is on arrival. 60 Hz.
class RotorcraftWaypoint : public RotorcraftPilot {
 public:
  RotorcraftWaypoint(Robot& robot, const std::string& name, const scene::Scenario& scenario);
  ~RotorcraftWaypoint() override;
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
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

  Target target_;
  bool under_way_ = false;
  const char* status_ = "Stop";
  Completion pending_;               // of a goto
  bool remain_ = true;               // RemainAtDestination
  std::string shown_ = "wp_target";  // Target: of no effect
};

}  // namespace ccmorse::sim
