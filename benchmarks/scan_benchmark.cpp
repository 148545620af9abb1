// What one scan and one tick cost. Run: build/release/bin/scan_benchmark
// benchmarks/run.sh prints these with the start-up and the client figures.

#include <benchmark/benchmark.h>

#include "base/polygon.h"
#include "base/trig.h"
#include "scene/scenario.h"
#include "sim/rays/planar_scan.h"
#include "sim/simulation.h"

namespace {

using namespace ccmorse;  // NOLINT(google-build-using-namespace): a program of one file

// 682 beams among all 90 boxes of the arena, the dynamic ones raised: 360 edges.
void ScanFullArena(benchmark::State& state) {
  scene::Scenario scenario = scene::LoadScenario(scene::FindScenario("syrotek"));
  sim::PlanarWorld boxes;
  for (const scene::Box& box : scenario.world.boxes) {
    boxes.Add(BoxCorners(box.pose, box.size_x, box.size_y));
  }
  boxes.Finish();
  const scene::LaserDef laser;
  sim::PlanarScanner scanner(laser.samples, -Radians(laser.scan_window_deg) / 2.0,
                             Radians(laser.resolution_deg), laser.range);
  std::vector<double> ranges(static_cast<std::size_t>(laser.samples));
  double yaw = 0.0;
  for (auto _ : state) {
    yaw += 0.1;
    scanner.Scan({1.2, 2.0, yaw}, boxes, {}, -1, ranges);
    benchmark::DoNotOptimize(ranges.data());
  }
  state.SetItemsProcessed(state.iterations() * laser.samples);
}
BENCHMARK(ScanFullArena)->Unit(benchmark::kMicrosecond);

// One S1R with all its sensors, driving, no client.
void OneRobotSecond(benchmark::State& state) {
  sim::Simulation simulation(scene::LoadScenario(scene::FindScenario("course_map")));
  auto* motion = dynamic_cast<sim::Actuator*>(simulation.FindComponent("s1r.motion"));
  motion->Receive(Json::Parse(R"({"v": 0.1, "w": 0.5})"));
  for (auto _ : state) {
    for (int tick = 0; tick < 60; ++tick) {
      simulation.Sense();
      simulation.Act();
    }
  }
  state.counters["real_time_factor"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(OneRobotSecond)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
