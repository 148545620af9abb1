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
  const scene::DynamicsDef* const dynamics = robot().dynamics();
  if (dynamics == nullptr || dynamics->wheels.empty()) {
    robot().Command(stop ? Twist{} : speed_, this);
    return;
  }
  // Wheels that drive the robot themselves.
  double track = dynamics->turning_track;
  if (track == 0.0) {
    double left = 0.0;
    double right = 0.0;
    for (const scene::WheelDef& wheel : dynamics->wheels) {
      if (wheel.drive == "left") left = wheel.position.y;
      if (wheel.drive == "right") right = wheel.position.y;
    }
    track = left - right;
  }
  const double half = stop ? 0.0 : 0.5 * w * track;
  robot().CommandWheels({stop ? 0.0 : v - half, stop ? 0.0 : v + half}, this);
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
