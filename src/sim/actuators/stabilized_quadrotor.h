#pragma once

#include <string>

#include "sim/component.h"

namespace ccmorse::sim {

/// Flies a quadrotor that is stabilised already, without physics: MORSE's StabilizedQuadrotor
/// (specs: morse.md B.3). Data and stream: `phi_c`, roll, and `theta_c`, pitch, rad; `psi_c`,
/// rad/s, at which it turns clockwise; `h_c`, its height, m. The angles follow as filters of second
/// order (10 rad/s, damping 0.7); the thrust brings it to its height, and tilted takes it along.
/// The robot's dynamics are "free". Services: set_cons(phi, theta, psi, h), and stop(), all 0. 60
/// Hz.
class StabilizedQuadrotor : public Actuator {
 public:
  StabilizedQuadrotor(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // what becomes of the robot counts
  void Reset() override;

 private:
  // An angle on its way.
  struct Filter {
    double value = 0.0;  // rad
    double rate = 0.0;   // rad/s
    void Step(double wanted, double seconds);
  };
  // What it is told.
  struct Wanted {
    double theta = 0.0;
    double phi = 0.0;
    double psi = 0.0;
    double h = 0.0;
  };

  void AppendFields(std::string& out) const override;
  void Set(const Wanted& wanted);

  Wanted wanted_;
  Filter theta_;
  Filter phi_;
  Filter psi_;
  double wanted_psi_ = 0.0;  // rad, counter-clockwise
};

}  // namespace ccmorse::sim
