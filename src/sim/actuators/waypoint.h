#pragma once

#include "sim/component.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

/// Drives to a point: MORSE's Waypoint (specs: morse.md B.3). Turns at speed/2 rad/s towards the
/// target and goes forward while it looks less than 60 degrees away from it. Data and stream: x, y,
/// z, tolerance in m, speed in m/s. Services: goto (answered "Arrived" on arrival; a new one
/// preempts it), setdest, stop, resume, get_status. It does not avoid obstacles: MORSE's needs two
/// radar sensors, which the S1R lacks. Properties: AngleTolerance, within which it does not turn,
/// rad, Speed, ControlType, RemainAtDestination, with which it goes back where something else has
/// taken the robot away, and FreeZ, with which z counts for the arrival; of no effect are
/// ObstacleAvoidance, Ignore (words with commas, a list in MORSE) and Target.
class Waypoint : public Actuator {
 public:
  Waypoint(Robot& robot, const std::string& name);
  ~Waypoint() override;
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // the robot's speed counts
  void Reset() override;

  /// Ends a pending goto as PREEMPTED and stops.
  void Interrupt() override;

 private:
  struct Target {
    Vec2 point;
    double z = 0.0;
    double tolerance = 0.5;  // m
    double speed = 1.0;      // m/s
  };

  void AppendFields(std::string& out) const override;
  static Target TargetFrom(Arguments arguments);
  static void Check(const Target& target);  // throws WrongArgument
  void DriveTo(const Target& target);
  void Finish(Outcome outcome, const char* text);
  bool Arrived() const;

  Target target_;
  bool has_target_ = false;
  bool paused_ = false;
  const char* status_ = "Stop";
  Completion pending_;                // of a goto
  double angle_tolerance_;            // AngleTolerance, rad
  double speed_ = 1.0;                // Speed, m/s: of stream messages that say none
  bool remain_ = false;               // RemainAtDestination
  std::string control_ = "Velocity";  // ControlType: of no effect
  bool free_z_ = false;               // FreeZ
  bool avoids_ = true;                // ObstacleAvoidance: of no effect
  std::string shown_at_;              // Target: of no effect
  std::string ignored_;               // Ignore: of no effect
};

}  // namespace ccmorse::sim
