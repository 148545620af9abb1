#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/pose.h"
#include "scene/robots.h"
#include "scene/scenario.h"
#include "sim/component.h"
#include "sim/physics/kinematics.h"

namespace ccmorse::sim {

class Canvas;
class World;

/// Speeds in a robot's own frame.
struct Twist {
  double v = 0.0;     ///< m/s, forward
  double w = 0.0;     ///< rad/s, counter-clockwise
  double side = 0.0;  ///< m/s, to the left; only omnidirectional robots have any
};

/// What a run's report says of one robot.
struct RobotTally {
  double distance = 0.0;       ///< m, path of the robot's origin
  std::uint64_t contacts = 0;  ///< times it ran against something it did not touch before
  double stalled = 0.0;        ///< s, spent blocked
};

/// One robot: its body's state and its devices, which it owns. Kinematic: it has the commanded
/// speed at once and stops where it touches something (design: Physics). Not thread safe.
class Robot {
 public:
  /// `index` is its place among the simulation's robots, ordered by name.
  Robot(const scene::RobotDef& def, int index);

  const std::string& name() const { return def_.name; }
  const scene::RobotDef& def() const { return def_; }
  const scene::RobotModel& model() const { return model_; }
  const Footprint& footprint() const { return footprint_; }
  int index() const { return index_; }

  const Pose2& pose() const { return pose_; }
  Vec3 position() const { return {pose_.x, pose_.y, model_.origin_height}; }
  const Twist& twist() const { return twist_; }  ///< what it really did in the last tick
  bool stalled() const { return stalled_; }      ///< the last tick's motion was blocked
  const RobotTally& tally() const { return tally_; }

  /// twist() in the world's frame, m/s: what a physics engine calls the body's linear velocity.
  Vec3 velocity() const;

  /// Speeds from the next physics step on, clamped to the model's limits. `by` is the actuator that
  /// drives from now on: where two are mounted, the one commanded last has the robot.
  void Command(const Twist& twist, const Actuator* by);
  const Actuator* driver() const { return driver_; }

  /// One physics step among the given obstacles.
  void Move(const Instant& now, std::span<const Obstacle* const> obstacles);

  /// Puts the robot somewhere, standing still.
  void Place(const Pose2& pose);

  /// Turns it on the spot, rad, whatever it is doing.
  void Orient(double yaw);

  /// Its outline for others to run into, at the current pose.
  const Obstacle& outline() const;

  /// Adds a device; it belongs to the robot. Returns it.
  template <typename T>
  T& Add(std::unique_ptr<T> device) {
    T& added = *device;
    Register(std::move(device));
    return added;
  }
  const std::vector<std::unique_ptr<Component>>& components() const { return components_; }
  const std::vector<Sensor*>& sensors() const { return sensors_; }
  const std::vector<Actuator*>& actuators() const { return actuators_; }

  /// Pose, devices and tally as at the start.
  void Reset();

  StateHash& hash() { return hash_; }
  const StateHash& hash() const { return hash_; }

 private:
  void Register(std::unique_ptr<Sensor> sensor);
  void Register(std::unique_ptr<Actuator> actuator);

  scene::RobotDef def_;
  scene::RobotModel model_;
  Footprint footprint_;
  int index_;
  Pose2 pose_;
  Twist command_;
  Twist twist_;
  const Actuator* driver_ = nullptr;
  bool stalled_ = false;
  RobotTally tally_;
  mutable Obstacle outline_;         // placed when somebody asks
  mutable bool outline_old_ = true;  // it is where the robot was
  StateHash hash_;
  std::vector<std::unique_ptr<Component>> components_;
  std::vector<Sensor*> sensors_;
  std::vector<Actuator*> actuators_;
};

/// Mounts the devices of the robot's type (thesis 4.1.2: "all S1R carry the same devices").
void Equip(Robot& robot, const scene::Scenario& scenario, World& world, Canvas& canvas);

}  // namespace ccmorse::sim
