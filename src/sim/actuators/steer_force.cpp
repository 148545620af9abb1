#include "sim/actuators/steer_force.h"

#include <algorithm>
#include <cmath>

#include "base/log.h"
#include "base/trig.h"
#include "sim/actuators/body_forces.h"

namespace ccmorse::sim {
namespace {

// What of the force and of the brake gets to a wheel (specs: morse.md B.3).
constexpr double kEngine = 0.4;
constexpr double kFrontBrake = 0.1;
constexpr double kRearBrake = 1.3;

}  // namespace

SteerForce::SteerForce(Robot& robot, const std::string& name)
    : Actuator(robot, name, "SteerForce", 60.0) {
  NeedBody(*this);
  if (!robot.dynamics()->vehicle) {
    LogWarning("{}: the robot is no vehicle, and nothing comes of steering it", full_name());
  }
}

void SteerForce::Receive(const Json& message) {
  const double steer = NumberMember(message, "steer");
  const double force = NumberMember(message, "force");
  const double brake = NumberMember(message, "brake");
  if (std::fabs(steer) > kPi / 2.0) throw WrongArgument("'steer' must be within pi/2");
  if (std::fabs(force) > kMostForce) throw WrongArgument("'force' is too much");
  if (std::fabs(brake) > kMostForce) throw WrongArgument("'brake' is too much");
  steer_ = steer;
  force_ = force;
  brake_ = brake;
  DataChanged(timestamp());
}

void SteerForce::Act(const Instant& now) {
  DataChanged(now.time);
  const double brake = std::max(0.0, brake_);
  robot().orders().vehicle = {steer_, -kEngine * force_, kFrontBrake * brake, kRearBrake * brake};
}

void SteerForce::Reset() {
  Actuator::Reset();
  steer_ = 0.0;
  force_ = 0.0;
  brake_ = 0.0;
}

void SteerForce::AppendFields(std::string& out) const {
  AppendField(out, "steer", steer_);
  AppendField(out, "force", force_);
  AppendField(out, "brake", brake_);
}

}  // namespace ccmorse::sim
