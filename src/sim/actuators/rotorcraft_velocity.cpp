#include "sim/actuators/rotorcraft_velocity.h"

#include <algorithm>

#include "base/trig.h"

namespace ccmorse::sim {

RotorcraftVelocity::RotorcraftVelocity(Robot& robot, const std::string& name,
                                       const scene::Scenario& scenario)
    // rad s/m, rad s^2/m, 1/s, 1
    : RotorcraftPilot(robot, name, "RotorcraftVelocity", scenario, {0.2, 0.8, 8.0, 2.0, 12.0, 8.0}),
      wanted_yaw_(robot.pose().yaw) {
  AddProperty("MaxVelocity", max_velocity_, 0.0, 1000.0);
  AddService({"setvel",
              {{"vx"}, {"vy"}, {"vz"}, {"vyaw"}, {"tolerance", true}},
              [this](Arguments arguments) {
                const Vec3 velocity{NumberArgument(arguments, 0, "vx"),
                                    NumberArgument(arguments, 1, "vy"),
                                    NumberArgument(arguments, 2, "vz")};
                const double turn = NumberArgument(arguments, 3, "vyaw");
                tolerance_ = NumberArgument(arguments, 4, "tolerance", 0.1);
                velocity_ = velocity;
                turn_ = turn;
                DataChanged(timestamp());
                return Json();
              }});
}

void RotorcraftVelocity::Receive(const Json& message) {
  const Vec3 velocity{NumberMember(message, "vx"), NumberMember(message, "vy"),
                      NumberMember(message, "vz")};
  const double turn = NumberMember(message, "vyaw");
  if (message.Find("tolerance") != nullptr) tolerance_ = NumberMember(message, "tolerance");
  velocity_ = velocity;
  turn_ = turn;
  DataChanged(timestamp());
}

void RotorcraftVelocity::Act(const Instant& now) {
  DataChanged(now.time);
  const auto within = [](double value, double most) { return std::clamp(value, -most, most); };
  const auto [s, c] = SinCos(robot().euler().z);
  const Vec3 v = robot().velocity();
  const Vec3 error{within(velocity_.x, max_velocity_) - (c * v.x + s * v.y),
                   within(velocity_.y, max_velocity_) - (c * v.y - s * v.x),
                   within(velocity_.z, max_velocity_) - v.z};
  // Nose down it goes forwards, left side up to the right.
  const double pitch =
      Bank(forward_.Update(error.x, gains().horizontal_p, gains().horizontal_d, now.step));
  const double roll =
      Bank(-left_.Update(error.y, gains().horizontal_p, gains().horizontal_d, now.step));
  wanted_yaw_ = NormalizeAngle(wanted_yaw_ + turn_ * now.step);
  // The derivative of the vertical error is an acceleration, which the thrust itself makes: that
  // part counts as of one tick, or the loop would follow its own doing.
  const double up =
      fall() + up_.Update(error.z, gains().vertical_p, gains().vertical_d * now.step, now.step);
  Fly({roll, pitch, wanted_yaw_}, up, now.step);
}

void RotorcraftVelocity::Reset() {
  RotorcraftPilot::Reset();
  velocity_ = {};
  turn_ = 0.0;
  tolerance_ = 0.2;
  wanted_yaw_ = robot().euler().z;
  forward_.Reset();
  left_.Reset();
  up_.Reset();
}

void RotorcraftVelocity::AppendFields(std::string& out) const {
  AppendField(out, "vx", velocity_.x);
  AppendField(out, "vy", velocity_.y);
  AppendField(out, "vz", velocity_.z);
  AppendField(out, "vyaw", turn_);
  AppendField(out, "tolerance", tolerance_);
}

}  // namespace ccmorse::sim
