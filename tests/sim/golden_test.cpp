// The promise of docs/architecture.md: the same run gives the same bytes, whatever the number of
// threads, the order in which robots are declared, and the build. Each scene's hash is a golden
// number that holds for Release, Debug and sanitizer builds; a change of one belongs in CHANGELOG.
// The tenth, a lock-step client's run, is in tests/end_to_end/lockstep_golden_test.cpp.

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "base/json.h"
#include "scene/scenario.h"
#include "sim/actuators/motion_vw.h"
#include "sim/simulation.h"
#include "tests/support/range_scenes.h"

namespace ccmorse::sim {
namespace {

struct Scene {
  std::string rest;                 // of the scenario, all but the robots
  std::vector<std::string> robots;  // JSON, one each
  int ticks;
  std::uint64_t golden;
  std::function<void(Simulation&)> each_tick = {};
};

std::string Robot(const std::string& name, double x, double y, double yaw,
                  const std::string& more = "") {
  return fmt::format(R"({{"name": "{}", "pose": {{"x": {}, "y": {}, "yaw": {}}}{}}})", name, x, y,
                     yaw, more);
}

// An empty floor with a few boxes on it, as a whole world.
std::string Floor(double size, const std::string& boxes) {
  return fmt::format(R"("world": {{"name": "floor", "size": [{0}, {0}],
    "kinds": {{"static": {{"height": 0.3, "color": "#808080"}}}}, "boxes": [{1}]}})",
                     size, boxes);
}

Scene SingleRobot() {
  return {R"("world": "syrotek")", {Robot("s1r", 1.2, 2.0, 2.6)}, 600, 0x46027363ebee6769};
}

// From a circle to its middle, where they run against each other.
Scene TenRobotsMeeting() {
  Scene scene{Floor(6.0, ""), {}, 600, 0x42ef4217562575e4};
  for (int i = 0; i < 10; ++i) {
    const double bearing = 0.2 * M_PI * i;
    scene.robots.push_back(Robot(fmt::format("r{}", i),
                                 std::round(300 + 150 * std::cos(bearing)) / 100,
                                 std::round(300 + 150 * std::sin(bearing)) / 100, i - 3.0));
  }
  return scene;
}

Scene HundredRobots() {
  std::string boxes;
  for (int i = 0; i < 40; ++i) {
    boxes += fmt::format(
        R"({}{{"id": {}, "kind": "static", "x": {}, "y": {}, "yaw": {}, "size": [0.4, 0.2]}})",
        i == 0 ? "" : ", ", i + 1, 2.4 + 1.8 * (i % 9), 1.95 + 1.9 * (i / 9), 0.1 * i);
  }
  Scene scene{Floor(20.0, boxes), {}, 300, 0x2f87e332a1d88718};
  for (int i = 0; i < 100; ++i) {
    scene.robots.push_back(Robot(fmt::format("r{:02}", i), 1.5 + i % 10 * 1.8, 1.0 + i / 10 * 1.9,
                                 0.6 * (i % 10) - 3.0, R"(, "type": "BoxRobot")"));
  }
  return scene;
}

Scene NoisySensors() {
  const std::string noise =
      R"(, "laser": {"range_std": 0.02}, "pose_noise": {"pos_std": 0.01, "rot_std": 0.02})";
  return {R"("seed": 42, "world": "syrotek")",
          {Robot("a", 1.0, 2.4, 0.0, noise), Robot("b", 2.0, 2.4, 1.5, noise)},
          300,
          0x1b981bfd2d1263ae};
}

Scene ArenaObstaclesUp() {
  return {R"("world": "syrotek", "obstacles": {"up": [5, 10, 19, 22, 23, 61, 66, 67, 68, 69, 70, 71,
    72, 73, 74, 75, 76]})",
          {Robot("a", 1.2, 2.0, 2.6), Robot("b", 2.0, 2.4, 0.5)},
          600,
          0xaaa4db079591d529,
          [](Simulation& simulation) {
            // One of them goes down and up on the way.
            if (simulation.tick() == 200) simulation.world().SetRaised(69, false);
            if (simulation.tick() == 400) simulation.world().SetRaised(69, true);
          }};
}

Scene DrawnCanvas() {
  return {R"("canvas": {"alpha": 0.7})",
          {Robot("a", 1.0, 2.4, 0.0), Robot("b", 2.0, 2.4, 1.5)},
          120,
          0x63eb289efebe6e05,
          [](Simulation& simulation) {
            const int at = static_cast<int>(simulation.tick());
            for (const auto& robot : simulation.robots()) {
              const auto& services = simulation.FindComponent(robot->name() + ".pen")->services();
              const auto line = std::find_if(services.begin(), services.end(),
                                             [](const auto& s) { return s.name == "set_line"; });
              ASSERT_NE(line, services.end());
              const int shift = 20 * robot->index();
              const std::vector<Json> arguments = {at,  shift, 171 - at, 185 - shift,
                                                   200, at,    shift,    0.5};
              line->run(arguments);
            }
          }};
}

// A scene of tests/support/range_scenes.h, taken apart so that its robots can be shuffled.
Scene FromText(const std::string& text, int ticks, std::uint64_t golden) {
  Scene scene{"", {}, ticks, golden};
  const Json whole = Json::Parse(text);
  for (const auto& [key, value] : whole.AsObject()) {
    if (key == "robots") {
      for (const Json& robot : value.AsArray()) scene.robots.push_back(robot.Dump());
    } else {
      scene.rest += (scene.rest.empty() ? "" : ", ") + Json(key).Dump() + ": " + value.Dump();
    }
  }
  return scene;
}

Scene SonarRings() { return FromText(testing::SonarScene(), 300, 0x2a0f0f98abd64cb3); }

Scene InfraredRings() { return FromText(testing::InfraredScene(), 300, 0x8dd6bb227bfca1c9); }

Scene MeshesByEmbree() { return FromText(testing::MeshScene(), 300, 0xa6adbf25309882e6); }

// Each robot drives by a programme that depends on its name alone.
void Drive(Simulation& simulation) {
  const double time = simulation.time();
  for (const auto& robot : simulation.robots()) {
    const double phase = robot->name().back() + 0.37 * robot->name()[robot->name().size() / 2];
    auto& motion = dynamic_cast<MotionVW&>(*simulation.FindComponent(robot->name() + ".motion"));
    motion.SetSpeed({0.25 + 0.1 * std::remainder(0.7 * time + phase, 2.0),
                     std::remainder(0.9 * time + phase, 1.6)});
  }
}

std::uint64_t Hash(const Scene& scene, int threads) {
  std::string text = "{" + scene.rest + R"(, "robots": [)";
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    text += (i == 0 ? "" : ", ") + scene.robots[i];
  }
  Simulation simulation(scene::ParseScenario(text + "]}", "golden.json"), threads, true);
  for (int i = 0; i < scene.ticks; ++i) {
    simulation.Sense();
    Drive(simulation);
    if (scene.each_tick) scene.each_tick(simulation);
    simulation.Act();
  }
  return simulation.Hash();
}

struct Named {
  const char* name;
  Scene (*make)();
};

void PrintTo(const Named& named, std::ostream* out) { *out << named.name; }

class GoldenHash : public ::testing::TestWithParam<Named> {};

TEST_P(GoldenHash, HoldsForEveryNumberOfThreadsAndOrderOfRobots) {
  Scene scene = GetParam().make();
  std::mt19937_64 random(3);
  for (const int threads : {1, 2, 3, 8}) {
    EXPECT_EQ(fmt::format("{:#018x}", Hash(scene, threads)), fmt::format("{:#018x}", scene.golden))
        << threads << " threads";
    std::shuffle(scene.robots.begin(), scene.robots.end(), random);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, GoldenHash,
    ::testing::Values(Named{"SingleRobot", SingleRobot},
                      Named{"TenRobotsMeeting", TenRobotsMeeting},
                      Named{"HundredRobots", HundredRobots}, Named{"NoisySensors", NoisySensors},
                      Named{"ArenaObstaclesUp", ArenaObstaclesUp}, Named{"SonarRings", SonarRings},
                      Named{"InfraredRings", InfraredRings},
                      Named{"MeshesByEmbree", MeshesByEmbree}, Named{"DrawnCanvas", DrawnCanvas}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace ccmorse::sim
