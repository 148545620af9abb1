#include "sim/actuators/quadrotor_dynamic_control.h"

#include <cmath>

#include "base/trig.h"
#include "sim/actuators/body_forces.h"

namespace ccmorse::sim {
namespace {

constexpr double kFastest = 1e5;  // rad/s

}  // namespace

QuadrotorDynamicControl::QuadrotorDynamicControl(Robot& robot, const std::string& name)
    : Actuator(robot, name, "QuadrotorDynamicControl", 60.0) {
  NeedBody(*this);
  AddProperty("ThrustFactor", thrust_, 0.0, 1.0);
  AddProperty("DragFactor", drag_, 0.0, 1.0);
  AddProperty("Lever", lever_, 0.0, 100.0);
  AddProperty("Configuration", configuration_, {"+", "x"});
}

void QuadrotorDynamicControl::Receive(const Json& message) {
  const Json* const given = message.Find("engines");
  const auto wrong = [] { return WrongArgument("'engines' must be a list of four speeds, rad/s"); };
  if (given == nullptr || !given->IsArray() || given->AsArray().size() != engines_.size()) {
    throw wrong();
  }
  std::array<double, 4> engines{};
  for (std::size_t i = 0; i < engines.size(); ++i) {
    const Json& one = given->AsArray()[i];
    if (!one.IsNumber() || !(std::fabs(one.AsDouble()) <= kFastest)) throw wrong();
    engines[i] = one.AsDouble();
  }
  engines_ = engines;
  DataChanged(timestamp());
}

void QuadrotorDynamicControl::Act(const Instant& now) {
  DataChanged(now.time);
  Vec3 force;
  Vec3 torque;
  for (std::size_t i = 0; i < engines_.size(); ++i) {
    const double square = engines_[i] * engines_[i];
    const double bearing =
        (configuration_ == "x" ? kPi / 4.0 : 0.0) - static_cast<double>(i) * kPi / 2.0;
    const auto [s, c] = SinCos(bearing);
    const Vec3 lift{0.0, 0.0, thrust_ * square};
    force = force + lift;
    torque = torque + Cross({lever_ * c, lever_ * s, 0.0}, lift);
    torque.z += (i % 2 == 0 ? 1.0 : -1.0) * drag_ * square;
  }
  robot().Push(Rotate(robot().rotation(), force), Rotate(robot().rotation(), torque));
}

void QuadrotorDynamicControl::Reset() {
  Actuator::Reset();
  engines_ = {};
}

void QuadrotorDynamicControl::AppendFields(std::string& out) const {
  out += ", \"engines\": [";
  for (std::size_t i = 0; i < engines_.size(); ++i) {
    if (i > 0) out += ", ";
    AppendJson(out, engines_[i]);
  }
  out += ']';
}

}  // namespace ccmorse::sim
