#include "sim/actuators/keyboard.h"

#include "sim/robots/robot.h"

namespace ccmorse::sim {
namespace {

double ShareArgument(Arguments arguments, std::size_t index, const char* name) {
  const double share = NumberArgument(arguments, index, name);
  if (!(share >= -1.0 && share <= 1.0)) {
    throw WrongArgument(std::string(name) + " must be a number from -1 to 1");
  }
  return share;
}

}  // namespace

Keyboard::Keyboard(Robot& robot, const std::string& name)
    : Actuator(robot, name, "Keyboard", 60.0) {
  AddProperty("ControlType", control_, {"Velocity", "Position"});
  AddProperty("Speed", speed_, 0.0, 1e6);
  AddService({"drive", {{"forward"}, {"left"}}, [this](Arguments arguments) {
                const double forward = ShareArgument(arguments, 0, "forward");
                const double left = ShareArgument(arguments, 1, "left");
                forward_ = forward;
                left_ = left;
                this->robot().Command({forward_ * speed_, left_ * speed_}, this);
                return Json();
              }});
}

void Keyboard::Receive(const Json& /*message*/) {
  throw WrongArgument("a keyboard takes keys, not stream messages");
}

void Keyboard::Act(const Instant& now) {
  DataChanged(now.time);
  if (robot().driver() != this || (forward_ == 0.0 && left_ == 0.0)) return;
  robot().Command({forward_ * speed_, left_ * speed_}, this);
}

void Keyboard::Reset() {
  Actuator::Reset();
  forward_ = left_ = 0.0;
}

}  // namespace ccmorse::sim
