// The S1R as simulated: its devices and what they say (thesis 4.1.2).

#include <gtest/gtest.h>

#include <cmath>

#include "base/trig.h"
#include "scene/scenario.h"
#include "sim/sensors/laser_scanner.h"
#include "sim/simulation.h"

namespace ccmorse::sim {
namespace {

scene::Scenario ParseS1r(const std::string& text) {
  return scene::ParseScenario(text, "test.json");
}

void Advance(Simulation& simulation, double seconds) {
  const auto end = simulation.tick() + static_cast<std::uint64_t>(std::lround(seconds * 60));
  while (simulation.tick() < end) {
    simulation.Sense();
    simulation.Act();
  }
}

Json Data(Simulation& simulation, const std::string& name) {
  return Json::Parse(simulation.FindComponent(name)->LocalData());
}

void Drive(Simulation& simulation, const std::string& robot, double v, double w) {
  auto* motion = dynamic_cast<Actuator*>(simulation.FindComponent(robot + ".motion"));
  motion->Receive(Json(Json::Object{{"v", v}, {"w", w}}));
}

std::vector<std::string> Names(const Simulation& simulation) {
  std::vector<std::string> names;
  for (const Component* component : simulation.components())
    names.push_back(component->full_name());
  return names;
}

TEST(R13, EveryS1RCarriesTheSameDevices) {
  const Simulation simulation(ParseS1r("{}"));
  EXPECT_EQ(Names(simulation),
            (std::vector<std::string>{"s1r.answers", "s1r.hokuyo", "s1r.motion", "s1r.odometry",
                                      "s1r.pen", "s1r.pose", "s1r.properties", "s1r.waypoint"}));
}

TEST(R13, ATasksRobotMayGoWithoutSome) {
  const Simulation simulation(ParseS1r(R"({"robots": [{"without": ["pose", "waypoint"]}]})"));
  EXPECT_EQ(Names(simulation),
            (std::vector<std::string>{"s1r.answers", "s1r.hokuyo", "s1r.motion", "s1r.odometry",
                                      "s1r.pen", "s1r.properties"}));
}

// Against the exact solution: a turning that follows the told one with the time constant T, and
// turns by the pull as it goes.
TEST(Wear, PullsAsItGoesAndTurnsLate) {
  Simulation simulation(ParseS1r(
      R"({"robots": [{"pose": {"x": 1.6, "y": 2.4}, "wear": {"pull": -1.0, "turn_lag": 0.3}}]})"));
  const Robot& robot = *simulation.robots()[0];
  Advance(simulation, 0.5);
  EXPECT_EQ(robot.pose().yaw, 0.0);  // who stands is not pulled
  Drive(simulation, "s1r", 0.0, 1.0);
  Advance(simulation, 0.6);
  const double late = 0.6 - 0.3 * (1.0 - std::exp(-0.6 / 0.3));
  EXPECT_NEAR(robot.pose().yaw, late, 0.01);
  EXPECT_NEAR(robot.twist().w, 1.0 - std::exp(-0.6 / 0.3), 0.01);
  Drive(simulation, "s1r", 0.15, 0.0);
  Advance(simulation, 3.0);  // the lag has died away: a curve of 1 m to the right
  EXPECT_NEAR(robot.twist().w, -0.15, 1e-3);
  EXPECT_EQ(robot.command().w, 0.0);
  Drive(simulation, "s1r", 0.0, 0.0);
  simulation.ResetObjects();
  Advance(simulation, 0.2);
  EXPECT_EQ(robot.twist().w, 0.0);
}

TEST(R09, TwoRobotsAreEquippedAlike) {
  const Simulation simulation(ParseS1r(
      R"({"robots": [{"name": "a", "pose": {"x": 1.2, "y": 2.0}},
                     {"name": "b", "pose": {"x": 2.0, "y": 2.8}}]})"));
  ASSERT_EQ(simulation.components().size(), 16U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(simulation.components()[i]->type(), simulation.components()[i + 8]->type());
  }
}

TEST(R10, TheLaserSitsInFrontAndScansTenTimesASecond) {
  Simulation simulation(ParseS1r("{}"));
  const auto* laser = dynamic_cast<LaserScanner*>(simulation.FindComponent("s1r.hokuyo"));
  EXPECT_DOUBLE_EQ(laser->mount().x, 0.035);
  Advance(simulation, 2.0);
  EXPECT_EQ(laser->samples(), 20U);
}

TEST(R11, TheLasersConfigurationIsTheThesiss) {
  const Simulation simulation(ParseS1r("{}"));
  const Json configuration = simulation.FindComponent("s1r.hokuyo")->Configurations();
  EXPECT_EQ(*configuration.Find("Visible_arc"), Json(false));
  EXPECT_EQ(*configuration.Find("resolution"), Json(0.39589));
  EXPECT_EQ(*configuration.Find("scan_window"), Json(270.0));
  EXPECT_EQ(*configuration.Find("laser_range"), Json(5.0));
  EXPECT_EQ(*configuration.Find("layer_offset"), Json(0.125));
}

TEST(R12, AScanHas682Ranges) {
  Simulation simulation(ParseS1r("{}"));
  Advance(simulation, 0.1);
  EXPECT_EQ(Data(simulation, "s1r.hokuyo").Find("range_list")->AsArray().size(), 682U);
  EXPECT_EQ(Data(simulation, "s1r.hokuyo").Find("point_list")->AsArray().size(), 682U);
}

TEST(Laser, PointsLieAtTheirRangesAndTheWallWhereItIs) {
  // Facing the lower border from 1 m: the middle beam meets it at y = 0.04.
  Simulation simulation(
      ParseS1r(R"({"robots": [{"pose": {"x": 3.1, "y": 0.3, "yaw_deg": -90}}]})"));
  Advance(simulation, 0.1);
  const Json data = Data(simulation, "s1r.hokuyo");
  const Json::Array& ranges = data.Find("range_list")->AsArray();
  const Json::Array& points = data.Find("point_list")->AsArray();
  EXPECT_NEAR(ranges[341].AsDouble(), 0.3 - 0.035 - 0.04, 1e-4);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Json::Array& point = points[i].AsArray();
    const double length = std::hypot(point[0].AsDouble(), point[1].AsDouble());
    EXPECT_NEAR(length, ranges[i].AsDouble() < 5.0 ? ranges[i].AsDouble() : 0.0, 1e-9);
  }
}

TEST(Laser, SeesAnotherRobotsHull) {
  Simulation simulation(ParseS1r(
      R"({"robots": [{"name": "a", "pose": {"x": 1.0, "y": 2.4}},
                     {"name": "b", "pose": {"x": 2.0, "y": 2.4}}]})"));
  Advance(simulation, 0.1);
  const Json data = Data(simulation, "a.hokuyo");
  // b's hull ends 0.087 m behind its origin; a's scanner sits 0.035 m before its own.
  EXPECT_NEAR(data.Find("range_list")->AsArray()[341].AsDouble(), 1.0 - 0.087 - 0.035, 1e-4);
}

TEST(Motion, ThreeTenthsOfAMetreASecondForOneSecondIsThreeTenthsOfAMetre) {  // thesis S11
  Simulation simulation(ParseS1r(R"({"robots": [{"pose": {"x": 1.0, "y": 2.0}}]})"));
  Drive(simulation, "s1r", 0.3, 0.0);
  Advance(simulation, 1.0);
  EXPECT_NEAR(simulation.robots()[0]->pose().x, 1.3, 1e-12);
  EXPECT_NEAR(simulation.robots()[0]->tally().distance, 0.3, 1e-12);
}

TEST(Motion, SpeedsAreClampedToTheRobotsLimits) {
  Simulation simulation(ParseS1r(R"({"robots": [{"pose": {"x": 1.0, "y": 2.0}}]})"));
  Drive(simulation, "s1r", 1e300, 0.0);
  Advance(simulation, 0.5);
  const auto& robot = *simulation.robots()[0];
  EXPECT_NEAR(robot.pose().x, 1.0 + 0.5 * robot.model().max_speed, 1e-9);
}

TEST(Motion, ACommandThatIsNoNumberChangesNothing) {
  Simulation simulation(ParseS1r("{}"));
  Drive(simulation, "s1r", 0.1, 0.2);
  EXPECT_THROW(Drive(simulation, "s1r", std::nan(""), 0.0), WrongArgument);
  auto* motion = dynamic_cast<Actuator*>(simulation.FindComponent("s1r.motion"));
  EXPECT_THROW(motion->Receive(Json::Parse("{\"v\": 1}")), WrongArgument);
  EXPECT_THROW(motion->Receive(Json::Parse("[]")), WrongArgument);
  EXPECT_EQ(*Data(simulation, "s1r.motion").Find("v"), Json(0.1));
}

TEST(Contact, ARobotThatRunsAgainstAWallStopsAndSaysStall) {
  Simulation simulation(
      ParseS1r(R"({"robots": [{"pose": {"x": 3.1, "y": 0.4, "yaw_deg": -90}}]})"));
  Drive(simulation, "s1r", 0.3, 0.0);
  Advance(simulation, 2.0);
  const Robot& robot = *simulation.robots()[0];
  EXPECT_TRUE(robot.stalled());
  EXPECT_EQ(robot.tally().contacts, 1U);
  EXPECT_NEAR(robot.pose().y, 0.04 + 0.087, 1e-3);
  EXPECT_GE(robot.pose().y, 0.04 + 0.087);
  EXPECT_EQ(*Data(simulation, "s1r.odometry").Find("stall"), Json(true));
  EXPECT_EQ(*Data(simulation, "s1r.odometry").Find("vx"), Json(0.0));
  // It is not stuck: back it goes.
  Drive(simulation, "s1r", -0.3, 0.0);
  Advance(simulation, 0.5);
  EXPECT_FALSE(robot.stalled());
  EXPECT_GT(robot.pose().y, 0.2);
}

TEST(Contact, RobotsStopEachOther) {
  Simulation simulation(ParseS1r(
      R"({"robots": [{"name": "a", "pose": {"x": 1.0, "y": 2.4}},
                     {"name": "b", "pose": {"x": 2.0, "y": 2.4, "yaw_deg": 180}}]})"));
  Drive(simulation, "a", 0.3, 0.0);
  Drive(simulation, "b", 0.3, 0.0);
  Advance(simulation, 3.0);
  const double gap = simulation.robots()[1]->pose().x - simulation.robots()[0]->pose().x;
  EXPECT_GE(gap, 2 * 0.087);
  EXPECT_LT(gap, 2 * 0.087 + 1e-3);
}

TEST(L203, OdometryIntegratesToTheDrivenPath) {
  Simulation simulation(ParseS1r(R"({"robots": [{"pose": {"x": 1.5, "y": 2.4, "yaw_deg": 30}}]})"));
  Drive(simulation, "s1r", 0.2, 1.0);
  Advance(simulation, 1.0);
  simulation.Sense();
  const Json odometry = Data(simulation, "s1r.odometry");
  // A quarter-circle-like arc of radius 0.2 m from the odometry's origin.
  EXPECT_NEAR(odometry.Find("x")->AsDouble(), 0.2 * std::sin(1.0), 1e-9);
  EXPECT_NEAR(odometry.Find("y")->AsDouble(), 0.2 * (1.0 - std::cos(1.0)), 1e-9);
  EXPECT_NEAR(odometry.Find("yaw")->AsDouble(), 1.0, 1e-9);
  EXPECT_NEAR(odometry.Find("vx")->AsDouble(), 0.2, 1e-12);
  EXPECT_NEAR(odometry.Find("wz")->AsDouble(), 1.0, 1e-12);
}

TEST(C10, PropertiesHoldTheConfigurationAndTheModelsData) {
  Simulation simulation(ParseS1r(
      R"({"robots": [{"color": "#102030", "drivers": {"snd": {"max_speed": 0.2}}}],
          "canvas": {"mode": "fullscreen", "mode_switching": false}})"));
  const Json properties = *Data(simulation, "s1r.properties").Find("properties");
  EXPECT_EQ(*properties.Find("mass"), Json(2.0));
  EXPECT_EQ(*properties.Find("color"), Json::Parse("[16, 32, 48]"));
  EXPECT_EQ(*properties.Find("drivers")->Find("snd")->Find("max_speed"), Json(0.2));
  EXPECT_EQ(*properties.Find("canvas")->Find("mode"), Json("fullscreen"));
  EXPECT_EQ(*properties.Find("canvas")->Find("mode_switching"), Json(false));
  EXPECT_EQ(*properties.Find("proxies")->Find("position2d")->Find("0"), Json("pose"));
}

TEST(C11, PropertiesAreASensor) {
  const Simulation simulation(ParseS1r("{}"));
  EXPECT_NE(dynamic_cast<Sensor*>(simulation.FindComponent("s1r.properties")), nullptr);
}

}  // namespace
}  // namespace ccmorse::sim
