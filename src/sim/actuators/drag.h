#pragma once

#include <string>

#include "sim/component.h"

namespace ccmorse::sim {

/// MORSE's Drag (specs: morse.md B.3): holds a dynamic robot back by c v |v| (N) along each of its
/// own axes. Properties DragCoeffX, DragCoeffY, DragCoeffZ, N s^2/m^2. It has no data. 60 Hz.
class Drag : public Actuator {
 public:
  Drag(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // what becomes of the robot counts

 private:
  void AppendFields(std::string&) const override {}

  double x_ = 0.09;
  double y_ = 0.09;
  double z_ = 0.5;
};

}  // namespace ccmorse::sim
