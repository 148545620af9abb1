// Infra-red and sonar of the S1R, the laser's mount, and what a mesh is to a robot.

#include "sim/sensors/range_ring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/trig.h"
#include "scene/scenario.h"
#include "sim/rays/range_engine.h"
#include "sim/sensors/laser_scanner.h"
#include "sim/simulation.h"
#include "tests/support/range_scenes.h"

namespace ccmorse::sim {
namespace {

scene::Scenario ParseRings(const std::string& text) {
  return scene::ParseScenario(text, "test.json");
}

void Tick(Simulation& simulation, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    simulation.Sense();
    simulation.Act();
  }
}

// An empty floor of 10 x 10 m with these boxes and one robot in its middle, looking along x.
std::string OneRobot(const std::string& boxes, const std::string& settings) {
  return R"({"world": {"name": "w", "size": [10, 10], "boxes": [)" + boxes +
         R"(]}, "robots": [{"pose": {"x": 5, "y": 5}, )" + settings + "}]}";
}

std::string BoxAt(double x, double y, double side, double height) {
  static int id = 0;
  return "{\"id\": " + std::to_string(++id) + ", \"kind\": \"k\", \"x\": " + std::to_string(x) +
         ", \"y\": " + std::to_string(y) + ", \"size\": [" + std::to_string(side) + ", " +
         std::to_string(side) + "], \"height\": " + std::to_string(height) +
         ", \"color\": \"red\"}";
}

const std::vector<double>& Ranges(Simulation& simulation, const std::string& name) {
  Tick(simulation, 1);
  return dynamic_cast<const RangeRing&>(*simulation.FindComponent(name)).ranges();
}

TEST(RangeRing, AreMountedOnlyWhereTheScenarioSaysSo) {
  Simulation plain(ParseRings(OneRobot("", R"("ir": false)")));
  EXPECT_EQ(plain.FindComponent("s1r.ir"), nullptr);
  EXPECT_EQ(plain.FindComponent("s1r.sonar"), nullptr);
  EXPECT_NE(plain.FindComponent("s1r.hokuyo"), nullptr);
  Simulation both(ParseRings(OneRobot("", R"("ir": true, "sonar": true)")));
  EXPECT_EQ(Ranges(both, "s1r.ir").size(), 5U);
  EXPECT_EQ(Ranges(both, "s1r.sonar").size(), 3U);
  EXPECT_NE(both.FindComponent("s1r.hokuyo"), nullptr);
}

TEST(RangeRing, TheSensorModuleTakesTheLasersPlace) {
  Simulation simulation(
      ParseRings(OneRobot("", R"("front": "sensors", "ir": true, "sonar": true)")));
  EXPECT_EQ(simulation.FindComponent("s1r.hokuyo"), nullptr);
  EXPECT_EQ(Ranges(simulation, "s1r.ir").size(), 8U);
  EXPECT_EQ(Ranges(simulation, "s1r.sonar").size(), 6U);
  EXPECT_TRUE(simulation.robots()[0]->def().proxies.count("laser") == 0);
}

TEST(RangeRing, WithNothingInReachTheyGiveTheirRange) {
  Simulation simulation(ParseRings(OneRobot("", R"("ir": true, "sonar": true)")));
  for (const double range : Ranges(simulation, "s1r.ir")) EXPECT_EQ(range, 0.35);
  for (const double range : Ranges(simulation, "s1r.sonar")) EXPECT_EQ(range, 5.0);
}

TEST(RangeRing, InfraredSeesWhatStandsBeforeIt) {
  // A wall of 2 m whose near side is at x = 5.3.
  Simulation simulation(ParseRings(OneRobot(BoxAt(6.3, 5, 2, 0.16), R"("ir": true)")));
  const std::vector<double>& ranges = Ranges(simulation, "s1r.ir");
  EXPECT_NEAR(ranges[0], 0.3 - 0.078, 1e-12);  // front left
  EXPECT_NEAR(ranges[1], 0.3 - 0.078, 1e-12);  // front right
  for (std::size_t i = 2; i < 5; ++i) EXPECT_EQ(ranges[i], 0.35);
}

TEST(RangeRing, ASonarsEchoComesFromTheNearestPointInItsCone) {
  // A corner at 24 degrees to the left of the left sonar's axis is in the cone of 50 degrees, one
  // at 26 is not. The sonar sits at (4.98, 5.063), its axis along +y.
  for (const auto& [degrees, seen] : {std::pair{24.0, true}, {26.0, false}}) {
    const double x = 4.98 - 2.0 * std::sin(Radians(degrees)) - 0.5;
    const double y = 5.063 + 2.0 * std::cos(Radians(degrees)) - 0.5;
    Simulation simulation(ParseRings(OneRobot(BoxAt(x, y, 1.0, 0.16), R"("sonar": true)")));
    // The box's nearest corner in the cone is its (+x, +y) one, seen at 2 m; its (+x, -y) one lies
    // outside the cone to the left.
    const double got = Ranges(simulation, "s1r.sonar")[0];
    if (seen) {
      EXPECT_LT(got, 2.0 + 1e-9);
      EXPECT_GT(got, 1.5);
    } else {
      EXPECT_EQ(got, 5.0);
    }
  }
}

TEST(RangeRing, NothingIsTooThinToBeSeen) {
  // A needle of 0.1 mm at 4 m.
  Simulation simulation(ParseRings(OneRobot(BoxAt(4.98, 9.063, 0.0001, 0.16), R"("sonar": true)")));
  EXPECT_NEAR(Ranges(simulation, "s1r.sonar")[0], 4.0 - 0.00005, 1e-9);
}

TEST(RangeRing, NeverLessThanTheLeastRange) {
  Simulation simulation(
      ParseRings(OneRobot(BoxAt(5.6, 5, 1, 0.16), R"("ir": {"min_range": 0.1, "range": 0.5})")));
  EXPECT_EQ(Ranges(simulation, "s1r.ir")[0], 0.1);
}

TEST(RangeRing, SeesOtherRobotsButNotItsOwn) {
  Simulation simulation(ParseRings(
      R"({"world": {"name": "w", "size": [10, 10]}, "robots": [
          {"name": "a", "pose": {"x": 5, "y": 5}, "ir": true, "front": "sensors"},
          {"name": "b", "pose": {"x": 5.35, "y": 5}}]})"));
  Tick(simulation, 1);
  const auto& ring = dynamic_cast<const RangeRing&>(*simulation.FindComponent("a.ir"));
  // b's upper hull reaches back to x = 5.35 - 0.074 at the sensors' height.
  EXPECT_NEAR(ring.ranges()[0], 0.35 - 0.074 - 0.078, 2e-3);
  EXPECT_EQ(ring.ranges()[4], 0.35);  // to the rear
}

TEST(RangeRing, DataAndConfigurationAreJson) {
  Simulation simulation(ParseRings(OneRobot("", R"("ir": true)")));
  Tick(simulation, 1);
  Component& ring = *simulation.FindComponent("s1r.ir");
  EXPECT_EQ(ring.LocalData(),
            "{\"timestamp\": 0.0, \"range_list\": [0.35, 0.35, 0.35, 0.35, 0.35]}");
  const Json configuration = ring.Configurations();
  EXPECT_EQ(*configuration.Find("range"), Json(0.35));
  EXPECT_EQ(*configuration.Find("cone_deg"), Json(2.0));
  const Json::Array& poses = configuration.Find("poses")->AsArray();
  ASSERT_EQ(poses.size(), 5U);
  EXPECT_EQ(poses[0].AsArray()[0], Json(0.078));
  EXPECT_EQ(poses[0].AsArray()[1], Json(0.0335));
  EXPECT_NEAR(poses[0].AsArray()[2].AsDouble(), 0.065, 1e-12);
  EXPECT_NEAR(poses[4].AsArray()[3].AsDouble(), kPi, 1e-12);
}

TEST(Laser, ATiltedOneSeesTheFloor) {
  Simulation simulation(ParseRings(
      OneRobot("", R"("laser": {"preset": "sick", "pitch_deg": 30, "position": [0, 0, 0.465]})")));
  Tick(simulation, 1);
  const auto& laser = dynamic_cast<const LaserScanner&>(*simulation.FindComponent("s1r.hokuyo"));
  ASSERT_EQ(laser.ranges().size(), 181U);
  EXPECT_NEAR(laser.ranges()[90], 1.0, 1e-9);  // 0.5 m up, 30 degrees down
  EXPECT_EQ(laser.ranges()[0], 30.0);          // to the side it is level
  const Json data = Json::Parse(simulation.FindComponent("s1r.hokuyo")->LocalData());
  const Json::Array& point = data.Find("point_list")->AsArray()[90].AsArray();
  EXPECT_NEAR(point[0].AsDouble(), 1.0, 1e-9);  // in the scanner's own frame
  EXPECT_NEAR(point[2].AsDouble(), 0.0, 1e-9);
}

TEST(Laser, LayersFollowEachOther) {
  Simulation simulation(
      ParseRings(OneRobot(BoxAt(7.5, 5, 1, 0.16), R"("laser": {"preset": "sick_ldmrs"})")));
  Tick(simulation, 1);
  const auto& laser = dynamic_cast<const LaserScanner&>(*simulation.FindComponent("s1r.hokuyo"));
  ASSERT_EQ(laser.ranges().size(), 4 * 401U);
  const Json configuration = laser.Configurations();
  EXPECT_EQ(*configuration.Find("layers"), Json(4));
  EXPECT_EQ(*configuration.Find("layer_separation"), Json(0.8));
  EXPECT_EQ(*configuration.Find("layer_offset"), Json(0.125));
  // The box's near side is 1.965 m from the scanner, which sits 0.035 m up: layer 3 looks 1.2
  // degrees down and meets the floor first, the others meet the box.
  EXPECT_NEAR(laser.ranges()[3 * 401 + 200], 0.035 / std::sin(std::atan(std::sin(Radians(1.2)))),
              1e-9);
  for (const std::size_t layer : {0U, 1U, 2U}) {
    EXPECT_NEAR(laser.ranges()[layer * 401 + 200], 1.965, 1e-3);
  }
}

// Three triangles of a ramp's side and a table top, far above.
constexpr const char* kMeshWorld = R"({"world": {"name": "w", "size": [10, 10], "meshes": [
  {"id": 1, "name": "wall", "vertices": [[0, -1, 0], [0, 1, 0], [0, 1, 1], [0, -1, 1]],
   "triangles": [[0, 1, 2], [0, 2, 3]], "position": [6, 5, 0]},
  {"id": 2, "name": "table", "vertices": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]],
   "triangles": [[0, 1, 2], [0, 2, 3]], "position": [5, 5, 0.7]}]},
  "robots": [{"pose": {"x": 5, "y": 5}}]})";

TEST(Mesh, RobotsStopBeforeItAndPassBeneath) {
  Simulation simulation(ParseRings(kMeshWorld));
  auto* motion = dynamic_cast<Actuator*>(simulation.FindComponent("s1r.motion"));
  motion->Receive(Json::Parse(R"({"v": 0.4, "w": 0.0})"));
  Tick(simulation, 240);
  EXPECT_TRUE(simulation.robots()[0]->stalled());
  EXPECT_NEAR(simulation.robots()[0]->pose().x, 6.0 - 0.087, 1e-4);
  EXPECT_LE(simulation.robots()[0]->pose().x, 6.0 - 0.087);
}

TEST(Mesh, IsSeenFromBothSides) {
  Simulation simulation(ParseRings(kMeshWorld));
  Tick(simulation, 1);
  const auto& laser = dynamic_cast<const LaserScanner&>(*simulation.FindComponent("s1r.hokuyo"));
  EXPECT_NEAR(laser.ranges()[341], 1.0 - 0.035, 1e-4);
  const World& world = simulation.world();
  EXPECT_FALSE(world.LineOfSight({5.5, 5, 0.1}, {6.5, 5, 0.1}));
  EXPECT_FALSE(world.LineOfSight({6.5, 5, 0.1}, {5.5, 5, 0.1}));
  EXPECT_TRUE(world.LineOfSight({5.5, 5, 1.1}, {6.5, 5, 1.1}));
  EXPECT_FALSE(world.LineOfSight({5.5, 5.5, 0.5}, {5.5, 5.5, 0.9}));  // the table
  EXPECT_FALSE(world.LineOfSight({4.5, 5, 0.05}, {5.5, 5, 0.05}));    // the robot
}

TEST(Mesh, ARobotMayNotStartInIt) {
  std::string text = kMeshWorld;
  text.replace(text.rfind("\"x\": 5"), 6, "\"x\": 6");
  try {
    ParseRings(text);
    FAIL() << "it may";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "test.json:6: robot 's1r' at (6, 5) overlaps mesh 1 (wall); move it");
  }
}

// The scenes that the golden hashes use: both paths agree in them, whatever the order of robots.
class RangeScenes : public ::testing::TestWithParam<testing::RangeScene> {};

std::uint64_t HashOf(const std::string& text, RayPath path, int ticks) {
  Simulation simulation(ParseRings(text));
  simulation.world().rays().Force(path);
  for (const auto& robot : simulation.robots()) {
    auto* motion = dynamic_cast<Actuator*>(simulation.FindComponent(robot->name() + ".motion"));
    motion->Receive(Json::Parse(R"({"v": 0.2, "w": 0.3})"));
  }
  Tick(simulation, ticks);
  return simulation.Hash();
}

TEST_P(RangeScenes, AreTheSameTwiceAndSenseSomething) {
  const std::uint64_t hash = HashOf(GetParam().text, RayPath::kAuto, 120);
  EXPECT_EQ(HashOf(GetParam().text, RayPath::kAuto, 120), hash);
  Simulation simulation(ParseRings(GetParam().text));
  Tick(simulation, 60);
  for (const Component* component : simulation.components()) {
    if (const auto* ring = dynamic_cast<const RangeRing*>(component)) {
      const Json configuration = ring->Configurations();
      const double range = configuration.Find("range")->AsDouble();
      EXPECT_LT(*std::min_element(ring->ranges().begin(), ring->ranges().end()), range)
          << ring->full_name();
    }
  }
  std::cout << GetParam().name << " " << std::hex << hash << "\n";
}

INSTANTIATE_TEST_SUITE_P(All, RangeScenes, ::testing::ValuesIn(testing::RangeScenesForTests()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ccmorse::sim
