#include "sim/actuators/drag.h"

#include <cmath>

#include "sim/actuators/body_forces.h"

namespace ccmorse::sim {
namespace {

constexpr double kMostDrag = 1e4;  // N s^2/m^2

}  // namespace

Drag::Drag(Robot& robot, const std::string& name) : Actuator(robot, name, "Drag", 60.0) {
  NeedBody(*this);
  AddProperty("DragCoeffX", x_, 0.0, kMostDrag);
  AddProperty("DragCoeffY", y_, 0.0, kMostDrag);
  AddProperty("DragCoeffZ", z_, 0.0, kMostDrag);
}

void Drag::Receive(const Json&) { throw WrongArgument("a Drag takes no messages"); }

void Drag::Act(const Instant& now) {
  DataChanged(now.time);
  const Vec3 v = RotateBack(robot().rotation(), robot().velocity());
  // Not more than what would stop it in this tick: the force is held while the speed falls.
  const auto held = [&](double coefficient, double speed) {
    const double most = robot().model().mass * std::fabs(speed) / now.step;
    const double force = std::fmin(coefficient * speed * speed, most);
    return speed > 0.0 ? -force : force;
  };
  robot().Push(Rotate(robot().rotation(), {held(x_, v.x), held(y_, v.y), held(z_, v.z)}), {});
}

}  // namespace ccmorse::sim
