#pragma once

#include <string>

#include "sim/component.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

/// Drives by the speeds of two wheels: MORSE's MotionVWDiff (specs: morse.md B.3). Data and stream:
/// v in m/s, w in rad/s. Robots go as their wheels turn, so that wheels at (v -/+ w track/2)/R take
/// it along with just v and w; below 0.001 of both it stands. Services set_speed(v, w) and stop().
class MotionVWDiff : public Actuator {
 public:
  MotionVWDiff(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // the robot's speed counts
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;
  void SetSpeed(double v, double w);

  Twist speed_;
};

}  // namespace ccmorse::sim
