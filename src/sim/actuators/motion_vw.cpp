#include "sim/actuators/motion_vw.h"

namespace ccmorse::sim {

MotionVW::MotionVW(Robot& robot, const std::string& name)
    : Actuator(robot, name, "MotionVW", 60.0) {
  AddService({"set_speed", {{"v"}, {"w"}}, [this](Arguments arguments) {
                SetSpeed({NumberArgument(arguments, 0, "v"), NumberArgument(arguments, 1, "w")});
                return Json();
              }});
  AddService({"stop", {}, [this](Arguments) {
                SetSpeed({});
                return Json();
              }});
}

void MotionVW::SetSpeed(const Twist& speed) {
  speed_ = speed;
  DataChanged(timestamp());
  robot().Command(speed_, this);
}

void MotionVW::Receive(const Json& message) {
  SetSpeed({NumberMember(message, "v"), NumberMember(message, "w")});
}

void MotionVW::Act(const Instant& now) {
  DataChanged(now.time);
  if (robot().driver() == this) robot().Command(speed_, this);
}

void MotionVW::Reset() {
  Actuator::Reset();
  speed_ = {};
}

void MotionVW::AppendFields(std::string& out) const {
  AppendField(out, "v", speed_.v);
  AppendField(out, "w", speed_.w);
}

}  // namespace ccmorse::sim
