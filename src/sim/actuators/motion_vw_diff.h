#pragma once

#include <string>

#include "sim/component.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

/// Drives by the speeds of two wheels: MORSE's MotionVWDiff (specs: morse.md B.3). Data and stream:
/// v in m/s, w in rad/s. Kinematic robots go as their wheels turn, so that wheels at
/// (v -/+ w track/2)/R take them along with just v and w; those of a dynamic robot turn so, and
/// friction does the rest. Below 0.001 of both they stand. Services set_speed(v, w) and stop().
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
