#pragma once

#include "scene/scenario.h"
#include "sim/physics/rigid_world.h"

namespace ccmorse::sim {

/// What a driver does with a vehicle.
struct VehicleControl {
  double steer = 0.0;        ///< rad, of the front wheels, positive to the left
  double engine = 0.0;       ///< N forwards, of each of the four wheels
  double front_brake = 0.0;  ///< Ns a step at most, of each front wheel
  double rear_brake = 0.0;   ///< likewise
};

/// Moves a rigid body on four wheels that are rays: each has a spring, and where its ray meets the
/// ground the forces of engine, brake and grip, bounded by its load. The model of the vehicles that
/// Bullet brings, which is MORSE's Hummer (specs: morse.md H.1), over our own sines. Not thread
/// safe.
class Vehicle {
 public:
  /// The world outlives it; `mass` kg and `inertia` kg m^2 are the body's.
  Vehicle(RigidWorld& world, RigidWorld::Body body, double mass, const Vec3& inertia,
          const scene::VehicleDef& def);

  /// Adds this step's forces of the wheels.
  void Push(const VehicleControl& control, double seconds);

 private:
  RigidWorld& world_;
  RigidWorld::Body body_;
  double mass_;
  Vec3 inertia_;
  scene::VehicleDef def_;
};

}  // namespace ccmorse::sim
