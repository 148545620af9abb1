#pragma once

#include <optional>
#include <string>

#include "base/pose.h"
#include "base/rotation.h"
#include "sim/component.h"

namespace ccmorse::sim {

/// Where a component is in the world.
struct MountPlace {
  Vec3 position;      ///< m
  Rotation rotation;  ///< of its frame
  Vec3 euler;         ///< the same as roll, pitch, yaw, rad, yaw in (-pi, pi]
};

/// Where the component is now: its robot's pose and its mount.
MountPlace PlaceOfMount(const Component& component);

/// What a sensor of motion knows of its own, once for all that need it (specs: morse.md B.2,
/// "Mode Velocity", "Mode Position"). Speeds are those of the robot's last step, or the differences
/// of places from one activation to the next, as ComputationMode says: "Automatic" is "Velocity",
/// as all robots have a body. One thread at a time.
class SensorMotion {
 public:
  /// One activation.
  struct State {
    MountPlace place;
    double step = 0.0;        ///< s since the last activation; 0 at the first
    double distance = 0.0;    ///< m, from there to here
    Vec3 velocity;            ///< m/s, of the robot or the sensor by the mode, in the world
    Vec3 acceleration;        ///< m/s^2, its change since the last activation, in the world
    Vec3 angular_velocity;    ///< rad/s, in the sensor's frame
    Vec3 lever_acceleration;  ///< m/s^2, of the sensor about the robot's origin, in its frame
  };

  explicit SensorMotion(const Component& component) : component_(component) {}

  /// The values that the property may have.
  static std::vector<std::string> Modes() { return {"Automatic", "Velocity", "Position"}; }

  /// To be called once an activation, with ComputationMode.
  const State& Update(const Instant& now, const std::string& mode);
  const State& state() const { return state_; }
  void Reset();

 private:
  void ByVelocity();
  void ByPosition(const MountPlace& before);

  const Component& component_;
  State state_;
  double last_time_ = 0.0;
  Vec3 last_spin_;             // rad/s, of the robot, in its frame
  bool moved_before_ = false;  // there is an activation to compare with
};

}  // namespace ccmorse::sim
