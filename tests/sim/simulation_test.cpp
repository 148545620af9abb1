#include "sim/simulation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "scene/scenario.h"

namespace ccmorse::sim {
namespace {

scene::Scenario ParseText(const std::string& text) {
  return scene::ParseScenario(text, "test.json");
}

// Drives every robot about by a fixed programme and returns the final hash.
std::uint64_t Drive(const std::string& scenario, int ticks) {
  Simulation simulation(ParseText(scenario));
  for (int i = 0; i < ticks; ++i) {
    simulation.Sense();
    for (const auto& robot : simulation.robots()) {
      auto* motion = dynamic_cast<Actuator*>(simulation.FindComponent(robot->name() + ".motion"));
      motion->Receive(Json(Json::Object{{"v", 0.3}, {"w", std::remainder(0.01 * i, 2.0)}}));
    }
    simulation.Act();
  }
  return simulation.Hash();
}

constexpr std::uint64_t kGoldenHash = 0xfe8affa7da7668a8ULL;

constexpr const char* kA = R"({"name": "a", "pose": {"x": 1.0, "y": 2.4}})";
constexpr const char* kB = R"({"name": "b", "pose": {"x": 2.0, "y": 2.4, "yaw_deg": 90}})";

std::string Robots(const std::string& first, const std::string& second) {
  return "{\"robots\": [" + first + ", " + second + "]}";
}

TEST(Determinism, TheSameRunGivesTheSameHash) {
  EXPECT_EQ(Drive("{}", 600), Drive("{}", 600));
  EXPECT_NE(Drive("{}", 600), Drive("{}", 601));
}

TEST(Determinism, TheOrderInWhichRobotsAreDeclaredHasNoEffect) {
  EXPECT_EQ(Drive(Robots(kA, kB), 900), Drive(Robots(kB, kA), 900));
}

TEST(Determinism, ASmallDifferenceChangesTheHash) {
  EXPECT_NE(Drive(R"({"robots": [{"pose": {"x": 1.0, "y": 2.0}}]})", 10),
            Drive(R"({"robots": [{"pose": {"x": 1.0000000000000002, "y": 2.0}}]})", 10));
}

TEST(Determinism, TheHashOfThisRunIsTheSameInEveryBuild) {
  // One golden number for Release, Debug and sanitizer builds; a change of it belongs in CHANGELOG.
  EXPECT_EQ(Drive(Robots(kA, kB), 600), kGoldenHash);
}

TEST(Time, IsDerivedFromTheTickAndNotAddedUp) {
  Simulation simulation(ParseText(R"({"time": {"frequency": 100}})"));
  for (int i = 0; i < 1000; ++i) {
    simulation.Sense();
    simulation.Act();
  }
  EXPECT_EQ(simulation.time(), 10.0);
}

TEST(Sensors, SampleAtTheirOwnRate) {
  Simulation simulation(
      ParseText(R"({"time": {"frequency": 50}, "robots": [{"laser": {"frequency": 7}}]})"));
  for (int i = 0; i < 500; ++i) {
    simulation.Sense();
    simulation.Act();
  }
  const auto samples = [&simulation](const char* name) {
    return dynamic_cast<Sensor*>(simulation.FindComponent(name))->samples();
  };
  EXPECT_EQ(samples("s1r.hokuyo"), 70U);
  EXPECT_EQ(samples("s1r.pose"), 500U);  // 60 Hz wanted, one a tick at most
}

TEST(Sensors, ADeactivatedOneSaysNothingNew) {
  Simulation simulation(ParseText("{}"));
  auto* pose = dynamic_cast<Sensor*>(simulation.FindComponent("s1r.pose"));
  pose->set_active(false);
  simulation.Sense();
  EXPECT_EQ(pose->samples(), 0U);
}

TEST(World, DynamicBoxesRiseAndStaticOnesStay) {
  Simulation simulation(ParseText("{}"));
  const std::size_t before = simulation.world().obstacles().size();
  simulation.world().SetRaised(69, true);
  EXPECT_EQ(simulation.world().obstacles().size(), before + 1);
  simulation.world().SetRaised(69, false);
  EXPECT_EQ(simulation.world().obstacles().size(), before);
  EXPECT_THROW(simulation.world().SetRaised(26, false), Error);
  EXPECT_THROW(simulation.world().SetRaised(1000, true), Error);
}

TEST(World, ResetPutsRobotsBack) {
  Simulation simulation(ParseText("{}"));
  const Pose2 start = simulation.robots()[0]->pose();
  dynamic_cast<Actuator*>(simulation.FindComponent("s1r.motion"))
      ->Receive(Json::Parse(R"({"v": 0.2, "w": 0.3})"));
  for (int i = 0; i < 60; ++i) {
    simulation.Sense();
    simulation.Act();
  }
  simulation.ResetObjects();
  EXPECT_EQ(simulation.robots()[0]->pose().x, start.x);
  EXPECT_EQ(simulation.robots()[0]->tally().distance, 0.0);
  simulation.Sense();
  simulation.Act();
  EXPECT_EQ(simulation.robots()[0]->pose().x, start.x);
}

}  // namespace
}  // namespace ccmorse::sim
