// The arena controller: thesis 5.1, checklist N01 to N04.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/trig.h"
#include "scene/scenario.h"
#include "sim/arena_controller.h"
#include "sim/sensors/laser_scanner.h"
#include "sim/simulation.h"

namespace ccmorse::sim {
namespace {

// A hall of 4 x 4 m; box 1 is a dynamic slab before the robot, box 2 another far away.
std::string Hall(const std::string& obstacles) {
  return R"({"world": {"name": "hall", "size": [4, 4], "boxes": [
    {"id": 1, "kind": "slab", "x": 2.0, "y": 2.0, "yaw": 0, "size": [0.1, 0.6],
     "height": 0.3, "color": "#808080", "dynamic": true, "raised": false},
    {"id": 2, "kind": "slab", "x": 3.5, "y": 3.5, "yaw": 0, "size": [0.1, 0.6],
     "height": 0.3, "color": "#808080", "dynamic": true, "raised": false},
    {"id": 3, "kind": "wall", "x": 0.05, "y": 2.0, "yaw": 0, "size": [0.1, 3],
     "height": 0.3, "color": "#808080"}]},
    "robots": [{"pose": {"x": 1.0, "y": 2.0, "yaw": 0}}], "obstacles": )" +
         obstacles + "}";
}

class ArenaTest : public ::testing::Test {
 protected:
  void Start(const std::string& obstacles) {
    simulation_.emplace(scene::ParseScenario(Hall(obstacles), "hall.json"));
  }
  void Run(double seconds, double v = 0.0) {
    auto* const motion = dynamic_cast<Actuator*>(simulation_->FindComponent("s1r.motion"));
    const double end = simulation_->time() + seconds - 1e-6;
    while (simulation_->time() < end) {
      simulation_->Sense();
      motion->Receive(Json(Json::Object{{"v", v}, {"w", 0.0}}));
      simulation_->Act();
    }
  }
  bool Raised(int id) const { return simulation_->world().FindBox(id)->raised; }
  double x() const { return simulation_->robots()[0]->pose().x; }
  // What the scanner sees straight ahead, m.
  double Ahead() {
    simulation_->Sense();
    const auto& laser =
        dynamic_cast<const LaserScanner&>(*simulation_->FindComponent("s1r.hokuyo"));
    return laser.ranges()[laser.ranges().size() / 2];
  }
  ArenaController& arena() { return simulation_->arena(); }

  std::optional<Simulation> simulation_;
};

class N01 : public ArenaTest {};
class N02 : public ArenaTest {};
class N03 : public ArenaTest {};
class N04 : public ArenaTest {};
class ArenaPath : public ArenaTest {};

TEST_F(N01, ARaisedObstacleIsSeenAndRunInto) {
  Start("{}");
  Run(0.2);
  const double free = Ahead();
  arena().Apply({"", {1}, {}, {}, ""}, simulation_->time(), "test");
  Run(0.2);
  EXPECT_LT(Ahead(), 1.0);
  EXPECT_GT(free, 2.0);
  Run(6.0, 0.5);
  EXPECT_LT(x(), 1.95);
  arena().Apply({"", {}, {1}, {}, ""}, simulation_->time(), "test");
  Run(3.0, 0.5);
  EXPECT_GT(x(), 2.1);
}

TEST_F(N01, AnObstacleWaitsForTheRobotOnIt) {
  Start("{}");
  Run(2.0, 0.5);  // onto its place
  ASSERT_NEAR(x(), 2.0, 0.05);
  arena().Apply({"", {1, 2}, {}, {}, ""}, simulation_->time(), "test");
  EXPECT_EQ(arena().waiting(), std::vector<int>{1});
  EXPECT_TRUE(Raised(2));
  Run(1.0);
  EXPECT_FALSE(Raised(1));
  Run(1.0, 0.5);
  EXPECT_TRUE(Raised(1));
  EXPECT_TRUE(arena().waiting().empty());
}

TEST_F(N01, WhatWaitsCanBeCalledOff) {
  Start("{}");
  Run(2.0, 0.5);
  arena().Apply({"", {1}, {}, {}, ""}, simulation_->time(), "test");
  arena().Apply({"", {}, {}, {1}, ""}, simulation_->time(), "test");
  Run(1.0, 0.5);
  EXPECT_FALSE(Raised(1));
}

TEST_F(N01, WhatIsNoDynamicObstacleIsRefusedAndNothingHappens) {
  Start("{}");
  EXPECT_THROW(arena().Apply({"", {1, 3}, {}, {}, ""}, 0.0, "test"), Error);
  EXPECT_THROW(arena().Apply({"", {1}, {99}, {}, ""}, 0.0, "test"), Error);
  EXPECT_FALSE(Raised(1));
  EXPECT_EQ(arena().hash(), 0U);
}

TEST_F(N01, AnObstacleCanBePutElsewhereButNotOntoARobot) {
  Start(R"({"up": [1]})");
  EXPECT_THROW(arena().Move(1, {1.0, 2.0, 0.0}, 0.0), Error);
  arena().Move(1, {1.6, 2.0, kPi / 2.0}, 0.0);
  Run(0.2);
  EXPECT_NEAR(Ahead(), 1.6 - 0.3 - 1.0 - 0.035, 0.02);  // the slab's end, from the scanner
  EXPECT_THROW(arena().Move(3, {2.0, 2.0, 0.0}, 0.0), Error);
}

TEST_F(N01, ResetPutsObstaclesBack) {
  Start(R"({"up": [2]})");
  Run(0.5);
  arena().Apply({"", {1}, {2}, {}, ""}, 0.0, "test");
  arena().Move(2, {3.0, 1.0, 0.5}, 0.0);
  simulation_->ResetObjects();
  EXPECT_FALSE(Raised(1));
  EXPECT_TRUE(Raised(2));
  EXPECT_EQ(simulation_->world().FindBox(2)->pose.x, 3.5);
}

TEST_F(N02, APresetIsUpAndAllOthersAreDown) {
  Start(R"({"presets": {"near": [1], "far": [2], "none": []}, "preset": "far"})");
  EXPECT_FALSE(Raised(1));
  EXPECT_TRUE(Raised(2));
  arena().Apply({"near", {}, {}, {}, ""}, 0.0, "test");
  EXPECT_TRUE(Raised(1));
  EXPECT_FALSE(Raised(2));
  EXPECT_THROW(arena().Apply({"neer", {}, {}, {}, ""}, 0.0, "test"), Error);
}

TEST_F(N02, WhatIsUpCanBeSaved) {
  Start("{}");
  arena().Apply({"", {2}, {}, {}, ""}, 0.0, "test");
  arena().SavePreset("mine");
  EXPECT_EQ(arena().presets().at("mine"), std::vector<int>{2});
  arena().Apply({"", {1}, {2}, {}, ""}, 0.0, "test");
  arena().Apply({"mine", {}, {}, {}, ""}, 0.0, "test");
  EXPECT_FALSE(Raised(1));
  EXPECT_TRUE(Raised(2));
}

TEST_F(N03, ATimerRingsInSimulatedTime) {
  Start(R"({"timers": [{"at": 1.0, "up": [1], "say": "now"}]})");
  Run(1.0);
  EXPECT_FALSE(Raised(1));
  Run(0.05);
  EXPECT_TRUE(Raised(1));
  ASSERT_EQ(arena().events().size(), 2U);
  EXPECT_NEAR(arena().events()[0].time, 1.0, 1e-9);
  EXPECT_EQ(arena().events()[1].what, "say now");
}

TEST_F(N03, ATimerMayRingAgainAndAgain) {
  Start(R"({"timers": [{"at": 1, "every": 0.5, "toggle": [1]}]})");
  Run(3.26);  // at 1, 1.5, 2, 2.5, 3
  EXPECT_EQ(arena().event_count(), 5U);
  EXPECT_TRUE(Raised(1));
}

TEST_F(N03, ATimerThatComesLateRingsOnceAndKeepsItsRhythm) {
  Start("{}");
  Run(2.6);
  arena().Add(scene::ObstacleTimer{1.0, 0.5, {"", {}, {}, {2}, ""}});
  Run(0.3);
  EXPECT_EQ(arena().event_count(), 1U);
  Run(0.3);  // at 3
  EXPECT_EQ(arena().event_count(), 2U);
}

TEST_F(N04, ATrapSpringsWhenARobotComesIn) {
  Start(R"({"traps": [{"name": "gate", "region": [1.5, 1.5, 2.5, 2.5], "up": [2]}]})");
  Run(0.9, 0.5);
  EXPECT_FALSE(Raised(2));
  Run(0.3, 0.5);
  EXPECT_TRUE(Raised(2));
  EXPECT_EQ(arena().events()[0].cause, "trap gate by s1r");
  EXPECT_NEAR(arena().events()[0].time, 1.0, 0.05);  // 0.5 m at 0.5 m/s
  Run(0.5, 0.5);
  EXPECT_EQ(arena().event_count(), 1U);  // it is still in there
}

TEST_F(N04, ATrapMaySpringOnceOrEachTimeOrForOneRobotOnly) {
  Start(R"({"traps": [
    {"name": "once", "region": [1.2, 1, 1.4, 3], "once": true, "say": "once"},
    {"name": "each", "region": [[1.2, 1], [1.4, 1], [1.4, 3], [1.2, 3]], "say": "each"},
    {"name": "other", "region": [1.2, 1, 1.4, 3], "robot": "other", "say": "other"}]})");
  Run(1.2, 0.5);
  Run(1.2, -0.5);
  std::vector<std::string> said;
  for (const auto& event : arena().events()) said.push_back(event.what);
  EXPECT_EQ(said, (std::vector<std::string>{"say once", "say each", "say each"}));
}

TEST_F(ArenaPath, ABoxGoesFromPointToPoint) {
  Start(R"({"up": [2], "paths": [{"box": 2, "points": [
    {"at": 1, "x": 3.5, "y": 3.5}, {"at": 2, "x": 3.5, "y": 2.5, "yaw_deg": 90}]}]})");
  Run(1.0);
  EXPECT_EQ(simulation_->world().FindBox(2)->pose.y, 3.5);
  Run(0.5);
  EXPECT_NEAR(simulation_->world().FindBox(2)->pose.y, 3.0, 1e-9);
  EXPECT_NEAR(simulation_->world().FindBox(2)->pose.yaw, kPi / 4.0, 1e-9);
  Run(2.0);
  EXPECT_NEAR(simulation_->world().FindBox(2)->pose.y, 2.5, 1e-9);
}

TEST_F(ArenaPath, ItWaitsForARobotAndGoesOnAfterIt) {
  Start(R"({"up": [1], "paths": [{"box": 1, "points": [
    {"at": 0, "x": 2, "y": 2}, {"at": 2, "x": 0.5, "y": 2}]}]})");
  Run(3.0);
  // It stands before the robot, which it has not touched.
  EXPECT_EQ(x(), 1.0);
  const double stuck = simulation_->world().FindBox(1)->pose.x;
  EXPECT_GT(stuck, 1.08);
  EXPECT_LT(stuck, 1.25);
  const std::vector<const Obstacle*> others = {&simulation_->world().obstacles()[0]};
  EXPECT_FALSE(
      Collides(simulation_->robots()[0]->footprint(), simulation_->robots()[0]->pose(), others));
  simulation_->robots()[0]->Place({1.0, 3.0, 0.0});
  Run(3.0);
  EXPECT_NEAR(simulation_->world().FindBox(1)->pose.x, 0.5, 1e-9);
}

TEST_F(ArenaPath, ARunWithObstaclesHasAHashOfItsOwnAndTheSameAgain) {
  const auto hash = [this](const std::string& obstacles) {
    Start(obstacles);
    Run(3.0, 0.2);
    return simulation_->Hash();
  };
  const std::string far = R"({"timers": [{"at": 1, "every": 0.3, "toggle": [2]}]})";
  EXPECT_EQ(hash(far), hash(far));
  EXPECT_NE(hash(far), hash("{}"));
}

TEST(ObstacleRules, AreReadWrittenAndReadAgain) {
  const std::string text = Hall(R"({"up": [1], "presets": {"a b": [1, 2]},
    "timers": [{"at": 3, "every": 2, "preset": "a b", "toggle": [1]}],
    "traps": [{"name": "t", "region": [0, 0, 1, 1], "robot": "s1r", "once": true, "down": [2]}],
    "paths": [{"box": 2, "repeat": true, "points": [{"at": 0, "x": 1, "y": 1},
                                                    {"at": 4, "x": 2, "y": 1, "yaw": 1}]}]})");
  const Json once = scene::ToJson(scene::ParseScenario(text, "hall.json"));
  const Json twice = scene::ToJson(scene::ParseScenario(once.Dump(), "hall.json"));
  EXPECT_EQ(once.Dump(), twice.Dump());
  EXPECT_EQ(once.Find("obstacles")->Find("timers")->AsArray().size(), 1U);
  EXPECT_EQ(once.Find("obstacles")->Find("paths")->AsArray().size(), 1U);
}

TEST(ObstacleRules, WhatIsWrongIsNamedWithItsPlace) {
  const auto complaint = [](const std::string& obstacles) -> std::string {
    try {
      scene::ParseScenario(Hall(obstacles), "hall.json");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const auto expect = [&](const std::string& obstacles, const std::string& part) {
    EXPECT_NE(complaint(obstacles).find(part), std::string::npos) << complaint(obstacles);
  };
  expect(R"({"timers": [{"at": 1, "up": [3]}]})", "obstacles.timers[0].up[0] is 3, a box of kind");
  expect(R"({"timers": [{"at": 1}]})", "does nothing");
  expect(R"({"timers": [{"at": 1, "preset": "x"}]})", "is 'x', which is no preset");
  expect(R"({"presets": {"far": [2]}, "preset": "fat"})", "did you mean 'far'");
  expect(R"({"timers": [{"at": 1, "up": [1], "toggle": [1]}]})", "says 1 twice");
  expect(R"({"traps": [{"name": "t", "region": [1, 0, 0, 1], "up": [1]}]})", "low before high");
  expect(R"({"traps": [{"name": "t", "region": [[0, 0], [1, 1]], "up": [1]}]})", "corners");
  expect(R"({"paths": [{"box": 1, "points": [{"at": 1, "x": 0, "y": 0}]}]})", "two points");
  expect(R"({"paths": [{"box": 1, "points": [{"at": 1, "x": 0, "y": 0},
                                             {"at": 1, "x": 1, "y": 0}]}]})",
         "later than");
}

}  // namespace
}  // namespace ccmorse::sim
