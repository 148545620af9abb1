#include "sim/actuators/motion_vw_diff.h"

#include <cmath>

namespace ccmorse::sim {
namespace {

constexpr double kStop = 0.001;  // m/s and rad/s

}  // namespace

MotionVWDiff::MotionVWDiff(Robot& robot, const std::string& name)
    : Actuator(robot, name, "MotionVWDiff", 60.0) {
  AddService({"set_speed", {{"v"}, {"w"}}, [this](Arguments arguments) {
                SetSpeed(NumberArgument(arguments, 0, "v"), NumberArgument(arguments, 1, "w"));
                return Json();
              }});
  AddService({"stop", {}, [this](Arguments) {
                SetSpeed(0.0, 0.0);
                return Json();
              }});
}

void MotionVWDiff::SetSpeed(double v, double w) {
  speed_ = {v, w};
  DataChanged(timestamp());
  const bool stop = std::fabs(v) < kStop && std::fabs(w) < kStop;
  robot().Command(stop ? Twist{} : speed_, this);
}

void MotionVWDiff::Receive(const Json& message) {
  SetSpeed(NumberMember(message, "v"), NumberMember(message, "w"));
}

void MotionVWDiff::Act(const Instant& now) { DataChanged(now.time); }

void MotionVWDiff::Reset() {
  Actuator::Reset();
  speed_ = {};
}

void MotionVWDiff::AppendFields(std::string& out) const {
  AppendField(out, "v", speed_.v);
  AppendField(out, "w", speed_.w);
}

}  // namespace ccmorse::sim
