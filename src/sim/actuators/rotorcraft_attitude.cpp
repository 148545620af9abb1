#include "sim/actuators/rotorcraft_attitude.h"

#include <algorithm>

#include "base/trig.h"

namespace ccmorse::sim {

RotorcraftAttitude::RotorcraftAttitude(Robot& robot, const std::string& name,
                                       const scene::Scenario& scenario)
    : Actuator(robot, name, "RotorcraftAttitude", 60.0),
      north_(Radians(scenario.geodesy.value_or(scene::GeodesyDef{}).angle_against_north)),
      wanted_yaw_(robot.pose().yaw) {
  NeedBody(*this);
  AddProperty("RollPitchPgain", roll_pitch_p_, 0.0, kMostGain);
  AddProperty("RollPitchDgain", roll_pitch_d_, 0.0, kMostGain);
  AddProperty("YawPgain", yaw_p_, 0.0, kMostGain);
  AddProperty("YawDgain", yaw_d_, 0.0, kMostGain);
  AddProperty("ThrustFactor", factor_, 0.0, 1e6);
  AddProperty("LinearThrust", linear_);
  AddProperty("YawRateControl", rate_);
  AddProperty("UseAngleAgainstNorth", against_north_);
}

void RotorcraftAttitude::Receive(const Json& message) {
  const double roll = NumberMember(message, "roll");
  const double pitch = NumberMember(message, "pitch");
  const double yaw = NumberMember(message, "yaw");
  const double thrust = NumberMember(message, "thrust");
  if (thrust < 0.0 || thrust > 1.0) throw WrongArgument("'thrust' must be 0..1");
  roll_ = roll;
  pitch_ = pitch;
  yaw_ = yaw;
  thrust_ = thrust;
  DataChanged(timestamp());
}

void RotorcraftAttitude::Act(const Instant& now) {
  DataChanged(now.time);
  if (thrust_ <= 0.0) {
    wanted_yaw_ = robot().euler().z;
    loops_.Reset();
    return;
  }
  if (rate_) {
    wanted_yaw_ = NormalizeAngle(wanted_yaw_ - yaw_ * now.step);
  } else {
    wanted_yaw_ = NormalizeAngle((against_north_ ? north_ : 0.0) - yaw_);
  }
  loops_.Turn(robot(), {roll_, -pitch_, wanted_yaw_},
              {roll_pitch_p_, roll_pitch_d_, yaw_p_, yaw_d_}, thrust_, now.step);
  const double lift = factor_ * (linear_ ? thrust_ : thrust_ * thrust_);
  robot().Push(lift * robot().rotation().z, {});
}

void RotorcraftAttitude::Reset() {
  Actuator::Reset();
  roll_ = pitch_ = yaw_ = thrust_ = 0.0;
  wanted_yaw_ = robot().euler().z;
  loops_.Reset();
}

void RotorcraftAttitude::AppendFields(std::string& out) const {
  AppendField(out, "roll", roll_);
  AppendField(out, "pitch", pitch_);
  AppendField(out, "yaw", yaw_);
  AppendField(out, "thrust", thrust_);
}

}  // namespace ccmorse::sim
