#pragma once

#include <string>
#include <vector>

#include "sim/component.h"
#include "sim/world.h"

namespace ccmorse::sim {

/// MORSE's CompoundSensor (specs: morse.md B.2): for each of the sensors in its property `sensors`,
/// full names with commas between them, a member of that name with that sensor's data, as they are
/// when somebody asks. Names of no sensor are left out, and so is its own. 60 Hz.
class CompoundSensor : public Sensor {
 public:
  CompoundSensor(Robot& robot, const std::string& name, const World& world);
  void Prepare() override { Find(); }
  void Sample(const Instant& now) override;
  void AddToHash(StateHash&) const override {}  // the sensors themselves count
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;
  void PropertyChanged() override { found_ = false; }
  void Find();

  const World& world_;
  std::string names_;  // sensors
  bool found_ = false;
  std::vector<Component*> sensors_;
};

}  // namespace ccmorse::sim
