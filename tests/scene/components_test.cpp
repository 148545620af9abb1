// Robots that list their own devices, worlds around (0, 0): what MORSE's builder scripts need of a
// scenario (specs: morse.md C).

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "scene/scenario.h"

namespace ccmorse::scene {
namespace {

const std::string kWorld = R"("world": {"name": "around", "size": [40, 30], "low": [-20, -15]})";

std::string Text(const std::string& components, const std::string& more = "") {
  return "{" + kWorld +
         R"(, "robots": [{"name": "atrv", "type": "Custom", "pose": {"x": -5, "y": -2},
    "body": {"footprint": [[0.5, -0.3], [0.5, 0.3], [-0.5, 0.3], [-0.5, -0.3]], "origin_height": 0.1},
    "components": [)" +
         components + "]" + more + "}]}";
}

std::string ScenarioError(const std::string& text) {
  try {
    ParseScenario(text, "scene.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Components, SkillsAndOverlaysAreReadAndWritten) {
  const std::string text = Text(
      R"({"name": "go", "type": "Waypoint", "overlays": [{"code": "my.overlays.Guide",
          "path": ["src"], "settings": {"slowness": 2.0, "named": "guide"}, "services":
          [{"name": "walk", "asynchronous": true,
            "parameters": [{"name": "x"}, {"name": "y", "optional": true}]}]},
          {"code": "Other"}]})",
      R"(, "services": true, "skills": ["heal", "grasp"])");
  const Scenario scenario = ParseScenario(text, "scene.json");
  const Scenario again = ParseScenario(ToJson(scenario).Dump(), "again.json");
  EXPECT_EQ(ToJson(again).Dump(), ToJson(scenario).Dump());
  for (const Scenario* each : {&scenario, &again}) {
    const RobotDef& robot = each->robots.at(0);
    EXPECT_EQ(robot.skills, (std::vector<std::string>{"heal", "grasp"}));
    const std::vector<OverlayDef>& overlays = robot.components->at(0).overlays;
    ASSERT_EQ(overlays.size(), 2U);
    EXPECT_EQ(overlays[0].code, "my.overlays.Guide");
    EXPECT_EQ(overlays[0].path, std::vector<std::string>{"src"});
    EXPECT_EQ(overlays[0].settings.Dump(), R"({"slowness": 2.0, "named": "guide"})");
    ASSERT_EQ(overlays[0].services.size(), 1U);
    EXPECT_TRUE(overlays[0].services[0].asynchronous);
    ASSERT_EQ(overlays[0].services[0].parameters.size(), 2U);
    EXPECT_TRUE(overlays[0].services[0].parameters[1].optional);
    EXPECT_TRUE(overlays[1].services.empty());
  }
  EXPECT_TRUE(Has(ScenarioError(Text("", R"(, "skills": ["fly"])")), "skills"));
  EXPECT_TRUE(
      Has(ScenarioError(Text(R"({"name": "go", "type": "Pose", "overlays": [{"path": []}]})")),
          "code"));
}

TEST(Components, AreReadAndWritten) {
  const Scenario scenario = ParseScenario(
      Text(R"({"name": "where", "type": "Pose", "position": [0.3, 0, 0.5], "rotation": [0, 0, 1],
               "frequency": 20, "stream": false, "noise": {"pos_std": 0.1}},
              {"name": "arm.sick", "type": "LaserScanner", "frequency": 5, "position": [0, 0, 0.4],
               "laser": {"range": 8, "scan_window_deg": 90, "resolution_deg": 1}},
              {"name": "go", "type": "MotionVW", "services": false})"),
      "scene.json");
  const Scenario again = ParseScenario(ToJson(scenario).Dump(), "again.json");
  EXPECT_EQ(ToJson(again).Dump(), ToJson(scenario).Dump());
  for (const Scenario* each : {&scenario, &again}) {
    const RobotDef& robot = each->robots.at(0);
    EXPECT_EQ(each->world.low.x, -20.0);
    EXPECT_EQ(each->world.high().y, 15.0);
    EXPECT_EQ(robot.body->origin_height, 0.1);
    ASSERT_TRUE(robot.components);
    ASSERT_EQ(robot.components->size(), 3U);
    const ComponentDef& where = robot.components->at(0);
    EXPECT_EQ(where.position.z, 0.5);
    EXPECT_EQ(where.rotation.z, 1.0);
    EXPECT_EQ(where.frequency, 20.0);
    EXPECT_EQ(where.noise.pos_std, 0.1);
    EXPECT_FALSE(where.stream);
    const ComponentDef& sick = robot.components->at(1);
    EXPECT_EQ(sick.name, "arm.sick");
    EXPECT_EQ(sick.laser.samples, 91);
    EXPECT_EQ(sick.laser.frequency, 5.0);
    EXPECT_EQ(sick.laser.position.z, 0.4);
    EXPECT_FALSE(robot.components->at(2).services);
    // Player's clients find the first ones.
    EXPECT_EQ(robot.proxies.at("position2d").at(0), "where");
    EXPECT_EQ(robot.proxies.at("laser").at(0), "arm.sick");
    EXPECT_EQ(DevicesFor(robot, "laser"), std::vector<std::string>{"arm.sick"});
    EXPECT_EQ(DevicesFor(robot, "position2d"), std::vector<std::string>{"where"});
  }
}

TEST(Components, OnesOfAnS1RStandInForItsOwn) {
  const Scenario scenario = ParseScenario(
      R"({"robots": [{"components": [{"name": "go", "type": "MotionVW"}]}]})", "scene.json");
  EXPECT_EQ(scenario.robots[0].type, "S1R");
  EXPECT_EQ(scenario.robots[0].components->size(), 1U);
  EXPECT_TRUE(scenario.robots[0].proxies.empty());
  const std::string text = ToJson(scenario).Dump();
  EXPECT_EQ(ToJson(ParseScenario(text, "again.json")).Dump(), text);
}

TEST(Components, MistakesAreNamed) {
  EXPECT_TRUE(Has(ScenarioError(Text(R"({"name": "a", "type": "Posse"})")), "did you mean 'Pose'"));
  EXPECT_TRUE(Has(ScenarioError(Text(R"({"name": "a"})")), "type"));
  EXPECT_TRUE(Has(ScenarioError(Text(R"({"name": "a..b", "type": "Pose"})")), "dots between them"));
  EXPECT_TRUE(
      Has(ScenarioError(Text(R"({"name": "a", "type": "Pose"}, {"name": "a", "type": "Pen"})")),
          "is called 'a', as is another component"));
  EXPECT_TRUE(Has(ScenarioError(Text(R"({"name": "a", "type": "Pose", "rate": 1})")), "'rate'"));
  EXPECT_TRUE(Has(ScenarioError(Text(R"({"name": "a", "type": "Pose", "laser": {}})")),
                  "is for a LaserScanner"));
  EXPECT_TRUE(
      Has(ScenarioError(Text(R"({"name": "a", "type": "Pen", "noise": {}})")), "is for a Pose"));
  EXPECT_TRUE(Has(ScenarioError(Text("", R"(, "laser": {})")), "a robot without 'components'"));
}

TEST(World, ARobotStandsOnItsFloorWhereverThatLies) {
  EXPECT_EQ(ScenarioError(Text("")), "");
  std::string beside = Text("");
  beside.replace(beside.find("\"x\": -5"), 7, "\"x\": -21");
  EXPECT_TRUE(Has(ScenarioError(beside), "does not stand on the floor"));
}

TEST(Scenario, KeepsWhatModelsItWasMadeFor) {
  const std::string text = R"({"environment": "indoors-1/boxes", "props": [{"name": "table",
    "file": "props/objects", "object": "Table", "position": [1, 2, 3], "rotation": [0, 0, 1]}]})";
  const Scenario scenario = ParseScenario(text, "scene.json");
  EXPECT_EQ(scenario.environment, "indoors-1/boxes");
  ASSERT_EQ(scenario.props.size(), 1U);
  EXPECT_EQ(scenario.props[0].object, "Table");
  EXPECT_EQ(scenario.props[0].position.z, 3.0);
  const std::string written = ToJson(scenario).Dump();
  EXPECT_EQ(ToJson(ParseScenario(written, "again.json")).Dump(), written);
  EXPECT_TRUE(Has(ScenarioError(R"({"props": [{"name": "table"}]})"), "file"));
}

}  // namespace
}  // namespace ccmorse::scene
