#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/pose.h"
#include "base/rotation.h"
#include "scene/robots.h"
#include "scene/scenario.h"
#include "sim/component.h"
#include "sim/ground.h"
#include "sim/physics/kinematics.h"
#include "sim/physics/rigid_world.h"
#include "sim/physics/vehicle.h"

namespace ccmorse::sim {

class Canvas;
class World;

/// Speeds in a robot's own frame.
struct Twist {
  double v = 0.0;     ///< m/s, forward
  double w = 0.0;     ///< rad/s, counter-clockwise
  double side = 0.0;  ///< m/s, to the left; only omnidirectional robots have any
};

/// How fast the wheels of a robot that is driven by two go along the ground, m/s.
struct WheelSpeeds {
  double left = 0.0;
  double right = 0.0;
};

/// What its actuators want of a dynamic robot in the next step.
struct Orders {
  Vec3 force;                         ///< N, world frame, through its origin; of one step
  Vec3 torque;                        ///< Nm, world frame; of one step
  bool replaced = false;              ///< it has been put where it is
  std::optional<WheelSpeeds> wheels;  ///< what drives it; else its command does
  VehicleControl vehicle;
};

/// What a run's report says of one robot.
struct RobotTally {
  double distance = 0.0;       ///< m, path of the robot's origin
  std::uint64_t contacts = 0;  ///< times it ran against something it did not touch before
  double stalled = 0.0;        ///< s, spent blocked
};

/// One robot: its body's state and its devices, which it owns. A kinematic one has the commanded
/// speed at once and stops where it touches something; a dynamic one, whose body says so, is moved
/// by forces (dynamics.h), or, free of them, is where its actuators put it (design: Physics). Not
/// thread safe.
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
  Vec3 position() const { return {pose_.x, pose_.y, stand_.z + height_}; }
  Rotation rotation() const;  ///< of its frame
  Vec3 euler() const;         ///< roll, pitch, yaw, rad
  /// How a kinematic robot stands on uneven ground (World::terrain); level at z = 0 on all other.
  const Stand& stand() const { return stand_; }
  /// How much higher it is than on a level floor at z = 0, m.
  double lift() const { return stand_.z + height_ - model_.origin_height; }
  /// May its frame lie other than level?
  bool tilted() const { return dynamic() || stand_.roll != 0.0 || stand_.pitch != 0.0; }
  /// Where the middle of its footprint is, m, in the world: heights of its hull count from there.
  Vec3 foot() const;
  const Twist& twist() const { return twist_; }  ///< what it really did in the last tick
  bool stalled() const { return stalled_; }      ///< the last tick's motion was blocked
  const RobotTally& tally() const { return tally_; }

  /// twist() in the world's frame, m/s: what a physics engine calls the body's linear velocity.
  Vec3 velocity() const;
  Vec3 spin() const;  ///< rad/s, in the world's frame

  /// Is it somewhere in space, not on the floor?
  bool dynamic() const { return dynamic_; }
  /// Is it a dynamic one that forces do not move?
  bool free() const { return dynamic() && dynamics()->kind == "free"; }
  const scene::DynamicsDef* dynamics() const {
    return def_.body && def_.body->dynamics ? &*def_.body->dynamics : nullptr;
  }
  /// Of a dynamic robot only: where it is and how it moves.
  const RigidState& body() const { return body_; }
  const Vec3& inertia() const { return inertia_; }  ///< kg m^2, about its own axes
  /// What it touches, sorted, but the ground.
  const std::vector<Surface>& touches() const { return touches_; }

  // For actuators of a dynamic robot.
  Orders& orders() { return orders_; }
  const Orders& orders() const { return orders_; }
  /// Adds a force (N) through its origin and a torque (Nm), in the world's frame, for the next
  /// step.
  void Push(const Vec3& force, const Vec3& torque);
  /// The speeds that its wheels are to have from the next step on.
  void CommandWheels(const WheelSpeeds& speeds, const Actuator* by);
  /// Puts it there, with that motion.
  void PlaceInSpace(const RigidState& state);

  /// What became of a dynamic robot in a step.
  void Follow(const RigidState& moved, std::vector<Surface> touches, const Instant& now);

  /// Puts it on uneven ground, which outlives it; before the run. One that is empty has no effect.
  void set_ground(const Ground& ground);

  /// Appends what of the ground's meshes is in its way within `reach` (m) of its origin.
  void FindInTheWay(double reach, std::vector<Obstacle>& found) const;

  /// Speeds from the next physics step on, clamped to the model's limits. `by` is the actuator that
  /// drives from now on: where two are mounted, the one commanded last has the robot.
  void Command(const Twist& twist, const Actuator* by);
  const Actuator* driver() const { return driver_; }
  /// What it was told last, after clamping.
  const Twist& command() const { return command_; }

  /// A robot that is held stays where it is, whatever it is told (MORSE's set_object_dynamics).
  void set_held(bool held) { held_ = held; }
  bool held() const { return held_; }

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
  void Land(double from);
  MotionResult MoveOnGround(const Instant& now, const Twist& told,
                            std::span<const Obstacle* const> obstacles) const;
  Twist Worn(double step);  // what its wheels make of the command
  void PlaceAtStart();
  void Show();  // of body_ what the plane knows of it
  void Register(std::unique_ptr<Sensor> sensor);
  void Register(std::unique_ptr<Actuator> actuator);

  scene::RobotDef def_;
  scene::RobotModel model_;
  Footprint footprint_;
  int index_;
  Pose2 pose_;
  Stand stand_;                     // of a kinematic robot
  double climb_ = 0.0;              // m/s, upwards in the last tick
  const Ground* ground_ = nullptr;  // where it is uneven
  double height_;                   // m, of its origin above where it stands
  RigidState body_;                 // of a dynamic robot
  Vec3 inertia_;                    // kg m^2
  Orders orders_;
  std::vector<Surface> touches_;
  Twist command_;
  double turning_ = 0.0;  // rad/s, of a worn robot: what its motors have come to
  Twist twist_;
  const Actuator* driver_ = nullptr;
  bool stalled_ = false;
  bool held_ = false;
  bool dynamic_;  // as def_ says: asked every tick
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
