#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scenario.h"
#include "sim/arena_controller.h"
#include "sim/canvas.h"
#include "sim/component.h"
#include "sim/physics/dynamics.h"
#include "sim/physics/fleet_motion.h"
#include "sim/robots/robot.h"
#include "sim/worker_pool.h"
#include "sim/world.h"

namespace ccmorse::sim {

/// A scenario that lives: its world, robots and canvas, advanced tick by tick. It knows neither
/// sockets nor wall-clock time. Same scenario + same commands at the same ticks = same bytes,
/// whatever the number of threads. One thread at a time may use it.
class Simulation {
 public:
  /// `threads` share the work of a tick where there is enough of it; 0: as many as the machine and
  /// the number of robots make sensible. They change nothing but the time it takes. `share_all`,
  /// for tests: they share every tick's, however little. Throws Error when the scenario cannot be
  /// (it was checked when it was read).
  explicit Simulation(scene::Scenario scenario, int threads = 0, bool share_all = false);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  const scene::Scenario& scenario() const { return scenario_; }
  std::uint64_t tick() const { return tick_; }
  /// Simulated seconds since the start.
  double time() const { return static_cast<double>(tick_) / scenario_.time.frequency; }

  /// The two halves of a tick (design: Time): first the sensors that are due read the world as it
  /// is at time(); then actuators act, the physics takes one step and time() moves on. Commands
  /// given in between answer what the sensors saw, without delay.
  void Sense();
  void Act();

  /// Sensors that took a sample in the last Sense(), ordered by robot, then as mounted.
  const std::vector<Sensor*>& sampled() const { return sampled_; }

  const std::vector<std::unique_ptr<Robot>>& robots() const { return robots_; }  ///< by name
  /// nullptr when there is none.
  Robot* FindRobot(std::string_view name) const;
  /// By full name, "s1r.pose"; nullptr when there is none.
  Component* FindComponent(std::string_view full_name) const;
  /// All of them, by full name.
  const std::vector<Component*>& components() const { return components_; }

  World& world() { return world_; }
  const World& world() const { return world_; }
  Canvas& canvas() { return canvas_; }
  const Canvas& canvas() const { return canvas_; }

  /// What raises, lowers and moves dynamic boxes.
  ArenaController& arena() { return *arena_; }
  const ArenaController& arena() const { return *arena_; }

  /// Robots, devices and dynamic boxes as at the start; time goes on (MORSE's reset_objects).
  void ResetObjects();

  /// Called in each Act() when actuators have acted, just before the robots move: what of a scene
  /// is simulated elsewhere is put in its place there. Throws what it throws.
  void set_before_motion(std::function<void()> hook) { before_motion_ = std::move(hook); }

  /// With physics off, actuators act but nothing moves (MORSE's suspend_dynamics).
  void set_physics(bool on) { physics_ = on; }

  /// Hash of all that has been: poses, speeds and every sensor sample of every tick, and the canvas
  /// as it is. Does not depend on the order in which robots were declared.
  std::uint64_t Hash() const;

 private:
  Instant Now() const { return {tick_, time(), 1.0 / scenario_.time.frequency}; }

  scene::Scenario scenario_;
  World world_;
  Canvas canvas_;
  std::vector<std::unique_ptr<Robot>> robots_;
  std::vector<Component*> components_;
  std::vector<Sensor*> sampled_;
  WorkerPool pool_;
  std::int64_t shared_from_;  // work of a tick's sensors, Sensor::Work()
  std::optional<FleetMotion> motion_;
  std::optional<Dynamics> dynamics_;  // where a robot is dynamic
  std::optional<ArenaController> arena_;
  std::function<void()> before_motion_;
  std::uint64_t tick_ = 0;
  bool physics_ = true;
};

}  // namespace ccmorse::sim
