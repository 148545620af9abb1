#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "scene/scenario.h"
#include "sim/component.h"
#include "sim/physics/rigid_world.h"
#include "sim/physics/vehicle.h"

namespace ccmorse::sim {

class Robot;
class World;

/// Moves the dynamic robots of a simulation by forces: gravity, contact, friction and damping with
/// MORSE's constants, and what their actuators ask for (specs: morse.md H.2). They meet the boxes
/// that stand, the meshes, each other, and kinematic robots, which nothing pushes. One thread.
class Dynamics {
 public:
  /// World and robots outlive it. `frequency`: ticks a second.
  Dynamics(const World& world, const std::vector<std::unique_ptr<Robot>>& robots,
           const scene::PhysicsDef& physics, double frequency);
  ~Dynamics();

  /// One tick: its substeps. To be called when the kinematic robots have moved.
  void Step(const Instant& now);

  /// Everything anew, from where the robots are.
  void Reset();

 private:
  struct Mover;  // a robot in the engine

  void Build();
  void Stand();
  void Order(Mover& mover, double seconds);
  void PutBack(Mover& mover);
  void Report(Mover& mover, const Instant& now);

  const World& world_;
  const std::vector<std::unique_ptr<Robot>>& robots_;
  scene::PhysicsDef physics_;
  int substeps_;
  std::unique_ptr<RigidWorld> bodies_;
  std::vector<Mover> movers_;
  std::uint64_t revision_ = 0;  // of the world that stands in bodies_
};

}  // namespace ccmorse::sim
