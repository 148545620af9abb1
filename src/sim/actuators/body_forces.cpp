#include "sim/actuators/body_forces.h"

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/trig.h"

namespace ccmorse::sim {

void NeedBody(const Component& component) {
  if (component.robot().dynamic()) return;
  throw Error(component.full_name() + ": a " + component.type() +
              " needs a robot that forces move; add 'dynamics' to its 'body'");
}

Vec3 VectorMember(const Json& object, const char* key) {
  const Json* const value = object.Find(key);
  const auto wrong = [key] {
    return WrongArgument(std::string("'") + key + "' must be a list of three numbers");
  };
  if (value == nullptr || !value->IsArray() || value->AsArray().size() != 3) throw wrong();
  const auto number = [&](std::size_t i) {
    const Json& one = value->AsArray()[i];
    if (!one.IsNumber() || !(std::fabs(one.AsDouble()) <= kMostForce)) throw wrong();
    return one.AsDouble();
  };
  return {number(0), number(1), number(2)};
}

double FallOf(const Robot& robot, const scene::Scenario& scenario) {
  const double gravity = scenario.physics.value_or(scene::PhysicsDef{}).gravity;
  return robot.dynamics()->gravity ? gravity : gravity - gravity / robot.model().mass;
}

double PdLoop::Update(double error, double p_gain, double d_gain, double step) {
  const double rate = is_new_ || step <= 0.0 ? 0.0 : (error - before_) / step;
  before_ = error;
  is_new_ = false;
  return p_gain * error + d_gain * rate;
}

void AttitudeLoops::Turn(Robot& robot, const Vec3& wanted, const Gains& gains, double share,
                         double step) {
  const Vec3 is = robot.euler();
  const Vec3& inertia = robot.inertia();
  const Vec3 torque{
      inertia.x * roll_.Update(NormalizeAngle(wanted.x - is.x), gains.roll_pitch_p,
                               gains.roll_pitch_d, step),
      inertia.y * pitch_.Update(NormalizeAngle(wanted.y - is.y), gains.roll_pitch_p,
                                gains.roll_pitch_d, step),
      inertia.z * yaw_.Update(NormalizeAngle(wanted.z - is.z), gains.yaw_p, gains.yaw_d, step)};
  robot.Push({}, Rotate(robot.rotation(), share * torque));
}

void AttitudeLoops::Reset() {
  roll_.Reset();
  pitch_.Reset();
  yaw_.Reset();
}

}  // namespace ccmorse::sim
