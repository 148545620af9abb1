#include "sim/simulation.h"

#include <algorithm>
#include <cmath>

namespace ccmorse::sim {
namespace {

constexpr double kRemembered =
    0.25;  // m that a robot may move before its surroundings are looked up

}  // namespace

Simulation::Simulation(scene::Scenario scenario)
    : scenario_(std::move(scenario)),
      world_(scenario_.world),
      canvas_(scenario_.canvas, scenario_.world.size_x, scenario_.world.size_y) {
  // Robots are worked on in the order of their names, so that the order in the file has no effect.
  std::vector<scene::RobotDef> defs = scenario_.robots;
  std::sort(defs.begin(), defs.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  std::vector<const Robot*> seen;
  for (const scene::RobotDef& def : defs) {
    robots_.push_back(std::make_unique<Robot>(def, static_cast<int>(robots_.size())));
    seen.push_back(robots_.back().get());
    fastest_ = std::max(fastest_, robots_.back()->model().max_speed);
  }
  surroundings_.resize(robots_.size());
  world_.SetRobots(seen);
  for (const auto& robot : robots_) {
    Equip(*robot, scenario_, world_, canvas_);
    for (const auto& component : robot->components()) components_.push_back(component.get());
  }
  std::sort(components_.begin(), components_.end(),
            [](const auto* a, const auto* b) { return a->full_name() < b->full_name(); });
}

void Simulation::Sense() {
  const Instant now = Now();
  sampled_.clear();
  for (const auto& robot : robots_) {
    for (Sensor* sensor : robot->sensors()) {
      if (!sensor->active() || !sensor->TakeDue(now, scenario_.time.frequency)) continue;
      sensor->Sample(now);
      sensor->CountSample();
      sensor->AddToHash(robot->hash());
      sampled_.push_back(sensor);
    }
  }
}

void Simulation::Act() {
  const Instant now = Now();
  for (const auto& robot : robots_) {
    for (Actuator* actuator : robot->actuators()) {
      if (actuator->active() && actuator->TakeDue(now, scenario_.time.frequency)) {
        actuator->Act(now);
      }
    }
  }
  if (physics_) MoveRobots(now);
  ++tick_;
}

void Simulation::MoveRobots(const Instant& now) {
  // Where robots are before anyone moves; in a tick each moves a step at most.
  circles_.clear();
  for (const auto& robot : robots_) {
    circles_.push_back({robot->outline().centre, robot->outline().radius});
  }
  robot_grid_.Build(circles_);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = *robots_[i];
    const Vec2 at{robot.pose().x, robot.pose().y};
    const double step = robot.model().max_speed * now.step;
    Surroundings& near = surroundings_[i];
    const Vec2 moved = at - near.centre;
    if (near.revision != world_.revision() || Dot(moved, moved) > kRemembered * kRemembered) {
      near.revision = world_.revision();
      near.centre = at;
      near.boxes.clear();
      world_.NearObstacles(at, robot.footprint().radius + step + kRemembered, near.boxes);
    }
    in_the_way_.assign(near.boxes.begin(), near.boxes.end());
    robot_grid_.ForNear(at, robot.footprint().radius + step + fastest_ * now.step,
                        [this, i](std::uint32_t other) {
                          if (other != i) in_the_way_.push_back(&robots_[other]->outline());
                        });
    robot.Move(now, in_the_way_);
  }
  world_.RobotsMoved();
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
  for (const auto& robot : robots_) robot->Reset();
  world_.RobotsMoved();
}

std::uint64_t Simulation::Hash() const {
  StateHash hash;
  hash.Add(tick_);
  for (const auto& robot : robots_) hash.Add(robot->hash().value());
  for (int y = 0; y < canvas_.height(); ++y) {
    for (int x = 0; x < canvas_.width(); ++x) {
      if (!canvas_.IsDrawn(x, y)) continue;
      const Color color = canvas_.GetPixel(x, y);
      hash.Add(static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x));
      hash.Add(static_cast<std::uint64_t>(color.r) << 16 |
               static_cast<std::uint64_t>(color.g) << 8 | color.b);
    }
  }
  return hash.value();
}

}  // namespace ccmorse::sim
