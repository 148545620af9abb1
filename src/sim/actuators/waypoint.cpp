#include "sim/actuators/waypoint.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/trig.h"

namespace ccmorse::sim {
namespace {

constexpr double kAngleTolerance = 10.0 * kPi / 180.0;  // as delivered
constexpr double kTurnOnly = 60.0 * kPi / 180.0;

}  // namespace

Waypoint::Waypoint(Robot& robot, const std::string& name)
    : Actuator(robot, name, "Waypoint", 60.0), angle_tolerance_(kAngleTolerance) {
  AddProperty("ObstacleAvoidance", avoids_);
  AddProperty("FreeZ", free_z_);
  AddProperty("AngleTolerance", angle_tolerance_, 0.0, kPi);
  AddProperty("Speed", speed_, 0.0, 1e6);
  AddProperty("Target", shown_at_);
  AddProperty("Ignore", ignored_);
  AddProperty("ControlType", control_, {"Velocity", "Position"});
  AddProperty("RemainAtDestination", remain_);
  target_.point = {robot.pose().x, robot.pose().y};
  const std::vector<ServiceParameter> destination = {
      {"x"}, {"y"}, {"z"}, {"tolerance", true}, {"speed", true}};
  AddService({"goto", destination, nullptr, [this](Arguments arguments, Completion done) {
                const Target target = TargetFrom(arguments);
                Finish(Outcome::kPreempted, "");
                pending_ = std::move(done);
                DriveTo(target);
              }});
  AddService({"setdest", destination, [this](Arguments arguments) {
                DriveTo(TargetFrom(arguments));
                return Json(!Arrived());
              }});
  AddService({"stop", {}, [this](Arguments) {
                paused_ = true;
                status_ = "Stop";
                if (this->robot().driver() == this) this->robot().Command({}, this);
                return Json();
              }});
  AddService({"resume", {}, [this](Arguments) {
                if (!paused_) return Json();
                paused_ = false;
                if (has_target_) DriveTo(target_);
                return Json();
              }});
  AddQuery({"get_status", {}, [this](Arguments) { return Json(status_); }});
}

// Nobody is left to answer when the simulation is taken down.
Waypoint::~Waypoint() { pending_ = nullptr; }

Waypoint::Target Waypoint::TargetFrom(Arguments arguments) {
  Target target;
  target.point = {NumberArgument(arguments, 0, "x"), NumberArgument(arguments, 1, "y")};
  target.z = NumberArgument(arguments, 2, "z");
  target.tolerance = NumberArgument(arguments, 3, "tolerance", 0.5);
  target.speed = NumberArgument(arguments, 4, "speed", 1.0);
  Check(target);
  return target;
}

void Waypoint::Check(const Target& target) {
  if (target.tolerance < 0.0) throw WrongArgument("tolerance must not be negative");
  if (target.speed < 0.0) throw WrongArgument("speed must not be negative");
}

void Waypoint::Receive(const Json& message) {
  Target target;
  target.point = {NumberMember(message, "x"), NumberMember(message, "y")};
  target.z = message.Find("z") != nullptr ? NumberMember(message, "z") : 0.0;
  target.tolerance =
      message.Find("tolerance") != nullptr ? NumberMember(message, "tolerance") : 0.5;
  target.speed = message.Find("speed") != nullptr ? NumberMember(message, "speed") : speed_;
  Check(target);
  DriveTo(target);
}

void Waypoint::DriveTo(const Target& target) {
  target_ = target;
  has_target_ = true;
  paused_ = false;
  status_ = "Transit";
  DataChanged(timestamp());
  robot().Command({}, this);
}

bool Waypoint::Arrived() const {
  const Vec2 d = target_.point - Vec2{robot().pose().x, robot().pose().y};
  const double up = free_z_ ? target_.z - robot().position().z : 0.0;
  return std::sqrt(Dot(d, d) + up * up) <= target_.tolerance;
}

void Waypoint::Act(const Instant& now) {
  DataChanged(now.time);
  if (!has_target_ || paused_ || robot().driver() != this) return;
  if (Arrived()) {
    has_target_ = remain_;
    status_ = "Arrived";
    robot().Command({}, this);
    Finish(Outcome::kSuccess, status_);
    return;
  }
  const Pose2& pose = robot().pose();
  const Vec2 d = target_.point - Vec2{pose.x, pose.y};
  const double turn = NormalizeAngle(Atan2(d.y, d.x) - pose.yaw);
  const double turn_rate = target_.speed / 2.0;
  double w = 0.0;
  if (std::fabs(turn) > angle_tolerance_) {
    w = std::min(turn_rate, std::fabs(turn) / now.step) * (turn > 0.0 ? 1.0 : -1.0);
  }
  const double v =
      std::fabs(turn) >= kTurnOnly ? 0.0 : std::min(target_.speed, std::sqrt(Dot(d, d)) / now.step);
  robot().Command({v, w}, this);
}

void Waypoint::Finish(Outcome outcome, const char* text) {
  if (!pending_) return;
  const Completion done = std::exchange(pending_, nullptr);
  done({outcome, *text != '\0' ? Json(text) : Json()});
}

void Waypoint::Interrupt() {
  has_target_ = false;
  status_ = "Stop";
  if (robot().driver() == this) robot().Command({}, this);
  Finish(Outcome::kPreempted, "");
}

void Waypoint::Reset() {
  Actuator::Reset();
  Interrupt();
  target_ = {};
  target_.point = {robot().pose().x, robot().pose().y};
  paused_ = false;
}

void Waypoint::AppendFields(std::string& out) const {
  AppendField(out, "x", target_.point.x);
  AppendField(out, "y", target_.point.y);
  AppendField(out, "z", target_.z);
  AppendField(out, "tolerance", target_.tolerance);
  AppendField(out, "speed", target_.speed);
}

}  // namespace ccmorse::sim
