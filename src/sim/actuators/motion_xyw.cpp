#include "sim/actuators/motion_xyw.h"

namespace ccmorse::sim {

MotionXYW::MotionXYW(Robot& robot, const std::string& name)
    : Actuator(robot, name, "MotionXYW", 60.0) {
  AddProperty("ControlType", control_, {"Velocity", "Position"});
}

void MotionXYW::Receive(const Json& message) {
  speed_ = {NumberMember(message, "x"), NumberMember(message, "w"), NumberMember(message, "y")};
  DataChanged(timestamp());
  robot().Command(speed_, this);
}

void MotionXYW::Act(const Instant& now) { DataChanged(now.time); }

void MotionXYW::Reset() {
  Actuator::Reset();
  speed_ = {};
}

void MotionXYW::AppendFields(std::string& out) const {
  AppendField(out, "x", speed_.v);
  AppendField(out, "y", speed_.side);
  AppendField(out, "w", speed_.w);
}

}  // namespace ccmorse::sim
