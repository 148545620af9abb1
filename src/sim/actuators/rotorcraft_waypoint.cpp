#include "sim/actuators/rotorcraft_waypoint.h"

#include <cmath>
#include <utility>
#include <vector>

#include "base/trig.h"

namespace ccmorse::sim {
namespace {

constexpr double kFarthestGoal = 1e6;  // m

}  // namespace

RotorcraftWaypoint::RotorcraftWaypoint(Robot& robot, const std::string& name,
                                       const scene::Scenario& scenario)
    // rad/m, rad s/m, 1/s^2, 1/s
    : RotorcraftPilot(robot, name, "RotorcraftWaypoint", scenario,
                      {Radians(6.0), Radians(8.0), 8.0, 8.0, 12.0, 6.0}) {
  AddProperty("RemainAtDestination", remain_);
  AddProperty("Target", shown_);
  const std::vector<ServiceParameter> destination = {
      {"x"}, {"y"}, {"z"}, {"yaw"}, {"tolerance", true}};
  AddService({"goto", destination, nullptr, [this](Arguments arguments, Completion done) {
                const Target target = TargetFrom(arguments);
                Finish(Outcome::kPreempted, "");
                pending_ = std::move(done);
                FlyTo(target);
              }});
  AddService({"setdest", destination, [this](Arguments arguments) {
                FlyTo(TargetFrom(arguments));
                return Json(!Arrived());
              }});
  AddQuery({"get_status", {}, [this](Arguments) { return Json(status_); }});
  StayHere();
}

// Nobody is left to answer when the simulation is taken down.
RotorcraftWaypoint::~RotorcraftWaypoint() { pending_ = nullptr; }

RotorcraftWaypoint::Target RotorcraftWaypoint::TargetFrom(Arguments arguments) {
  Target target;
  target.point = {NumberArgument(arguments, 0, "x"), NumberArgument(arguments, 1, "y"),
                  NumberArgument(arguments, 2, "z")};
  target.yaw = NumberArgument(arguments, 3, "yaw");
  target.tolerance = NumberArgument(arguments, 4, "tolerance", 0.2);
  Check(target);
  return target;
}

void RotorcraftWaypoint::Check(const Target& target) {
  if (target.tolerance < 0.0) throw WrongArgument("tolerance must not be negative");
  for (const double part : {target.point.x, target.point.y, target.point.z}) {
    if (std::fabs(part) > kFarthestGoal) throw WrongArgument("that is too far away");
  }
}

void RotorcraftWaypoint::Receive(const Json& message) {
  Target target;
  target.point = {NumberMember(message, "x"), NumberMember(message, "y"),
                  NumberMember(message, "z")};
  target.yaw = NumberMember(message, "yaw");
  if (message.Find("tolerance") != nullptr) target.tolerance = NumberMember(message, "tolerance");
  Check(target);
  FlyTo(target);
}

void RotorcraftWaypoint::FlyTo(const Target& target) {
  target_ = target;
  under_way_ = true;
  status_ = "Transit";
  DataChanged(timestamp());
}

void RotorcraftWaypoint::StayHere() {
  target_.point = robot().position();
  target_.yaw = robot().euler().z;
}

bool RotorcraftWaypoint::Arrived() const {
  const Vec3 off = target_.point - robot().position();
  return std::sqrt(Dot(off, off)) <= target_.tolerance;
}

void RotorcraftWaypoint::Act(const Instant& now) {
  DataChanged(now.time);
  if (under_way_ && Arrived()) {
    under_way_ = false;
    status_ = "Arrived";
    if (!remain_) StayHere();
    Finish(Outcome::kSuccess, status_);
  }
  const auto [s, c] = SinCos(robot().euler().z);
  const Vec3 off = target_.point - robot().position();
  const Vec3 v = robot().velocity();
  // Nose down it goes forwards, left side up to the right.
  const Gains& k = gains();
  const double pitch =
      Bank(k.horizontal_p * (c * off.x + s * off.y) - k.horizontal_d * (c * v.x + s * v.y));
  const double roll =
      -Bank(k.horizontal_p * (c * off.y - s * off.x) - k.horizontal_d * (c * v.y - s * v.x));
  const double up = fall() + k.vertical_p * off.z - k.vertical_d * v.z;
  Fly({roll, pitch, target_.yaw}, up, now.step);
}

void RotorcraftWaypoint::Finish(Outcome outcome, const char* text) {
  if (!pending_) return;
  const Completion done = std::exchange(pending_, nullptr);
  done({outcome, *text != '\0' ? Json(text) : Json()});
}

void RotorcraftWaypoint::Interrupt() {
  StayHere();
  under_way_ = false;
  status_ = "Stop";
  Finish(Outcome::kPreempted, "");
}

void RotorcraftWaypoint::Reset() {
  RotorcraftPilot::Reset();
  Interrupt();
  target_.tolerance = 0.2;
}

void RotorcraftWaypoint::AppendFields(std::string& out) const {
  AppendField(out, "x", target_.point.x);
  AppendField(out, "y", target_.point.y);
  AppendField(out, "z", target_.point.z);
  AppendField(out, "yaw", target_.yaw);
  AppendField(out, "tolerance", target_.tolerance);
}

}  // namespace ccmorse::sim
