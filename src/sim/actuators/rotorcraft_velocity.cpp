#include "sim/actuators/rotorcraft_velocity.h"

#include <algorithm>

#include "base/trig.h"

namespace ccmorse::sim {
namespace {

constexpr double kMostGain = 1e4;

}  // namespace

RotorcraftVelocity::RotorcraftVelocity(Robot& robot, const std::string& name,
                                       const scene::Scenario& scenario)
    : Actuator(robot, name, "RotorcraftVelocity", 60.0),
      wanted_yaw_(robot.pose().yaw),
      max_bank_(Radians(30.0)) {
  NeedBody(*this);
  fall_ = FallOf(robot, scenario);
  AddProperty("HorizontalPgain", horizontal_p_, 0.0, kMostGain);
  AddProperty("HorizontalDgain", horizontal_d_, 0.0, kMostGain);
  AddProperty("VerticalPgain", vertical_p_, 0.0, kMostGain);
  AddProperty("VerticalDgain", vertical_d_, 0.0, kMostGain);
  AddProperty("YawPgain", yaw_p_, 0.0, kMostGain);
  AddProperty("YawDgain", yaw_d_, 0.0, kMostGain);
  AddProperty("RollPitchPgain", roll_pitch_p_, 0.0, kMostGain);
  AddProperty("RollPitchDgain", roll_pitch_d_, 0.0, kMostGain);
  AddProperty("MaxBankAngle", max_bank_, 0.0, Radians(80.0));
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
      within(forward_.Update(error.x, horizontal_p_, horizontal_d_, now.step), max_bank_);
  const double roll =
      within(-left_.Update(error.y, horizontal_p_, horizontal_d_, now.step), max_bank_);
  wanted_yaw_ = NormalizeAngle(wanted_yaw_ + turn_ * now.step);
  // The derivative of the vertical error is an acceleration, which the thrust itself makes: that
  // part counts as of one tick, or the loop would follow its own doing.
  const double up = fall_ + up_.Update(error.z, vertical_p_, vertical_d_ * now.step, now.step);
  const double upright = std::max(0.1, robot().rotation().z.z);
  const double lift = robot().model().mass * std::max(0.0, up) / upright;
  robot().Push(lift * robot().rotation().z, {});
  loops_.Turn(robot(), {roll, pitch, wanted_yaw_}, {roll_pitch_p_, roll_pitch_d_, yaw_p_, yaw_d_},
              1.0, now.step);
}

void RotorcraftVelocity::Reset() {
  Actuator::Reset();
  velocity_ = {};
  turn_ = 0.0;
  tolerance_ = 0.2;
  wanted_yaw_ = robot().euler().z;
  forward_.Reset();
  left_.Reset();
  up_.Reset();
  loops_.Reset();
}

void RotorcraftVelocity::AppendFields(std::string& out) const {
  AppendField(out, "vx", velocity_.x);
  AppendField(out, "vy", velocity_.y);
  AppendField(out, "vz", velocity_.z);
  AppendField(out, "vyaw", turn_);
  AppendField(out, "tolerance", tolerance_);
}

}  // namespace ccmorse::sim
