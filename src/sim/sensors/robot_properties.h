#pragma once

#include "scene/scenario.h"
#include "sim/component.h"

namespace ccmorse::sim {

/// The thesis's RobotProperties (3.2): what the scenario and the robot's model say, for the
/// client's Player layer. Data: `properties`, an object that does not change during a run; 1 Hz.
class RobotProperties : public Sensor {
 public:
  RobotProperties(Robot& robot, const std::string& name, const scene::Scenario& scenario);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash&) const override {}

 private:
  void AppendFields(std::string& out) const override;

  std::string properties_;  // JSON
};

}  // namespace ccmorse::sim
