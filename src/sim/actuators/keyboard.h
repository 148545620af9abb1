#pragma once

#include <string>

#include "sim/component.h"

namespace ccmorse::sim {

/// MORSE's Keyboard (specs: morse.md B.3): drives its robot by the keys that are held in the view.
/// It has no stream. Its service, which is ours and the view's: drive(forward, left), each of
/// -1..1: so much of Speed, m/s and rad/s, until told otherwise; from then on nothing more is told
/// to the robot, so that another actuator may have it. Property ControlType is of no effect, as
/// robots have the speed that they are told at once.
class Keyboard : public Actuator {
 public:
  Keyboard(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // the robot's speed counts
  void Reset() override;

 private:
  void AppendFields(std::string&) const override {}

  std::string control_ = "Position";  // ControlType
  double speed_ = 1.0;                // Speed
  double forward_ = 0.0;
  double left_ = 0.0;
};

}  // namespace ccmorse::sim
