#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/component.h"
#include "sim/world.h"

namespace ccmorse::sim {

/// MORSE's Proximity (specs: morse.md B.2): `near_objects`, an object of name and distance, m, of
/// each other robot and passive object that has the property Track and whose origin is at most
/// Range from the robot's; every robot has "Robot_Tag". `near_robots` is the same. Services
/// set_range and set_tracked_tag. 12 Hz.
class Proximity : public Sensor {
 public:
  Proximity(Robot& robot, const std::string& name, const World& world);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  const World& world_;
  double range_ = 100.0;           // Range, m
  std::string tag_ = "Robot_Tag";  // Track
  std::vector<std::pair<const std::string*, double>> near_;
};

}  // namespace ccmorse::sim
