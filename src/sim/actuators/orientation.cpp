#include "sim/actuators/orientation.h"

#include <algorithm>
#include <cmath>

#include "base/trig.h"

namespace ccmorse::sim {

Orientation::Orientation(Robot& robot, const std::string& name)
    : Actuator(robot, name, "Orientation", 60.0), target_{0.0, 0.0, robot.pose().yaw} {
  AddProperty("speed", speed_, 0.0, std::numeric_limits<double>::infinity());
  AddProperty("tolerance", tolerance_, 0.0, kPi);
  AddProperty("ControlType", control_, {"Velocity", "Position"});
}

void Orientation::Receive(const Json& message) {
  target_ = {NumberMember(message, "roll"), NumberMember(message, "pitch"),
             NumberMember(message, "yaw")};
  DataChanged(timestamp());
  if (std::isfinite(speed_)) robot().Command({}, this);
}

void Orientation::Act(const Instant& now) {
  DataChanged(now.time);
  const double yaw = NormalizeAngle(target_.z);
  if (!std::isfinite(speed_) && robot().dynamic()) {
    // In space, and standing still, as MORSE has it.
    return robot().PlaceInSpace(
        {robot().position(), FromEuler(target_.x, target_.y, target_.z), {}, {}});
  }
  if (!std::isfinite(speed_)) {
    if (robot().pose().yaw != yaw) robot().Orient(yaw);
    return;
  }
  if (robot().driver() != this) return;
  const double turn = NormalizeAngle(yaw - robot().pose().yaw);
  const double rate = std::fabs(turn) <= tolerance_ ? 0.0 : turn / now.step;
  robot().Command({0.0, std::clamp(rate, -speed_, speed_)}, this);
}

void Orientation::Reset() {
  Actuator::Reset();
  target_ = {0.0, 0.0, robot().pose().yaw};
}

void Orientation::AppendFields(std::string& out) const {
  AppendField(out, "yaw", target_.z);
  AppendField(out, "pitch", target_.y);
  AppendField(out, "roll", target_.x);
}

}  // namespace ccmorse::sim
