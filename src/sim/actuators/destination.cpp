#include "sim/actuators/destination.h"

#include <algorithm>
#include <cmath>

#include "base/trig.h"

namespace ccmorse::sim {

Destination::Destination(Robot& robot, const std::string& name)
    : Actuator(robot, name, "Destination", 60.0), target_(robot.position()) {
  AddProperty("Tolerance", tolerance_, 0.0, 1e6);
  AddProperty("Speed", speed_, 0.0, 1e6);
  AddProperty("ControlType", control_, {"Velocity", "Position"});
  AddProperty("RemainAtDestination", remain_);
}

void Destination::Receive(const Json& message) {
  target_ = {NumberMember(message, "x"), NumberMember(message, "y"), NumberMember(message, "z")};
  going_ = true;
  DataChanged(timestamp());
  robot().Command({}, this);
}

void Destination::Act(const Instant& now) {
  DataChanged(now.time);
  if (!going_ || robot().driver() != this) return;
  const Pose2& pose = robot().pose();
  const Vec2 off = Vec2{target_.x, target_.y} - Vec2{pose.x, pose.y};
  const double distance = std::sqrt(Dot(off, off));
  if (distance <= tolerance_) {
    robot().Command({}, this);
    going_ = remain_;
    return;
  }
  const auto [s, c] = SinCos(pose.yaw);
  const double share = std::min(speed_, distance / now.step) / distance;
  robot().Command({share * (c * off.x + s * off.y), 0.0, share * (c * off.y - s * off.x)}, this);
}

void Destination::Reset() {
  Actuator::Reset();
  target_ = robot().position();
  going_ = false;
}

void Destination::AppendFields(std::string& out) const {
  AppendField(out, "x", target_.x);
  AppendField(out, "y", target_.y);
  AppendField(out, "z", target_.z);
}

}  // namespace ccmorse::sim
