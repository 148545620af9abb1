#pragma once

#include <array>
#include <string>

#include "sim/component.h"

namespace ccmorse::sim {

/// Four rotors on a dynamic robot: MORSE's QuadrotorDynamicControl (specs: morse.md B.3). Data and
/// stream: `engines`, how fast they turn, rad/s, a list of four. Each lifts by b w^2 (ThrustFactor,
/// N s^2) at Lever m from the middle, and turns the robot against its own sense by d w^2
/// (DragFactor, Nm s^2). Of Configuration "+" they are in front, on the right, behind and on the
/// left, of "x" an eighth of a turn to the left of these; the first and the third turn clockwise,
/// so that they turn the robot to the left. 60 Hz.
class QuadrotorDynamicControl : public Actuator {
 public:
  QuadrotorDynamicControl(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // what becomes of the robot counts
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  std::array<double, 4> engines_{};
  double thrust_ = 9.169e-06;        // ThrustFactor
  double drag_ = 2.4e-07;            // DragFactor
  double lever_ = 0.18;              // Lever, m
  std::string configuration_ = "+";  // Configuration
};

}  // namespace ccmorse::sim
