#include "sim/actuators/motion_vw.h"

#include <utility>
#include <vector>

namespace ccmorse::sim {

MotionVW::MotionVW(Robot& robot, const std::string& name)
    : Actuator(robot, name, "MotionVW", 60.0) {
  AddProperty("ControlType", control_, {"Velocity", "Position"});
  std::vector<ServiceParameter> speeds = {{"v"}, {"w"}};
  const bool omni = robot.model().max_side_speed > 0.0;
  if (omni) speeds.push_back({"side", true});
  AddService({"set_speed", std::move(speeds), [this, omni](Arguments arguments) {
                SetSpeed({NumberArgument(arguments, 0, "v"), NumberArgument(arguments, 1, "w"),
                          omni ? NumberArgument(arguments, 2, "side", 0.0) : 0.0});
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
  const bool omni = robot().model().max_side_speed > 0.0 && message.Find("side") != nullptr;
  SetSpeed({NumberMember(message, "v"), NumberMember(message, "w"),
            omni ? NumberMember(message, "side") : 0.0});
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
