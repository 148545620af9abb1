// Worlds of Stage, the S1R beside them, in the simulator (specs: player.md C.3).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/polygon.h"
#include "base/trig.h"
#include "scene/player/import.h"
#include "sim/sensors/laser_scanner.h"
#include "sim/sensors/odometry.h"
#include "sim/sensors/range_ring.h"
#include "sim/simulation.h"

namespace ccmorse::sim {
namespace {

const std::string kWorlds = CCMORSE_SOURCE_DIR "/tests/worlds/";

void Advance(Simulation& simulation, double seconds) {
  const auto ticks = static_cast<int>(std::lround(seconds * simulation.scenario().time.frequency));
  for (int i = 0; i < ticks; ++i) {
    simulation.Sense();
    simulation.Act();
  }
}

scene::Scenario World(const std::string& text) {
  return scene::ParseStageWorld(text, "test.world").scenario;
}

const std::vector<double>& Scan(const Simulation& simulation, const std::string& name) {
  return dynamic_cast<const LaserScanner&>(*simulation.FindComponent(name)).ranges();
}

std::vector<std::string> WorldFiles() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(kWorlds)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".world" || ending == ".cfg") files.push_back(entry.path().filename().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class ImportedWorld : public testing::TestWithParam<std::string> {};

TEST_P(ImportedWorld, LoadsAndRunsTwoSeconds) {
  const scene::ImportedScenario imported = scene::ImportScenario(kWorlds + GetParam());
  Simulation simulation(imported.scenario);
  ASSERT_FALSE(simulation.robots().empty());
  std::vector<Pose2> starts;
  for (const auto& robot : simulation.robots()) {
    starts.push_back(robot->pose());
    robot->Command({0.2, 0.3, 0.1}, nullptr);
  }
  Advance(simulation, 2.0);
  for (std::size_t i = 0; i < simulation.robots().size(); ++i) {
    const Robot& robot = *simulation.robots()[i];
    // It moved, unless it met something at once, and what it met it does not overlap.
    EXPECT_TRUE(robot.pose().x != starts[i].x || robot.stalled()) << robot.name();
    for (const Obstacle& obstacle : simulation.world().obstacles()) {
      EXPECT_GT(ConvexGap(robot.outline().outline, obstacle.outline), -1e-9) << robot.name();
    }
    for (const Sensor* sensor : robot.sensors()) EXPECT_GT(sensor->samples(), 0U);
  }
}

TEST_P(ImportedWorld, IsTheSameScenarioWhenWrittenAsJson) {
  const scene::ImportedScenario imported = scene::ImportScenario(kWorlds + GetParam());
  const std::string written = ToJson(imported.scenario).Dump();
  const scene::Scenario read = scene::ParseScenario(written, GetParam() + ".json");
  EXPECT_EQ(ToJson(read).Dump(), written);
  Simulation first(imported.scenario);
  Simulation second(read);
  Advance(first, 0.5);
  Advance(second, 0.5);
  EXPECT_EQ(first.Hash(), second.Hash());
}

INSTANTIATE_TEST_SUITE_P(C3, ImportedWorld, testing::ValuesIn(WorldFiles()), [](const auto& param) {
  std::string name = param.param;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

TEST(ImportedWorlds, ThereAreTenAndMore) { EXPECT_GE(WorldFiles().size(), 16U); }

TEST(ImportedWorlds, AScannerSeesTheWallsThatABitmapMakes) {
  Simulation simulation(scene::ImportScenario(kWorlds + "course.world").scenario);
  Advance(simulation, 0.1);
  const std::vector<double>& scan = Scan(simulation, "r0.hokuyo");
  ASSERT_EQ(scan.size(), 622U);
  // Right-most beam looks 135 degrees to the right, at the wall on the left: 0.9 - 0.025 m of x
  // from the robot's origin, the scanner 0.04 m before it.
  EXPECT_NEAR(scan[0], (0.9 + 0.04 - 0.025) / std::cos(Radians(45.0)), 1e-9);
}

TEST(ImportedWorlds, WhatIsInvisibleIsNotSeenAndWhatIsNoObstacleDoesNotStop) {
  const std::string robot =
      "position ( name \"r\" size [ 0.2 0.2 0.4 ] pose [ 0 0 0 0 ]\n"
      "  ranger ( pose [ 0 0 -0.2 0 ] sensor ( range [ 0 5 ] fov 10 samples 3 ) ) )\n";
  const std::string wall = "model ( size [ 0.2 1 0.5 ] pose [ 1 0 0 0 ] ";
  struct Case {
    std::string properties;
    double range;
    bool stops;
  };
  for (const Case& c : {Case{")", 0.9, true}, Case{"ranger_return -1 )", 5.0, true},
                        Case{"obstacle_return 0 )", 0.9, false}}) {
    Simulation simulation(World(robot + wall + c.properties));
    Advance(simulation, 0.1);
    EXPECT_NEAR(Scan(simulation, "r.hokuyo")[1], c.range, 1e-9) << c.properties;
    simulation.robots()[0]->Command({1.0, 0.0}, nullptr);
    Advance(simulation, 1.0);
    EXPECT_EQ(simulation.robots()[0]->stalled(), c.stops) << c.properties;
  }
}

TEST(ImportedWorlds, RobotsOfOtherSizesSeeEachOther) {
  Simulation simulation(
      World("position ( name \"a\" size [ 0.4 0.4 0.4 ]\n"
            "  ranger ( pose [ 0 0 -0.2 0 ] sensor ( range [ 0 5 ] fov 10 samples 3 ) ) )\n"
            "position ( name \"b\" size [ 0.6 0.2 0.3 ] pose [ 2 0 0 0 ] )\n"
            "position ( name \"c\" size [ 0.2 0.2 0.1 ] pose [ 1 0 0 0 ] )"));
  Advance(simulation, 0.1);
  // c is lower than the scanner.
  EXPECT_NEAR(Scan(simulation, "a.hokuyo")[1], 2.0 - 0.3, 1e-9);
}

TEST(ImportedWorlds, SonarsSitWhereTheWorldPutsThem) {
  Simulation simulation(
      World("model ( size [ 0.2 4 1 ] pose [ 2 0 0 0 ] )\n"
            "position ( name \"a\" size [ 0.4 0.4 0.3 ] ranger ( pose [ 0 0 -0.1 0 ]\n"
            "  sensor ( pose [ 0.2 0 0 0 ] range [ 0 4 ] fov 10 )\n"
            "  sensor ( pose [ -0.2 0 0 180 ] range [ 0 4 ] fov 10 ) ) )"));
  Advance(simulation, 0.1);
  const auto& ring = dynamic_cast<const RangeRing&>(*simulation.FindComponent("a.sonar"));
  ASSERT_EQ(ring.ranges().size(), 2U);
  EXPECT_NEAR(ring.ranges()[0], 1.9 - 0.2, 1e-6);
  EXPECT_DOUBLE_EQ(ring.ranges()[1], 4.0);
}

TEST(ImportedWorlds, AnOmnidirectionalRobotGoesSidewaysAndADifferentialOneDoesNot) {
  Simulation simulation(World(
      "interval_sim 10\n"
      "position ( name \"omni\" drive \"omni\" velocity_bounds [ -1 1 -0.5 0.5 0 0 -90 90 ] )\n"
      "position ( name \"diff\" pose [ 0 -3 0 0 ] )"));
  const Vec2 origin = simulation.scenario().world.origin;
  for (const auto& robot : simulation.robots()) robot->Command({0.0, 0.0, 2.0}, nullptr);
  Advance(simulation, 1.0);
  const Pose2& omni = simulation.FindRobot("omni")->pose();
  EXPECT_NEAR(omni.x - origin.x, 0.0, 1e-12);
  EXPECT_NEAR(omni.y - origin.y, 0.5, 1e-9);  // clamped to its bounds
  EXPECT_NEAR(simulation.FindRobot("omni")->tally().distance, 0.5, 1e-9);
  EXPECT_NEAR(simulation.FindRobot("diff")->pose().y - origin.y, -3.0, 1e-12);
}

TEST(ImportedWorlds, SidewaysOnAnArcIsExact) {
  // Sideways at 1 m/s while turning at 1 rad/s is a circle of 1 m, whatever the step.
  const Pose2 quarter = DriveArc({}, 0.0, 1.0, kPi / 2.0, 1.0);
  EXPECT_NEAR(quarter.x, -1.0, 1e-12);
  EXPECT_NEAR(quarter.y, 1.0, 1e-12);
  Pose2 stepped;
  for (int i = 0; i < 100; ++i) stepped = DriveArc(stepped, 0.0, 1.0, kPi / 200.0, 1.0);
  EXPECT_NEAR(stepped.x, quarter.x, 1e-12);
  EXPECT_NEAR(stepped.y, quarter.y, 1e-12);
}

TEST(ImportedWorlds, AnOmnidirectionalRobotStopsBesideAWall) {
  Simulation simulation(
      World("model ( size [ 4 0.2 1 ] pose [ 0 1 0 0 ] )\n"
            "position ( name \"omni\" size [ 0.4 0.4 0.2 ] drive \"omni\" )"));
  simulation.robots()[0]->Command({0.0, 0.0, 1.0}, nullptr);
  Advance(simulation, 3.0);
  EXPECT_TRUE(simulation.robots()[0]->stalled());
  EXPECT_NEAR(simulation.robots()[0]->pose().y - simulation.scenario().world.origin.y, 0.7, 2e-5);
}

std::vector<double> Odometry(const Simulation& simulation, const std::string& name) {
  std::vector<double> numbers;
  dynamic_cast<const OdometrySensor&>(*simulation.FindComponent(name)).AppendNumbers(numbers);
  return numbers;
}

TEST(ImportedWorlds, OdometryCountsWithAGainErrorThatARunKeeps) {
  const std::string text =
      "position ( name \"r\" localization \"odom\" odom_error [ 0.2 0.2 0 0.2 ] )";
  const auto counted = [&](std::uint64_t seed, double seconds) {
    scene::Scenario scenario = World(text);
    scenario.seed = seed;
    Simulation simulation(std::move(scenario));
    simulation.robots()[0]->Command({0.5, 0.0}, nullptr);
    Advance(simulation, seconds);
    simulation.Sense();
    const Json data = Json::Parse(simulation.FindComponent("r.odometry")->LocalData());
    const double gain = data.Find("x")->AsDouble() / (0.5 * seconds);
    // A speed is a way in a second: it would give the true way away.
    EXPECT_NEAR(data.Find("vx")->AsDouble(), 0.5 * gain, 1e-9);
    return gain;
  };
  const double gain = counted(1, 2.0);
  EXPECT_NE(gain, 1.0);
  EXPECT_NEAR(gain, 1.0, 0.1 + 1e-9);
  EXPECT_NEAR(counted(1, 4.0), gain, 1e-9);
  EXPECT_EQ(counted(1, 2.0), gain);
  std::set<double> gains;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    gains.insert(counted(seed, 0.5));
    EXPECT_NEAR(*gains.rbegin(), 1.0, 0.1 + 1e-9);
  }
  EXPECT_GT(gains.size(), 15U);
}

TEST(ImportedWorlds, OdometryBeginsWhereLocalizationOriginSays) {
  Simulation simulation(
      World("position ( name \"r\" pose [ 1 2 0 90 ] localization \"odom\"\n"
            "  localization_origin [ 1 0 0 0 ] odom_error [ 0 0 0 0 ] )"));
  simulation.robots()[0]->Command({0.5, 0.0}, nullptr);
  Advance(simulation, 2.0);
  simulation.Sense();
  const std::vector<double> numbers = Odometry(simulation, "r.odometry");
  EXPECT_NEAR(numbers[0], 0.0, 1e-9);
  EXPECT_NEAR(numbers[1], 3.0, 1e-9);
  EXPECT_NEAR(numbers[5], kPi / 2.0, 1e-9);
}

}  // namespace
}  // namespace ccmorse::sim
