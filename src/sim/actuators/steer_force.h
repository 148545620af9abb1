#pragma once

#include <string>

#include "sim/component.h"

namespace ccmorse::sim {

/// Drives a vehicle as a car is driven: MORSE's SteerForce (specs: morse.md B.3). Data and stream:
/// `steer`, rad, of the front wheels, positive to the left; `force` on all four wheels, negative
/// forwards, of which 0.4 N count on each; `brake`, of which 0.1 count on a front and 1.3 on a rear
/// wheel, as the impulse (Ns) that holds it in a substep. For robots whose dynamics have a
/// `vehicle`, such as MORSE's Hummer; no other moves by it, with a line in the log. 60 Hz.
class SteerForce : public Actuator {
 public:
  SteerForce(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // what becomes of the robot counts
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  double steer_ = 0.0;
  double force_ = 0.0;
  double brake_ = 0.0;
};

}  // namespace ccmorse::sim
