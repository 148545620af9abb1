// Robots on meshes that are the ground (scene::World::terrain; docs/assets.md): how high they
// stand, how they lean, what stops them, and what their sensors see from there.

#include "sim/ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "base/json.h"
#include "scene/scenario.h"
#include "sim/robots/robot.h"
#include "sim/simulation.h"

namespace ccmorse::sim {
namespace {

// A level plane of 40 m at z = 0.
constexpr const char* kPlane = R"({"id": 1, "name": "Plane", "vertices":
  [[-20, -20, 0], [20, -20, 0], [20, 20, 0], [-20, 20, 0]], "triangles": [[0, 1, 2], [0, 2, 3]]})";
// A slope from x = 2 up to 2 m at x = 6, and a level top to x = 10.
constexpr const char* kRamp = R"({"id": 2, "name": "Ramp", "vertices":
  [[2, -3, 0], [6, -3, 2], [10, -3, 2], [10, 3, 2], [6, 3, 2], [2, 3, 0]],
  "triangles": [[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4]]})";

// A sheet from (x0, -3) to (x1, 3) at height z; upright where x0 = x1, from 0 to z.
std::string Sheet(double x0, double x1, double z, const std::string& more = "") {
  const auto text = [](double v) { return std::to_string(v); };
  const std::string low = x0 == x1 ? "0" : text(z);
  return R"({"id": 3, "name": "Sheet", "vertices": [[)" + text(x0) + ", -3, " + low + "], [" +
         text(x1) + ", -3, " + text(z) + "], [" + text(x1) + ", 3, " + text(z) + "], [" + text(x0) +
         ", 3, " + low + R"(]], "triangles": [[0, 1, 2], [0, 2, 3]])" + more + "}";
}

// A robot of half a metre, `high` m, with its origin 0.1 m above its foot.
std::string RobotText(const std::string& name, double x, double y, double high = 1.0,
                      const std::string& more = "", const std::string& components = "") {
  const std::string square = "[[0.25, -0.25], [0.25, 0.25], [-0.25, 0.25], [-0.25, -0.25]]";
  return R"({"name": ")" + name + R"(", "type": "Custom", "pose": {"x": )" + std::to_string(x) +
         R"(, "y": )" + std::to_string(y) + R"(}, "body": {"footprint": )" + square +
         R"(, "hull": [{"outline": )" + square + R"(, "bottom": 0.05, "top": )" +
         std::to_string(high) + R"(}], "origin_height": 0.1, "max_speed": 10})" + more +
         R"(, "components": [{"name": "motion", "type": "MotionVW"})" + components + "]}";
}

std::string Scene(const std::string& meshes, const std::string& robots) {
  return R"({"world": {"name": "hills", "size": [40, 40], "low": [-20, -20], "floor": false,
    "terrain": true, "meshes": [)" +
         meshes + R"(]}, "robots": [)" + robots + "]}";
}

class Trial {
 public:
  explicit Trial(const std::string& scene, int threads = 1, bool share_all = false)
      : simulation_(std::make_unique<Simulation>(scene::ParseScenario(scene, "test.json"), threads,
                                                 share_all)) {}

  Robot& robot(const std::string& name = "robot") { return *simulation_->FindRobot(name); }
  Simulation& simulation() { return *simulation_; }
  void Drive(double v, double seconds, const std::string& name = "robot") {
    auto* const motion = simulation_->FindComponent(name + ".motion");
    dynamic_cast<Actuator&>(*motion).Receive(Json(Json::Object{{"v", v}, {"w", 0.0}}));
    Run(seconds);
  }
  void Run(double seconds) {
    const auto ticks = static_cast<int>(std::lround(seconds * 60.0));
    for (int i = 0; i < ticks; ++i) {
      simulation_->Sense();
      simulation_->Act();
    }
    simulation_->Sense();
  }
  double Field(const std::string& component, const std::string& key) {
    return Json::Parse(simulation_->FindComponent("robot." + component)->LocalData())
        .Find(key)
        ->AsDouble();
  }

 private:
  std::unique_ptr<Simulation> simulation_;
};

TEST(Ground, RobotsDriveUpASlopeAndLean) {
  Trial trial(
      Scene(std::string(kPlane) + "," + kRamp, RobotText("robot", 0, 0, 1.0, "",
                                                         R"(, {"name": "pose", "type": "Pose"},
                                 {"name": "gyroscope", "type": "Gyroscope"},
                                 {"name": "velocity", "type": "Velocity"})")));
  EXPECT_EQ(trial.robot().position().z, 0.1);
  trial.Drive(1.0, 4.0);
  EXPECT_NEAR(trial.robot().pose().x, 4.0, 1e-9);
  EXPECT_NEAR(trial.robot().position().z, 1.0 + 0.1, 1e-9);
  EXPECT_NEAR(trial.robot().stand().pitch, -std::atan(0.5), 1e-9);
  EXPECT_NEAR(trial.robot().stand().roll, 0.0, 1e-9);
  EXPECT_NEAR(trial.Field("pose", "z"), 1.1, 1e-9);
  EXPECT_NEAR(trial.Field("pose", "pitch"), -std::atan(0.5), 1e-9);
  EXPECT_NEAR(trial.Field("gyroscope", "pitch"), -std::atan(0.5), 1e-9);
  const Json velocity =
      Json::Parse(trial.simulation().FindComponent("robot.velocity")->LocalData());
  EXPECT_NEAR(velocity.Find("world_linear_velocity")->AsArray()[2].AsDouble(), 0.5, 1e-9);
  trial.Drive(1.0, 4.0);  // onto the top
  EXPECT_NEAR(trial.robot().position().z, 2.1, 1e-9);
  EXPECT_EQ(trial.robot().stand().pitch, 0.0);
  trial.Drive(1.0, 3.0);  // over the edge: down it goes
  EXPECT_NEAR(trial.robot().pose().x, 11.0, 1e-9);
  EXPECT_NEAR(trial.robot().position().z, 0.1, 1e-9);
  EXPECT_EQ(trial.robot().tally().contacts, 0U);
}

TEST(Ground, ARobotAcrossASlopeRolls) {
  Trial trial(
      Scene(std::string(kPlane) + "," + kRamp, RobotText("robot", 4, 0, 1.0, R"(, "z": 1.2)")));
  trial.robot().Orient(1.5707963267948966);  // its left is downhill, towards -x
  EXPECT_NEAR(trial.robot().stand().roll, -std::atan(0.5), 1e-9);
  EXPECT_NEAR(trial.robot().stand().pitch, 0.0, 1e-9);
  // The roll lifts its right: a point to the right, of the world's +x, is higher than its origin.
  const Vec3 right = Rotate(trial.robot().rotation(), {0.0, -1.0, 0.0});
  EXPECT_GT(right.x, 0.0);
  EXPECT_NEAR(right.z / right.x, 0.5, 1e-9);
}

TEST(Ground, AWallStopsARobotAndAStepOfFiveCentimetresDoesNot) {
  Trial wall(Scene(std::string(kPlane) + "," + Sheet(3, 3, 1.0), RobotText("robot", 0, 0)));
  wall.Drive(1.0, 4.0);
  EXPECT_NEAR(wall.robot().pose().x, 2.75, 2e-5);
  EXPECT_EQ(wall.robot().tally().contacts, 1U);
  const std::string step = Sheet(3, 3, 0.05) + "," + Sheet(3, 9, 0.05, R"(, "solid": true)");
  std::string steps = step;
  steps.replace(steps.rfind("\"id\": 3"), 7, "\"id\": 4");
  Trial low(Scene(std::string(kPlane) + "," + steps, RobotText("robot", 0, 0)));
  low.Drive(1.0, 5.0);
  EXPECT_NEAR(low.robot().pose().x, 5.0, 1e-9);
  EXPECT_NEAR(low.robot().position().z, 0.15, 1e-9);
}

TEST(Ground, ATableStopsWhatIsHigherThanItsTop) {
  const std::string table = std::string(kPlane) + "," + Sheet(2, 4, 0.7);
  Trial tall(Scene(table, RobotText("robot", 0, 0, 1.0)));
  tall.Drive(1.0, 4.0);
  EXPECT_NEAR(tall.robot().pose().x, 1.75, 2e-5);
  EXPECT_EQ(tall.robot().position().z, 0.1);
  Trial small(Scene(table, RobotText("robot", 0, 0, 0.6)));
  small.Drive(1.0, 3.0);
  EXPECT_NEAR(small.robot().pose().x, 3.0, 1e-9);
  EXPECT_EQ(small.robot().position().z, 0.1);
}

TEST(Ground, ARobotThatStartsInAWallGetsOutButNoDeeperIn) {
  const std::string scene =
      Scene(std::string(kPlane) + "," + Sheet(0.1, 0.1, 1.0), RobotText("robot", 0, 0));
  Trial in(scene);
  in.Drive(1.0, 0.1);
  EXPECT_EQ(in.robot().pose().x, 0.0);
  EXPECT_TRUE(in.robot().stalled());
  Trial out(scene);
  out.Drive(-1.0, 1.0);
  EXPECT_NEAR(out.robot().pose().x, -1.0, 1e-9);
  out.Drive(1.0, 2.0);
  EXPECT_NEAR(out.robot().pose().x, 0.1 - 0.25, 2e-5) << "outside it is a wall again";
}

TEST(Ground, ARobotComesDownOnTheStoreyBeneathIt) {
  const std::string storeys = std::string(kPlane) + "," + Sheet(-3, 3, 3.0);
  const auto height = [&](const std::string& z) {
    Trial trial(Scene(storeys, RobotText("robot", 0, 0, 1.0, ", \"z\": " + z)));
    return trial.robot().position().z;
  };
  EXPECT_NEAR(height("3.2"), 3.1, 1e-12);
  EXPECT_NEAR(height("2.9"), 0.1, 1e-12);
  EXPECT_NEAR(height("0"), 0.1, 1e-12);
  EXPECT_NEAR(height("-1"), 0.1, 1e-12) << "beneath all ground: the lowest";
}

TEST(Ground, WhatFliesKeepsItsHeight) {
  std::string robot = RobotText("robot", 0, 0, 1.9);
  robot.replace(robot.find("\"bottom\": 0.05"), 14, "\"bottom\": 1.60");
  robot.replace(robot.find("\"origin_height\": 0.1"), 20,
                "\"flies\": true, \"origin_height\": 1.7");
  Trial trial(Scene(std::string(kPlane) + "," + kRamp, robot));
  trial.Drive(1.0, 3.0);
  EXPECT_EQ(trial.robot().position().z, 1.7);
  EXPECT_EQ(trial.robot().stand().pitch, 0.0);
  trial.Drive(1.0, 4.0);  // into the slope, whose height is 1.6 m at x = 5.2
  EXPECT_NEAR(trial.robot().pose().x, 5.2 - 0.25, 2e-5);
}

TEST(Ground, ALaserLeansWithItsRobot) {
  const std::string laser = R"(, {"name": "laser", "type": "LaserScanner", "position": [0, 0, 0.4],
      "laser": {"scan_window_deg": 20, "resolution_deg": 10, "range": 30}})";
  Trial level(Scene(std::string(kPlane) + "," + kRamp, RobotText("robot", 0, 0, 1.0, "", laser)));
  level.Run(0.1);
  const auto ahead = [](Trial& trial) {
    const Json data = Json::Parse(trial.simulation().FindComponent("robot.laser")->LocalData());
    return data.Find("range_list")->AsArray()[1].AsDouble();
  };
  // 0.5 m up the slope is 1 m behind its beginning at x = 2.
  EXPECT_NEAR(ahead(level), 3.0, 1e-9);
  Trial leaning(Scene(std::string(kPlane) + "," + kRamp,
                      RobotText("robot", 4, 0, 1.0, R"(, "z": 1.2)", laser)));
  leaning.Run(0.1);
  EXPECT_NEAR(leaning.robot().position().z, 1.1, 1e-9);
  EXPECT_EQ(ahead(leaning), 30.0) << "along the slope it sees nothing of it";
}

TEST(Ground, EqualRunsWhateverTheThreads) {
  std::string robots;
  for (int i = 0; i < 12; ++i) {
    robots += (i == 0 ? "" : ", ") +
              RobotText("r" + std::to_string(i), -6 + i, 0.7 * (i % 5) - 1.5, 1.0, "",
                        R"(, {"name": "pose", "type": "Pose"}, {"name": "sick",
                            "type": "LaserScanner", "laser": {"preset": "sick"}})");
  }
  const std::string scene =
      Scene(std::string(kPlane) + "," + kRamp + "," + Sheet(12, 12, 1.0), robots);
  const auto hash = [&](int threads) {
    Trial trial(scene, threads, true);
    for (int i = 0; i < 12; ++i) trial.Drive(0.5 + 0.1 * i, 0.1, "r" + std::to_string(i));
    trial.Run(2.0);
    return trial.simulation().Hash();
  };
  const std::uint64_t one = hash(1);
  EXPECT_EQ(hash(2), one);
  EXPECT_EQ(hash(4), one);
}

TEST(Ground, ResetPutsARobotBackOnItsStorey) {
  Trial trial(Scene(std::string(kPlane) + "," + Sheet(-3, 3, 3.0),
                    RobotText("robot", 0, 0, 1.0, ", \"z\": 3.2")));
  trial.Drive(1.0, 4.0);
  EXPECT_NEAR(trial.robot().position().z, 0.1, 1e-12);
  trial.simulation().ResetObjects();
  EXPECT_NEAR(trial.robot().position().z, 3.1, 1e-12);
}

}  // namespace
}  // namespace ccmorse::sim
