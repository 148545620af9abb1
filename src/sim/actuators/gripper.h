#pragma once

#include <string>

#include "sim/component.h"
#include "sim/world.h"

namespace ccmorse::sim {

/// MORSE's Gripper (specs: morse.md B.3): takes the nearest passive object with a true property
/// Graspable whose origin is within Distance, m, and within half of Angle, degrees, of the
/// gripper's x axis; the object then goes where the gripper goes. Data and stream: `grab`, whether
/// it is to hold something; a message takes something, or lets go. Services: grab() answers with
/// the object's name, None where there is none; release() with whether it held one. What is let go
/// stays where it is, in the air, too.
class Gripper : public Actuator {
 public:
  Gripper(Robot& robot, const std::string& name, World& world);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // where objects are is seen by sensors
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;
  Json Grab();
  bool Release();

  World& world_;
  double angle_ = 60.0;    // Angle, degrees
  double distance_ = 0.5;  // Distance, m
  bool grab_ = false;      // as the data say
  SceneObject* held_ = nullptr;
};

}  // namespace ccmorse::sim
