#include "sim/actuators/stabilized_quadrotor.h"

#include <cmath>

#include "base/error.h"
#include "sim/actuators/body_forces.h"

namespace ccmorse::sim {
namespace {

// The model's own numbers (specs: morse.md B.3).
constexpr double kFrequency = 10.0;  // rad/s
constexpr double kDamping = 0.7;
constexpr double kGravity = 10.0;  // m/s^2
constexpr double kHeightP = 9.0;   // 1/s^2
constexpr double kHeightD = 4.2;   // 1/s
constexpr double kMost = 1e4;      // rad, rad/s or m

}  // namespace

void StabilizedQuadrotor::Filter::Step(double wanted, double seconds) {
  rate +=
      seconds * (kFrequency * kFrequency * (wanted - value) - 2.0 * kDamping * kFrequency * rate);
  value += seconds * rate;
}

StabilizedQuadrotor::StabilizedQuadrotor(Robot& robot, const std::string& name)
    : Actuator(robot, name, "StabilizedQuadrotor", 60.0) {
  NeedBody(*this);
  if (!robot.free()) {
    throw Error(full_name() +
                ": a StabilizedQuadrotor flies without physics; give its robot's 'dynamics' the "
                "'kind' \"free\"");
  }
  AddService({"set_cons", {{"phi"}, {"theta"}, {"psi"}, {"h"}}, [this](Arguments arguments) {
                Set({NumberArgument(arguments, 1, "theta"), NumberArgument(arguments, 0, "phi"),
                     NumberArgument(arguments, 2, "psi"), NumberArgument(arguments, 3, "h")});
                return Json();
              }});
  AddService({"stop", {}, [this](Arguments) {
                Set({});
                return Json();
              }});
}

void StabilizedQuadrotor::Receive(const Json& message) {
  Set({NumberMember(message, "theta_c"), NumberMember(message, "phi_c"),
       NumberMember(message, "psi_c"), NumberMember(message, "h_c")});
}

void StabilizedQuadrotor::Set(const Wanted& wanted) {
  for (const double one : {wanted.theta, wanted.phi, wanted.psi, wanted.h}) {
    if (!(std::fabs(one) <= kMost)) throw WrongArgument("that is too much");
  }
  wanted_ = wanted;
  DataChanged(timestamp());
}

void StabilizedQuadrotor::Act(const Instant& now) {
  DataChanged(now.time);
  const Rotation before = robot().rotation();
  RigidState state = robot().body();
  theta_.Step(wanted_.theta, now.step);
  phi_.Step(wanted_.phi, now.step);
  wanted_psi_ -= wanted_.psi * now.step;
  psi_.Step(wanted_psi_, now.step);
  state.rotation = FromEuler(phi_.value, theta_.value, psi_.value);
  const double thrust =
      kGravity + kHeightP * (wanted_.h - state.position.z) - kHeightD * state.velocity.z;  // m/s^2
  state.velocity =
      state.velocity + now.step * (thrust * state.rotation.z - Vec3{0.0, 0.0, kGravity});
  state.position = state.position + now.step * state.velocity;
  // The rates of the angles, each about its own axis.
  state.spin = Vec3{0.0, 0.0, psi_.rate} +
               Rotate(FromEuler(0.0, 0.0, psi_.value), {0.0, theta_.rate, 0.0}) +
               phi_.rate * before.x;
  robot().PlaceInSpace(state);
}

void StabilizedQuadrotor::Reset() {
  Actuator::Reset();
  wanted_ = {};
  theta_ = {robot().euler().y, 0.0};
  phi_ = {robot().euler().x, 0.0};
  psi_ = {robot().euler().z, 0.0};
  wanted_psi_ = psi_.value;
}

void StabilizedQuadrotor::AppendFields(std::string& out) const {
  AppendField(out, "theta_c", wanted_.theta);
  AppendField(out, "phi_c", wanted_.phi);
  AppendField(out, "psi_c", wanted_.psi);
  AppendField(out, "h_c", wanted_.h);
}

}  // namespace ccmorse::sim
