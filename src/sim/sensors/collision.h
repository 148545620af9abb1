#pragma once

#include <string>
#include <vector>

#include "sim/component.h"
#include "sim/world.h"

namespace ccmorse::sim {

/// MORSE's Collision (specs: morse.md B.2): while the robot touches something, `collision` is true
/// and `objects` has the names of what it touches, with commas between them; without contact
/// nothing is streamed. With only_objects_with_property only robots count that have this property.
/// A robot's name is its own, a mesh's that of the world file; a box is called by its kind and id.
/// 60 Hz.
class Collision : public Sensor {
 public:
  Collision(Robot& robot, const std::string& name, const World& world);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;
  bool HasNews() const override { return !objects_.empty(); }

 private:
  void AppendFields(std::string& out) const override;
  std::string NameOf(int id) const;

  const World& world_;
  std::string only_;  // only_objects_with_property
  std::string objects_;
  std::vector<const Obstacle*> near_;  // scratch
};

}  // namespace ccmorse::sim
