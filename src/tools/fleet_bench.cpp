#include "tools/fleet_bench.h"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "base/trig.h"
#include "sim/actuators/motion_vw.h"
#include "sim/sensors/laser_scanner.h"
#include "sim/simulation.h"
#include "tools/fleet_scene.h"

namespace ccmorse::tools {
namespace {

// The controller: straight on, and away for a while from what comes near in front.
constexpr double kSpeed = 0.2;         // m/s
constexpr double kTurn = 1.2;          // rad/s
constexpr double kNear = 0.35;         // m
constexpr double kFront = 120.0;       // degrees
constexpr double kShortestTurn = 0.5;  // s
constexpr double kLongestTurn = 1.4;   // s

// Drives one robot from its scans.
class Controller {
 public:
  Controller(const sim::Simulation& simulation, const sim::Robot& robot, int index)
      : laser_(
            dynamic_cast<sim::LaserScanner&>(*simulation.FindComponent(robot.name() + ".hokuyo"))),
        motion_(dynamic_cast<sim::MotionVW&>(*simulation.FindComponent(robot.name() + ".motion"))),
        state_(static_cast<std::uint64_t>(index) + 1) {
    const scene::LaserDef& def = robot.def().laser;
    const int half = static_cast<int>(kFront / 2 / def.resolution_deg);
    first_ = def.samples / 2 - half;
    last_ = def.samples / 2 + half;
    motion_.SetSpeed({kSpeed, 0.0});
  }

  void Step(double time) {
    if (laser_.samples() == seen_) return;
    seen_ = laser_.samples();
    if (turning_ && time < turn_until_) return;
    const auto begin = laser_.ranges().begin();
    const double nearest = *std::min_element(begin + first_, begin + last_ + 1);
    if (nearest < kNear) {
      turn_until_ = time + kShortestTurn + (kLongestTurn - kShortestTurn) * Random();
      turning_ = true;
      motion_.SetSpeed({0.0, kTurn});
    } else if (turning_) {
      turning_ = false;
      motion_.SetSpeed({kSpeed, 0.0});
    }
  }

 private:
  // SplitMix64: the same on every machine, and each robot has its own sequence. In [0, 1).
  double Random() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

  sim::LaserScanner& laser_;
  sim::MotionVW& motion_;
  std::uint64_t state_;
  std::uint64_t seen_ = 0;
  int first_ = 0;
  int last_ = 0;
  bool turning_ = false;
  double turn_until_ = 0.0;
};

double Since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int BenchFleet(const FleetArguments& arguments) {
  const auto loading = std::chrono::steady_clock::now();
  sim::Simulation simulation(MakeFleet(arguments.robots), arguments.threads);
  std::vector<Controller> controllers;
  for (const auto& robot : simulation.robots()) {
    controllers.emplace_back(simulation, *robot, robot->index());
  }
  const double load = Since(loading);

  const auto running = std::chrono::steady_clock::now();
  while (simulation.time() < arguments.seconds) {
    simulation.Sense();
    for (Controller& controller : controllers) controller.Step(simulation.time());
    simulation.Act();
  }
  const double wall = Since(running);

  std::uint64_t rays = 0;
  std::uint64_t contacts = 0;
  for (const auto& robot : simulation.robots()) {
    const auto* laser =
        dynamic_cast<const sim::LaserScanner*>(simulation.FindComponent(robot->name() + ".hokuyo"));
    rays += laser->samples() * laser->ranges().size();
    contacts += robot->tally().contacts;
  }
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const double factor = simulation.time() / wall;
  const double rays_per_s = static_cast<double>(rays) / wall;
  const double rss = static_cast<double>(usage.ru_maxrss) / 1024.0;
  const std::string hash = fmt::format("{:016x}", simulation.Hash());
  if (arguments.json) {
    fmt::print("{}\n", Json(Json::Object{{"robots", arguments.robots},
                                         {"simulated_s", simulation.time()},
                                         {"sim_s_per_wall_s", factor},
                                         {"rays_per_s", rays_per_s},
                                         {"peak_rss_mb", rss},
                                         {"load_s", load},
                                         {"contacts", static_cast<std::int64_t>(contacts)},
                                         {"hash", hash}})
                           .Dump());
  } else {
    fmt::print("{} robots, {:.0f} simulated s in {:.3f} s\n", arguments.robots, simulation.time(),
               wall);
    fmt::print("simulated s per wall s  {:.1f}\n", factor);
    fmt::print("rays per second         {:.1f} M\n", rays_per_s * 1e-6);
    fmt::print("peak memory             {:.1f} MB\n", rss);
    fmt::print("load time               {:.3f} s\n", load);
    fmt::print("contacts                {}\n", contacts);
    fmt::print("state hash              {}\n", hash);
  }
  return 0;
}

}  // namespace ccmorse::tools
