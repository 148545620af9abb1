// What a scenario file can say, and what it means.

#include "scene/scenario.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/polygon.h"
#include "base/trig.h"
#include "scene/robots.h"

namespace ccmorse::scene {
namespace {

Scenario Parse(const std::string& text) { return ParseScenario(text, "test.json"); }

LaserDef Laser(const std::string& settings) {
  return Parse("{\"robots\": [{\"laser\": {" + settings + "}}]}").robots.at(0).laser;
}

TEST(C01, EditingTheFileChangesTheScene) {
  const Scenario before = Parse(R"({"robots": [{"pose": {"x": 1.2, "y": 2.0}}]})");
  const Scenario after = Parse(R"({"robots": [{"pose": {"x": 2.2, "y": 2.6}}],
                                   "obstacles": {"up": [59]}})");
  EXPECT_DOUBLE_EQ(before.robots[0].pose.x, 1.2);
  EXPECT_DOUBLE_EQ(after.robots[0].pose.x, 2.2);
  EXPECT_FALSE(before.world.boxes[58].raised);
  EXPECT_TRUE(after.world.boxes[58].raised);
}

TEST(C02, EmptyFileIsTheArenaWithOneRobot) {
  const Scenario scenario = Parse("{}");
  EXPECT_EQ(scenario.name, "test");
  EXPECT_EQ(scenario.world.name, "syrotek");
  ASSERT_EQ(scenario.robots.size(), 1U);
  EXPECT_EQ(scenario.robots[0].name, "s1r");
  EXPECT_EQ(scenario.robots[0].type, "S1R");
  EXPECT_EQ(scenario.canvas.width, 172);
  EXPECT_EQ(scenario.canvas.height, 186);
  EXPECT_DOUBLE_EQ(scenario.canvas.alpha, 1.0);
  EXPECT_EQ(scenario.canvas.mode, "ground");
  EXPECT_DOUBLE_EQ(scenario.time.frequency, 60.0);
  EXPECT_EQ(scenario.time.strategy, "realtime");
  EXPECT_DOUBLE_EQ(scenario.time.read_frequency, 10.0);
  EXPECT_EQ(scenario.seed, 1U);
}

TEST(C02, DefaultPoseIsFreeWhicheverBoxesAreUp) {
  const Scenario scenario = Parse("{}");
  std::vector<Vec2> outline;
  for (const Vec2 corner : FindRobotModel("S1R").footprint) {
    outline.push_back(Transform(scenario.robots[0].pose, corner));
  }
  for (const Box& box : scenario.world.boxes) {
    EXPECT_GT(ConvexGap(outline, BoxCorners(box.pose, box.size_x, box.size_y)), 0.1) << box.id;
  }
}

TEST(C02, UnnamedRobotsAreNumbered) {
  const Scenario scenario = Parse(R"({"robots": [{}, {"pose": {"x": 2.2, "y": 2.6}}]})");
  EXPECT_EQ(scenario.robots[0].name, "s1r");
  EXPECT_EQ(scenario.robots[1].name, "s1r_2");
}

TEST(C02, ARunMayHaveNoRobotAtAll) { EXPECT_TRUE(Parse(R"({"robots": []})").robots.empty()); }

TEST(C03, StartPoseInRadiansOrDegrees) {
  const Pose2 degrees =
      Parse(R"({"robots": [{"pose": {"x": 2.2, "y": 2.6, "yaw_deg": -90}}]})").robots[0].pose;
  EXPECT_DOUBLE_EQ(degrees.x, 2.2);
  EXPECT_DOUBLE_EQ(degrees.y, 2.6);
  EXPECT_DOUBLE_EQ(degrees.yaw, -kPi / 2.0);
  const Pose2 radians =
      Parse(R"({"robots": [{"pose": {"x": 2.2, "y": 2.6, "yaw": 1.5}}]})").robots[0].pose;
  EXPECT_DOUBLE_EQ(radians.yaw, 1.5);
}

TEST(C04, ColorInThreeForms) {
  const auto color = [](const std::string& text) {
    return Parse("{\"robots\": [{\"color\": " + text + "}]}").robots[0].color;
  };
  EXPECT_EQ(color(R"("#34AAff")"), (Color{0x34, 0xAA, 0xFF}));
  EXPECT_EQ(color("[1, 2, 255]"), (Color{1, 2, 255}));
  EXPECT_EQ(color(R"("orange")"), (Color{255, 165, 0}));
}

TEST(C05, ProxyIndexesOfARobot) {
  const ProxyTable proxies =
      Parse(R"({"robots": [{"proxies": {"position2d": {"4": "odometry", "65535": "pose"}}}]})")
          .robots[0]
          .proxies;
  EXPECT_EQ(proxies.at("position2d"),
            (std::map<int, std::string>{{4, "odometry"}, {65535, "pose"}}));
  EXPECT_EQ(proxies.at("laser"), (std::map<int, std::string>{{0, "hokuyo"}}));  // not given
  EXPECT_TRUE(
      Parse(R"({"robots": [{"proxies": {"laser": {}}}]})").robots[0].proxies.at("laser").empty());
}

TEST(C06, DriverSettingsAreKeptAsGiven) {
  const auto drivers =
      Parse(R"({"robots": [{"drivers": {"snd": {"max_speed": 0.3, "goal": [1, 2]}}}]})")
          .robots[0]
          .drivers;
  ASSERT_EQ(drivers.count("snd"), 1U);
  EXPECT_EQ(drivers.at("snd").Dump(), R"({"max_speed": 0.3, "goal": [1, 2]})");
}

TEST(C07, CameraPlacement) {
  const CameraDef camera =
      Parse(R"({"camera": {"position": [1, -2, 3.5], "rotation": [0.5, 0, 0.25]}})").camera;
  EXPECT_DOUBLE_EQ(camera.position.y, -2.0);
  EXPECT_DOUBLE_EQ(camera.position.z, 3.5);
  EXPECT_DOUBLE_EQ(camera.rotation.z, 0.25);
}

TEST(C08, TimeStrategies) {
  const auto strategy = [](const std::string& name) {
    return Parse("{\"time\": {\"strategy\": \"" + name + "\"}}").time.strategy;
  };
  EXPECT_EQ(strategy("realtime"), "realtime");
  EXPECT_EQ(strategy("lockstep"), "lockstep");
  EXPECT_EQ(strategy("max"), "max");
  EXPECT_EQ(strategy("best_effort"), "realtime");
  EXPECT_EQ(strategy("fixed_simulation_step"), "max");
  const TimeDef time =
      Parse(R"({"time": {"frequency": 100, "factor": 2.5, "read_frequency": 20}})").time;
  EXPECT_DOUBLE_EQ(time.frequency, 100.0);
  EXPECT_DOUBLE_EQ(time.factor, 2.5);
  EXPECT_DOUBLE_EQ(time.read_frequency, 20.0);
}

TEST(C09, ScenariosDifferOnlyInTheirJson) {
  const Scenario a = LoadScenario(FindScenario("syrotek"));
  const Scenario b = LoadScenario(FindScenario("course_map"));
  EXPECT_EQ(a.world.boxes.size(), b.world.boxes.size());
  EXPECT_FALSE(a.world.boxes[68].raised);
  EXPECT_TRUE(b.world.boxes[68].raised);
}

TEST(C10, ModelSuppliesSizeAndWeight) {
  const RobotModel& model = FindRobotModel(Parse("{}").robots[0].type);
  EXPECT_GT(model.mass, 0.0);
  EXPECT_GT(model.length, 0.0);
  EXPECT_GT(model.width, 0.0);
  EXPECT_GT(model.height, 0.0);
}

TEST(C11, AllSettingsOfARobotCanBeReadBack) {
  const Json json = ToJson(Parse(R"({"robots": [{"drivers": {"snd": {"max_speed": 0.3}}}]})"));
  const Json& robot = json.Find("robots")->AsArray().at(0);
  for (const char* key : {"name", "type", "pose", "color", "proxies", "drivers", "laser"}) {
    EXPECT_NE(robot.Find(key), nullptr) << key;
  }
  EXPECT_DOUBLE_EQ(robot.Find("drivers")->Find("snd")->Find("max_speed")->AsDouble(), 0.3);
}

TEST(C12, CanvasModeAndSwitching) {
  const CanvasDef canvas = Parse(R"({"canvas": {"width": 200, "height": 100, "alpha": 0.5,
      "mode": "fullscreen", "mode_switching": false}})")
                               .canvas;
  EXPECT_EQ(canvas.width, 200);
  EXPECT_EQ(canvas.height, 100);
  EXPECT_DOUBLE_EQ(canvas.alpha, 0.5);
  EXPECT_EQ(canvas.mode, "fullscreen");
  EXPECT_FALSE(canvas.mode_switching);
}

TEST(N02, ObstaclesGoUpAndDown) {
  const World world = Parse(R"({"obstacles": {"up": [5, 76, 5], "down": [10]}})").world;
  for (const Box& box : world.boxes) {
    if (box.dynamic) {
      EXPECT_EQ(box.raised, box.id == 5 || box.id == 76) << box.id;
    }
  }
}

TEST(Q11, PresetOfTheRealScanner) {
  const LaserDef laser = Laser(R"("preset": "urg04lx")");
  EXPECT_EQ(laser.samples, 682);
  EXPECT_DOUBLE_EQ(laser.resolution_deg, 0.3515625);
  EXPECT_NEAR(laser.scan_window_deg, 239.4, 0.05);
  EXPECT_DOUBLE_EQ(laser.range, 5.6);
  EXPECT_DOUBLE_EQ(Laser(R"("preset": "urg04lx", "range": 4)").range, 4.0);
  EXPECT_DOUBLE_EQ(Laser(R"("preset": "thesis")").scan_window_deg, 270.0);
}

TEST(Lasers, PresetsOfMorsesScanners) {
  const auto expect = [](const char* preset, int samples, double range, double frequency) {
    const LaserDef laser = Laser("\"preset\": \"" + std::string(preset) + "\"");
    EXPECT_EQ(laser.samples, samples) << preset;
    EXPECT_EQ(laser.range, range) << preset;
    EXPECT_EQ(laser.frequency, frequency) << preset;
  };
  expect("hokuyo", 1081, 30.0, 10.0);
  expect("sick", 181, 30.0, 10.0);
  expect("infrared", 21, 2.0, 10.0);
  expect("sick_ldmrs", 401, 30.0, 4.0);
  EXPECT_EQ(Laser(R"("preset": "sick_ldmrs")").layers, 4);
  EXPECT_EQ(Laser(R"("preset": "sick")").layers, 1);
}

TEST(Lasers, MayBeTilted) {
  const LaserDef laser = Laser(R"("roll": 0.1, "pitch_deg": 30, "yaw_deg": -90)");
  EXPECT_DOUBLE_EQ(laser.roll, 0.1);
  EXPECT_DOUBLE_EQ(laser.pitch, kPi / 6);
  EXPECT_DOUBLE_EQ(laser.yaw, -kPi / 2);
}

TEST(Meshes, AreReadWithTheirDefaults) {
  const World world = Parse(R"({"world": {"name": "w", "size": [4, 4], "meshes": [
      {"id": 9, "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "triangles": [[0, 1, 2]]},
      {"id": 3, "name": "b", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
       "triangles": [[2, 1, 0]], "position": [1, 2, 3], "rotation": [0.1, 0.2, 0.3],
       "color": "red"}]}, "robots": []})")
                          .world;
  ASSERT_EQ(world.meshes.size(), 2U);
  EXPECT_EQ(world.meshes[0].id, 3);
  EXPECT_EQ(world.meshes[0].triangles[0], (std::array<int, 3>{2, 1, 0}));
  EXPECT_EQ(world.meshes[0].position.z, 3.0);
  EXPECT_EQ(world.meshes[0].rotation.y, 0.2);
  EXPECT_EQ(world.meshes[1].position.x, 0.0);
  EXPECT_EQ(world.meshes[1].vertices[1].x, 1.0);
}

TEST(Rings, AreReadWithTheModelsNumbers) {
  const RobotDef robot =
      Parse(R"({"robots": [{"front": "sensors", "ir": true, "sonar": {"range": 2}}]})").robots[0];
  EXPECT_EQ(robot.ir->range, 0.35);
  EXPECT_EQ(robot.ir->cone_deg, 2.0);
  EXPECT_EQ(robot.sonar->range, 2.0);
  EXPECT_EQ(robot.sonar->cone_deg, 50.0);
  EXPECT_EQ(robot.sonar->min_range, 0.05);
  EXPECT_EQ(robot.proxies.count("laser"), 0U);
}

TEST(Q12, MorseCountsTheBeamsWhereTheFileDoesNot) {
  EXPECT_EQ(Laser(R"("scan_window_deg": 180, "resolution_deg": 1)").samples, 181);
  EXPECT_EQ(Laser(R"("scan_window_deg": 270, "resolution_deg": 0.25)").samples, 1081);
  EXPECT_EQ(Laser(R"("scan_window_deg": 20, "resolution_deg": 1)").samples, 21);
  // By MORSE's rule the thesis's numbers would make one beam more than the thesis says.
  EXPECT_EQ(Laser(R"("scan_window_deg": 270, "resolution_deg": 0.39589)").samples, 683);
  EXPECT_EQ(Laser(R"("range": 4)").samples, 682);
}

TEST(Q12, SamplesAloneSpreadOverTheWindow) {
  const LaserDef laser = Laser(R"("scan_window_deg": 180, "samples": 361)");
  EXPECT_EQ(laser.samples, 361);
  EXPECT_DOUBLE_EQ(laser.resolution_deg, 0.5);
  const LaserDef centred = Laser(R"("resolution_deg": 0.5, "samples": 181)");
  EXPECT_DOUBLE_EQ(centred.scan_window_deg, 90.0);
}

TEST(ScenarioFile, WholeNumbersMayBeWrittenAsReals) {
  EXPECT_EQ(Parse(R"({"canvas": {"width": 200.0}})").canvas.width, 200);
}

}  // namespace
}  // namespace ccmorse::scene
