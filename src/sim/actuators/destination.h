#pragma once

#include <string>

#include "sim/component.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

/// Goes straight to a point without turning: MORSE's Destination (specs: morse.md B.3). Data and
/// stream: x, y, z in m. At Speed, m/s, until the point is within Tolerance, m, in the plane:
/// robots keep their height. Then it leaves the robot alone until the next message, unless
/// RemainAtDestination. It goes along the line that MORSE documents, where MORSE 1.4 forgets how
/// the robot is turned and misses all points of a robot that does not look along x.
class Destination : public Actuator {
 public:
  Destination(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // the robot's speed counts
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  Vec3 target_;
  bool going_ = false;
  double tolerance_ = 0.5;            // Tolerance, m
  double speed_ = 5.0;                // Speed, m/s
  std::string control_ = "Velocity";  // ControlType: of no effect
  bool remain_ = false;               // RemainAtDestination
};

}  // namespace ccmorse::sim
