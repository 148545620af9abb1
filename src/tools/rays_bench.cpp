#include "tools/rays_bench.h"

#include <fmt/core.h>

#include <chrono>
#include <vector>

#include "base/json.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "sim/rays/planar_scan.h"
#include "tools/fleet_scene.h"

namespace ccmorse::tools {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kScansATurn = 1000;  // between looks at the clock
constexpr double kRadius = 0.2;    // m, of the circle on which the scanner drives about

// Rays per second of one scanner that drives in a small circle around `centre`, for about
// `seconds`.
double PlanarRays(const scene::World& world, const scene::LaserDef& laser, Vec2 centre,
                  double seconds) {
  sim::PlanarWorld boxes;
  for (const scene::Box& box : world.boxes) {
    boxes.Add(BoxCorners(box.pose, box.size_x, box.size_y));
  }
  boxes.Finish();
  const sim::PlanarWorld nobody;
  sim::PlanarScanner scanner(laser.samples, -Radians(laser.scan_window_deg) / 2.0,
                             Radians(laser.resolution_deg), laser.range);
  std::vector<double> ranges(static_cast<std::size_t>(laser.samples));
  const auto start = Clock::now();
  double bearing = 0.0;
  double scans = 0.0;
  double elapsed = 0.0;
  do {
    for (int i = 0; i < kScansATurn; ++i) {
      // 2 cm from scan to scan, as a robot at 0.2 m/s scans at 10 Hz.
      bearing = NormalizeAngle(bearing + 0.02 / kRadius);
      const auto [sine, cosine] = SinCos(bearing);
      scanner.Scan({centre.x + kRadius * cosine, centre.y + kRadius * sine, bearing}, boxes, nobody,
                   -1, ranges);
    }
    scans += kScansATurn;
    elapsed = std::chrono::duration<double>(Clock::now() - start).count();
  } while (elapsed < seconds);
  return scans * laser.samples / elapsed;
}

}  // namespace

int BenchRays(const RaysArguments& arguments) {
  const scene::Scenario arena = scene::LoadScenario(scene::FindScenario("syrotek"));
  const double full = PlanarRays(arena.world, scene::LaserDef{}, {1.2, 2.0}, arguments.seconds);
  const scene::Scenario fleet = MakeFleet(1);
  const scene::RobotDef& robot = fleet.robots.front();
  const double peers =
      PlanarRays(fleet.world, robot.laser, {robot.pose.x, robot.pose.y}, arguments.seconds);
  if (arguments.json) {
    fmt::print("{}\n", Json(Json::Object{{"planar_full_arena_rays_per_s", full},
                                         {"planar_peers_arena_rays_per_s", peers}})
                           .Dump());
  } else {
    fmt::print("planar scans on one core, rays per second\n");
    fmt::print("full SyRoTek arena, 360 edges  {:.0f} M\n", full * 1e-6);
    fmt::print("peers' arena, 56 edges         {:.0f} M\n", peers * 1e-6);
  }
  return 0;
}

}  // namespace ccmorse::tools
