#pragma once

#include "base/json.h"
#include "base/pose.h"
#include "sim/component.h"
#include "sim/robots/robot.h"

// What actuators that push their robot have in common.

namespace ccmorse::sim {

constexpr double kMostForce = 1e9;  ///< N or Nm: more of either is refused
constexpr double kMostGain = 1e4;   ///< of a controller, in its units

/// Throws Error unless the component's robot is dynamic: no other can be pushed.
void NeedBody(const Component& component);

/// Three finite numbers as member `key` of a message, each within +/- kMostForce. Throws
/// WrongArgument that names the key.
Vec3 VectorMember(const Json& object, const char* key);

/// m/s^2 by which the robot falls where nothing holds it: less than gravity, where that is taken
/// from it (scene::DynamicsDef::gravity).
double FallOf(const Robot& robot, const scene::Scenario& scenario);

/// A controller with a proportional and a derivative part. The derivative is that of the error from
/// one tick to the next; of the first there is none.
class PdLoop {
 public:
  /// `step`: s since the last call.
  double Update(double error, double p_gain, double d_gain, double step);
  void Reset() { is_new_ = true; }

 private:
  double before_ = 0.0;
  bool is_new_ = true;
};

/// Turns a rotorcraft: torques about its axes that bring roll, pitch and yaw where they are to be,
/// by its inertia (specs: morse.md B.3: "torque = inertia (kp err + kd derr freq)").
class AttitudeLoops {
 public:
  struct Gains {
    double roll_pitch_p, roll_pitch_d, yaw_p, yaw_d;
  };
  /// Pushes the robot with `share` of the torques; `wanted`: roll, pitch, yaw, rad.
  void Turn(Robot& robot, const Vec3& wanted, const Gains& gains, double share, double step);
  void Reset();

 private:
  PdLoop roll_;
  PdLoop pitch_;
  PdLoop yaw_;
};

}  // namespace ccmorse::sim
