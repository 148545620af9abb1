#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "base/polygon.h"
#include "base/trig.h"
#include "navigation/drive.h"
#include "navigation/occupancy_grid.h"
#include "navigation/scan.h"
#include "scene/scenario.h"
#include "sim/actuators/motion_vw.h"
#include "sim/robots/robot.h"
#include "sim/sensors/laser_scanner.h"
#include "sim/simulation.h"

namespace ccmorse::navigation {

/// A simulated S1R with its scanner, driven by an algorithm scan by scan.
class Rig {
 public:
  explicit Rig(scene::Scenario scenario) : simulation_(std::move(scenario)) {
    robot_ = simulation_.robots().front().get();
    laser_ =
        dynamic_cast<sim::LaserScanner*>(simulation_.FindComponent(robot_->name() + ".hokuyo"));
    motion_ = dynamic_cast<sim::Actuator*>(simulation_.FindComponent(robot_->name() + ".motion"));
  }

  static scene::Scenario World(const std::string& text) {
    return scene::ParseScenario(text, "test.json");
  }
  static scene::Scenario Named(const std::string& name) {
    return scene::LoadScenario(scene::FindScenario(name));
  }

  const sim::Simulation& simulation() const { return simulation_; }
  const sim::Robot& robot() const { return *robot_; }
  const Pose2& pose() const { return robot_->pose(); }
  double time() const { return simulation_.time(); }
  std::uint64_t contacts() const { return robot_->tally().contacts; }

  /// The last scan, mounted where the scanner is.
  ScanView scan() const {
    const scene::LaserDef& def = robot_->def().laser;
    return {-0.5 * Radians(def.scan_window_deg),
            Radians(def.resolution_deg),
            def.range,
            laser_->ranges(),
            {def.position.x, def.position.y, def.yaw}};
  }

  /// Runs to the next scan, asks `decide` there, and commands what it says.
  Drive Step(const std::function<Drive()>& decide) {
    const std::uint64_t before = laser_->samples();
    Drive drive;
    while (true) {
      simulation_.Sense();
      const bool fresh = laser_->samples() != before;
      if (fresh) {
        drive = decide();
        motion_->Receive(Json(Json::Object{{"v", drive.speed}, {"w", drive.turn_rate}}));
      }
      simulation_.Act();
      if (fresh) return drive;
    }
  }

 private:
  sim::Simulation simulation_;
  sim::Robot* robot_ = nullptr;
  sim::LaserScanner* laser_ = nullptr;
  sim::Actuator* motion_ = nullptr;
};

/// Map of a world's standing boxes: a cell is occupied when its middle is in one.
inline OccupancyGrid MapOf(const scene::World& world, double scale) {
  OccupancyGrid grid(static_cast<int>(std::lround(world.size_x / scale)),
                     static_cast<int>(std::lround(world.size_y / scale)), scale);
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      bool occupied = false;
      for (const scene::Box& box : world.boxes) {
        occupied = occupied || (box.raised && Contains(BoxCorners(box.pose, box.size_x, box.size_y),
                                                       grid.CentreOf({x, y})));
      }
      grid.Set({x, y}, occupied ? Cell::kOccupied : Cell::kFree);
    }
  }
  return grid;
}

/// Which cells of the map a path over free neighbours reaches from `start`.
inline std::vector<bool> ReachableFrom(const OccupancyGrid& grid, Vec2 start) {
  std::vector<bool> reached(grid.cells().size(), false);
  std::vector<CellIndex> open{grid.CellOf(start)};
  while (!open.empty()) {
    const CellIndex cell = open.back();
    open.pop_back();
    if (grid.At(cell) != Cell::kFree || reached[grid.IndexOf(cell)]) continue;
    reached[grid.IndexOf(cell)] = true;
    for (const CellIndex next : {CellIndex{cell.x + 1, cell.y}, CellIndex{cell.x - 1, cell.y},
                                 CellIndex{cell.x, cell.y + 1}, CellIndex{cell.x, cell.y - 1}}) {
      open.push_back(next);
    }
  }
  return reached;
}

/// A number of [low, high), the same from every standard library.
inline double Draw(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

}  // namespace ccmorse::navigation
