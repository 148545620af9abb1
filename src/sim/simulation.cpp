#include "sim/simulation.h"

#include <algorithm>
#include <cmath>
#include <thread>

namespace ccmorse::sim {
namespace {

constexpr std::size_t kFleet = 8;          // robots from which on threads are worth their trouble
constexpr std::int64_t kShared = 16384;    // beams, or as much work, from which on threads share it
constexpr std::size_t kSharedMotion = 64;  // robots, likewise

int Threads(int asked, std::size_t robots) {
  if (asked > 0) return asked;
  if (robots < kFleet) return 1;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

Simulation::Simulation(scene::Scenario scenario, int threads, bool share_all)
    : scenario_(std::move(scenario)),
      world_(scenario_.world),
      canvas_(scenario_.canvas, scenario_.world.size_x, scenario_.world.size_y),
      pool_(Threads(threads, scenario_.robots.size())),
      shared_from_(share_all ? 1 : kShared) {
  // Robots are worked on in the order of their names, so that the order in the file has no effect.
  std::vector<scene::RobotDef> defs = scenario_.robots;
  std::sort(defs.begin(), defs.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  for (const scene::RobotDef& def : defs) {
    robots_.push_back(std::make_unique<Robot>(def, static_cast<int>(robots_.size())));
    robots_.back()->set_ground(world_.ground());
  }
  motion_.emplace(world_, robots_, share_all ? 1 : kSharedMotion);
  arena_.emplace(world_, robots_, scenario_.obstacles);
  std::vector<const Robot*> seen;
  for (const auto& robot : robots_) seen.push_back(robot.get());
  world_.SetRobots(seen);
  if (std::any_of(robots_.begin(), robots_.end(), [](const auto& one) { return one->dynamic(); })) {
    dynamics_.emplace(world_, robots_, scenario_.physics.value_or(scene::PhysicsDef{}),
                      scenario_.time.frequency);
  }
  world_.objects().Set(seen, scenario_.props);
  for (const auto& robot : robots_) {
    Equip(*robot, scenario_, world_, canvas_);
    for (const auto& component : robot->components()) components_.push_back(component.get());
  }
  sampled_.reserve(components_.size());
  std::sort(components_.begin(), components_.end(),
            [](const auto* a, const auto* b) { return a->full_name() < b->full_name(); });
}

void Simulation::Sense() {
  const Instant now = Now();
  sampled_.clear();
  std::int64_t work = 0;
  for (const auto& robot : robots_) {
    for (Sensor* sensor : robot->sensors()) {
      if (!sensor->active() || !sensor->TakeDue(now, scenario_.time.frequency)) continue;
      sampled_.push_back(sensor);
      work += sensor->Work();
    }
  }
  const auto sample = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Sensor& sensor = *sampled_[i];
      sensor.Activate(now);
      sensor.CountSample();
      sensor.AddToHash(sensor.robot().hash());
    }
  };
  const auto threads = static_cast<std::size_t>(pool_.threads());
  const auto conclude = [&] {
    for (Sensor* sensor : sampled_) sensor->Conclude(now);
  };
  if (threads == 1 || work < shared_from_) {
    sample(0, sampled_.size());
    conclude();
    return;
  }
  for (Sensor* sensor : sampled_) sensor->Prepare();
  // A robot's sensors all fall to one thread, in their order, as they add to the robot's hash.
  const auto boundary = [&](std::size_t part) {
    std::size_t i = sampled_.size() * part / threads;
    while (i > 0 && i < sampled_.size() && &sampled_[i]->robot() == &sampled_[i - 1]->robot()) ++i;
    return i;
  };
  pool_.Run([&](int number) {
    const auto part = static_cast<std::size_t>(number);
    sample(boundary(part), boundary(part + 1));
  });
  conclude();
}

void Simulation::Act() {
  const Instant now = Now();
  for (const auto& robot : robots_) {
    // What a step would have used up that was not taken, as physics were off.
    if (robot->dynamic()) robot->orders().force = robot->orders().torque = {};
    for (Actuator* actuator : robot->actuators()) {
      if (actuator->active() && actuator->TakeDue(now, scenario_.time.frequency)) {
        actuator->Act(now);
      }
    }
  }
  if (before_motion_) before_motion_();
  if (physics_) {
    motion_->Step(now, pool_);
    if (dynamics_) dynamics_->Step(now);
    world_.RobotsMoved();
    arena_->Step(now);
  }
  ++tick_;
}

Robot* Simulation::FindRobot(std::string_view name) const {
  for (const auto& robot : robots_) {
    if (robot->name() == name) return robot.get();
  }
  return nullptr;
}

Component* Simulation::FindComponent(std::string_view full_name) const {
  const auto found = std::lower_bound(components_.begin(), components_.end(), full_name,
                                      [](const Component* component, std::string_view name) {
                                        return component->full_name() < name;
                                      });
  return found != components_.end() && (*found)->full_name() == full_name ? *found : nullptr;
}

void Simulation::ResetObjects() {
  world_.objects().Reset();
  for (const auto& robot : robots_) robot->Reset();
  arena_->Reset();
  if (dynamics_) dynamics_->Reset();
  world_.RobotsMoved();
}

std::uint64_t Simulation::Hash() const {
  StateHash hash;
  hash.Add(tick_);
  for (const auto& robot : robots_) hash.Add(robot->hash().value());
  canvas_.AddToHash(hash);
  if (arena_->hash() != 0) hash.Add(arena_->hash());
  return hash.value();
}

}  // namespace ccmorse::sim
