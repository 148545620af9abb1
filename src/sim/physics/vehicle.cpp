#include "sim/physics/vehicle.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/trig.h"

namespace ccmorse::sim {
namespace {

constexpr double kTravel = 5.0;     // m: how far a spring can be stretched or pressed together
constexpr double kMostLoad = 6000;  // N of a wheel
constexpr double kGrip = 0.2;       // of its speed sideways that one wheel takes away in a step
constexpr double kAlong = 0.5;      // how much force forwards counts for slipping, next to sideways

struct Contact {
  bool on_ground = false;
  Vec3 point;         // m, world
  Vec3 normal;        // of the ground
  Vec3 forward;       // along the ground
  Vec3 axle;          // along the ground, to the left
  Vec3 velocity;      // m/s, of the body there
  double load = 0.0;  // N
};

Vec3 Unit(const Vec3& v) { return (1.0 / std::sqrt(Dot(v, v))) * v; }

}  // namespace

Vehicle::Vehicle(RigidWorld& world, RigidWorld::Body body, double mass, const Vec3& inertia,
                 const scene::VehicleDef& def)
    : world_(world), body_(body), mass_(mass), inertia_(inertia), def_(def) {}

void Vehicle::Push(const VehicleControl& control, double seconds) {
  const RigidState state = world_.state(body_);
  const Vec3 down = -1.0 * state.rotation.z;
  const auto [s, c] = SinCos(control.steer);
  std::array<Contact, 4> wheels;  // front left, front right, rear left, rear right
  int on_ground = 0;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    Contact& wheel = wheels[i];
    const bool front = i < 2;
    const Vec3 fixed{front ? def_.front : def_.rear,
                     i % 2 == 0 ? def_.half_track : -def_.half_track, def_.height};
    const Vec3 from = state.position + Rotate(state.rotation, fixed);
    const double reach = def_.rest_length + def_.wheel_radius;
    const RigidWorld::Hit hit = world_.Cast(from, from + reach * down, body_);
    if (!hit.any) continue;
    wheel.on_ground = true;
    ++on_ground;
    wheel.point = from + (hit.share * reach) * down;
    wheel.normal = hit.normal;
    const Vec3 arm = wheel.point - state.position;
    wheel.velocity = state.velocity + Cross(state.spin, arm);
    const Vec3 axle = Rotate(state.rotation, front ? Vec3{-s, c, 0.0} : Vec3{0.0, 1.0, 0.0});
    wheel.axle = Unit(axle - Dot(axle, wheel.normal) * wheel.normal);
    wheel.forward = Cross(wheel.axle, wheel.normal);

    // The spring presses along itself; what of it is along the ground the ground does not feel.
    const double length = std::clamp(hit.share * reach - def_.wheel_radius,
                                     def_.rest_length - kTravel, def_.rest_length + kTravel);
    const double against = -Dot(wheel.normal, down);
    const double share = against > 0.1 ? 1.0 / against : 10.0;
    const double stretching = against > 0.1 ? share * Dot(wheel.normal, wheel.velocity) : 0.0;
    const double damping = stretching < 0.0 ? def_.compression : def_.damping;
    const double force =
        mass_ * (def_.stiffness * (def_.rest_length - length) * share - damping * stretching);
    wheel.load = std::clamp(force, 0.0, kMostLoad);
    world_.PushAt(body_, wheel.load * wheel.normal, wheel.point);
  }

  // The mass that a push at `arm` along `way` meets.
  const auto felt = [&](const Vec3& arm, const Vec3& way) {
    const Vec3 turning = RotateBack(state.rotation, Cross(arm, way));
    const double spin = turning.x * turning.x / inertia_.x + turning.y * turning.y / inertia_.y +
                        turning.z * turning.z / inertia_.z;
    return 1.0 / (1.0 / mass_ + spin);
  };
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const Contact& wheel = wheels[i];
    if (!wheel.on_ground) continue;
    const Vec3 arm = wheel.point - state.position;
    double across = -kGrip * Dot(wheel.velocity, wheel.axle) * felt(arm, wheel.axle);  // Ns
    double along = control.engine * seconds;
    const double brake = i < 2 ? control.front_brake : control.rear_brake;
    if (control.engine == 0.0) {
      const double stop =
          -Dot(wheel.velocity, wheel.forward) * felt(arm, wheel.forward) / on_ground;
      along = std::clamp(stop, -brake, brake);
    }
    const double most = wheel.load * seconds * def_.friction;
    const double asked = std::sqrt(kAlong * kAlong * along * along + across * across);
    if (asked > most) {
      along *= most / asked;
      across *= most / asked;
    }
    world_.PushAt(body_, (along / seconds) * wheel.forward, wheel.point);
    // Sideways nearer to the height of the centre of mass, so that curves do not tip it over.
    const Vec3 up = state.rotation.z;
    const Vec3 point = wheel.point - ((1.0 - def_.roll_influence) * Dot(up, arm)) * up;
    world_.PushAt(body_, (across / seconds) * wheel.axle, point);
  }
}

}  // namespace ccmorse::sim
