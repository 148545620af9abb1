// Things from files of shapes in a scene: passive objects and robots' own models (docs/assets.md).

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.h"
#include "base/json.h"
#include "scene/asset_props.h"
#include "scene/scenario.h"
#include "sim/robots/robot.h"
#include "sim/simulation.h"

namespace ccmorse::sim {
namespace {

namespace fs = std::filesystem;

// A box as an OBJ's group: from `low` to `high`, m. `first`: index of its first vertex.
std::string BoxText(const std::string& name, const Vec3& low, const Vec3& high, int first) {
  std::string text = "o " + name + "\n";
  for (int i = 0; i < 8; ++i) {
    text += "v " + std::to_string((i & 1) != 0 ? high.x : low.x) + " " +
            std::to_string((i & 2) != 0 ? high.y : low.y) + " " +
            std::to_string((i & 4) != 0 ? high.z : low.z) + "\n";
  }
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
  for (const auto& face : faces) {
    text += "f";
    for (const int corner : face) text += " " + std::to_string(first + corner);
    text += "\n";
  }
  return text;
}

class Props : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("ccmorse_props_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    ::setenv("CCMORSE_CACHE", "off", 1);
    // A table 1.2 m x 0.8 m, 0.75 m high: a top and a leg; and a chair beside it.
    Write("room.obj", BoxText("TableTop", {-0.6, -0.4, 0.7}, {0.6, 0.4, 0.75}, 1) +
                          BoxText("TableLeg", {-0.05, -0.05, 0.0}, {0.05, 0.05, 0.7}, 9) +
                          BoxText("Chair", {1.0, -0.2, 0.0}, {1.4, 0.2, 0.45}, 17));
    // A robot of two boxes: a wide one beneath a narrow one, 0.2 m below its origin.
    Write("rover.obj", BoxText("Body", {-0.4, -0.3, -0.2}, {0.4, 0.3, 0.3}, 1) +
                           BoxText("Mast", {-0.1, -0.1, 0.3}, {0.1, 0.1, 1.0}, 9));
  }
  void TearDown() override { fs::remove_all(folder_); }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  scene::Scenario Parse(const std::string& text) const {
    return scene::ParseScenario(text, (folder_ / "scene.json").string());
  }
  std::string ErrorOf(const std::string& text) const {
    try {
      Parse(text);
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  }

  // A robot at (-2, 0) with a scanner at `height` and what else stands in the room.
  std::string Room(const std::string& props, double height = 0.72, const std::string& more = "") {
    return R"({"world": {"name": "room", "size": [20, 20], "low": [-10, -10]}, "props": [)" +
           props + R"(], "robots": [{"name": "robot", "pose": {"x": -2, "y": 0}, "type": "Custom",
      "body": {"footprint": [[0.2, -0.2], [0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2]]}, "components": [
        {"name": "laser", "type": "LaserScanner", "position": [0, 0, )" +
           std::to_string(height) + R"(], "laser": {"scan_window_deg": 20, "resolution_deg": 10}},
        {"name": "near", "type": "Proximity", "properties": {"Track": "Object"}}]})" +
           more + "]}";
  }

  static double Ahead(const scene::Scenario& scenario) {
    Simulation simulation(scenario, 1);
    simulation.Sense();
    const Json data = Json::Parse(simulation.FindComponent("robot.laser")->LocalData());
    return data.Find("range_list")->AsArray()[1].AsDouble();
  }

  fs::path folder_;
};

TEST_F(Props, ALaserSeesTheEdgeOfATable) {
  const std::string table =
      R"({"name": "table", "file": "room.obj", "object": "Table", "position": [1, 0, 0]})";
  EXPECT_NEAR(Ahead(Parse(Room(table))), 2.0 + 1.0 - 0.6, 1e-9);
  EXPECT_NEAR(Ahead(Parse(Room(table, 0.3))), 3.0 - 0.05, 1e-9) << "the leg";
  const std::string turned = R"({"name": "table", "file": "room.obj", "object": "Table",
    "position": [1, 0, 0], "rotation": [0, 0, 1.5707963267948966]})";
  EXPECT_NEAR(Ahead(Parse(Room(turned))), 3.0 - 0.4, 1e-9);
  const std::string half = R"({"name": "table", "file": "room.obj", "object": "Table",
    "position": [1, 0, 0.36], "scale": 0.5})";
  EXPECT_NEAR(Ahead(Parse(Room(half))), 3.0 - 0.3, 1e-9);
}

TEST_F(Props, OnlyTheObjectsThatTheNameMeansAreThere) {
  const scene::Scenario scenario = Parse(
      Room(R"({"name": "a chair", "file": "room.obj", "object": "Chair", "position": [0, 3, 0]})"));
  ASSERT_EQ(scenario.world.meshes.size(), 1U);
  EXPECT_EQ(scenario.world.meshes[0].name, "a_chair");
  EXPECT_EQ(scenario.props[0].meshes, std::vector<int>{1});
  EXPECT_THAT(ErrorOf(Room(R"({"name": "x", "file": "room.obj", "object": "Sofa"})")),
              testing::HasSubstr("has no object called Sofa"));
  EXPECT_THAT(ErrorOf(Room(R"({"name": "x", "file": "no.obj"})")),
              testing::HasSubstr("there is no file 'no.obj'"));
}

TEST_F(Props, WhatHasNoPhysicsIsSeenByViewersOnly) {
  const scene::Scenario scenario = Parse(Room(R"({"name": "table", "file": "room.obj",
    "object": "Table", "position": [1, 0, 0], "physics": "NO_COLLISION"})"));
  EXPECT_EQ(Ahead(scenario), 30.0);
  EXPECT_TRUE(scenario.world.meshes[0].drawn);
}

TEST_F(Props, AShapeOfItsOwnNeedsNoFile) {
  const std::string shape = R"({"name": "sheet", "file": "", "position": [1, 0, 0], "shape": [
    {"vertices": [[0, -1, 0], [0, 1, 0], [0, 1, 2], [0, -1, 2]],
     "triangles": [[0, 1, 2], [0, 2, 3]]}])";
  EXPECT_EQ(Ahead(Parse(Room(shape + "}"))), 30.0);
  EXPECT_NEAR(Ahead(Parse(Room(shape + R"(, "physics": "STATIC"})"))), 3.0, 1e-9);
}

TEST_F(Props, ProximityKnowsThemByTheirProperties) {
  Simulation simulation(Parse(Room(R"({"name": "table", "file": "room.obj", "object": "Table",
    "position": [1, 0, 0], "properties": {"Object": true}})")),
                        1);
  for (int i = 0; i < 10; ++i) {
    simulation.Sense();
    simulation.Act();
  }
  const Json data = Json::Parse(simulation.FindComponent("robot.near")->LocalData());
  EXPECT_NEAR(data.Find("near_objects")->Find("table")->AsDouble(), 3.0, 1e-9);
}

TEST_F(Props, WrittenInFullTheSceneNeedsNoFile) {
  const scene::Scenario scenario = Parse(Room(
      R"({"name": "table", "file": "room.obj", "object": "Table", "position": [1, 0, 0]})", 0.72,
      R"(, {"name": "rover", "pose": {"x": 5, "y": 5}, "type": "Custom",
           "body": {"model": {"file": "rover.obj"}}})"));
  const std::string text = scene::ToJson(scenario).Dump();
  const scene::Scenario again = scene::ParseScenario(text, "elsewhere.json");
  EXPECT_EQ(scene::ToJson(again).Dump(), text);
  EXPECT_EQ(Ahead(again), Ahead(scenario));
}

TEST_F(Props, ARobotsModelIsItsBody) {
  const scene::Scenario scenario =
      Parse(Room("", 0.72, R"(, {"name": "rover", "pose": {"x": 1, "y": 0}, "type": "Custom",
                          "body": {"model": {"file": "rover.obj"}}})"));
  const scene::BodyDef& body = *scenario.robots[1].body;
  EXPECT_EQ(body.origin_height, 0.2);
  ASSERT_EQ(body.footprint.size(), 4U);
  double front = 0.0;
  for (const Vec2 corner : body.footprint) front = std::max(front, corner.x);
  EXPECT_NEAR(front, 0.4, 1e-12);
  EXPECT_NEAR(body.hull.front().bottom, 0.0, 1e-12);
  EXPECT_NEAR(body.hull.back().top, 1.2, 1e-12);
  EXPECT_EQ(body.shape.size(), 2U);
  // Others see the wide part below and the narrow one above.
  EXPECT_NEAR(Ahead(scenario), 3.0 - 0.1, 1e-9);
  const scene::Scenario low =
      Parse(Room("", 0.3, R"(, {"name": "rover", "pose": {"x": 1, "y": 0}, "type": "Custom",
                          "body": {"model": {"file": "rover.obj"}}})"));
  EXPECT_NEAR(Ahead(low), 3.0 - 0.4, 1e-9);
}

TEST_F(Props, AModelBesideAFootprintIsForViewersOnly) {
  const scene::Scenario scenario = Parse(Room("", 0.72, R"(, {"name": "rover",
    "pose": {"x": 1, "y": 0}, "type": "Custom", "body": {"model": {"file": "rover.obj"},
    "footprint": [[0.2, -0.2], [0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2]], "mass": 3}})"));
  EXPECT_EQ(scenario.robots[1].body->shape.size(), 2U);
  EXPECT_TRUE(scenario.robots[1].body->hull.empty());
  EXPECT_EQ(Ahead(scenario), 30.0);
}

TEST(RobotShape, AFootprintOfManyCornersIsRoundedToSixteen) {
  std::vector<Vec2> circle;
  for (int i = 0; i < 100; ++i) {
    circle.push_back({std::cos(0.0628 * i), std::sin(0.0628 * i)});
  }
  const std::vector<Vec2> hull = scene::RoundedHull(circle, 16);
  ASSERT_EQ(hull.size(), 16U);
  double area = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    area += 0.5 * Cross(hull[i], hull[(i + 1) % hull.size()]);
  }
  EXPECT_GT(area, 0.95 * 3.14159);
  EXPECT_LT(area, 3.14159);
}

}  // namespace
}  // namespace ccmorse::sim
