#include "sim/simulation.h"

#include <algorithm>
#include <cmath>

namespace ccmorse::sim {

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
  }
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
  if (physics_) {
    for (const auto& robot : robots_) {
      const double reach = robot->footprint().radius + robot->model().max_speed * now.step;
      const auto add_if_near = [&](const Obstacle& obstacle) {
        const Vec2 d{obstacle.centre.x - robot->pose().x, obstacle.centre.y - robot->pose().y};
        const double sum = obstacle.radius + reach;
        if (Dot(d, d) < sum * sum) in_the_way_.push_back(&obstacle);
      };
      in_the_way_.clear();
      for (const Obstacle& obstacle : world_.obstacles()) add_if_near(obstacle);
      for (const auto& other : robots_) {
        if (other != robot) add_if_near(other->outline());
      }
      robot->Move(now, in_the_way_);
    }
    world_.RobotsMoved();
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
