#include "sim/actuators/rotorcraft_waypoint.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/trig.h"

namespace ccmorse::sim {
namespace {

constexpr double kMostGain = 1e4;
constexpr double kFarthest = 1e6;  // m

}  // namespace

RotorcraftWaypoint::RotorcraftWaypoint(Robot& robot, const std::string& name,
                                       const scene::Scenario& scenario)
    : Actuator(robot, name, "RotorcraftWaypoint", 60.0),
      horizontal_p_(Radians(6.0)),
      horizontal_d_(Radians(8.0)),
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
    if (std::fabs(part) > kFarthest) throw WrongArgument("that is too far away");
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
  const auto bank = [this](double angle) { return std::clamp(angle, -max_bank_, max_bank_); };
  const auto [s, c] = SinCos(robot().euler().z);
  const Vec3 off = target_.point - robot().position();
  const Vec3 v = robot().velocity();
  // Nose down it goes forwards, left side up to the right.
  const double pitch =
      bank(horizontal_p_ * (c * off.x + s * off.y) - horizontal_d_ * (c * v.x + s * v.y));
  const double roll =
      -bank(horizontal_p_ * (c * off.y - s * off.x) - horizontal_d_ * (c * v.y - s * v.x));
  const double up = fall_ + vertical_p_ * off.z - vertical_d_ * v.z;
  const double upright = std::max(0.1, robot().rotation().z.z);
  const double lift = robot().model().mass * std::max(0.0, up) / upright;
  robot().Push(lift * robot().rotation().z, {});
  loops_.Turn(robot(), {roll, pitch, target_.yaw}, {roll_pitch_p_, roll_pitch_d_, yaw_p_, yaw_d_},
              1.0, now.step);
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
  Actuator::Reset();
  Interrupt();
  target_.tolerance = 0.2;
  loops_.Reset();
}

void RotorcraftWaypoint::AppendFields(std::string& out) const {
  AppendField(out, "x", target_.point.x);
  AppendField(out, "y", target_.point.y);
  AppendField(out, "z", target_.point.z);
  AppendField(out, "yaw", target_.yaw);
  AppendField(out, "tolerance", target_.tolerance);
}

}  // namespace ccmorse::sim
