#include "sim/actuators/waypoint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "scene/scenario.h"
#include "sim/simulation.h"

namespace ccmorse::sim {
namespace {

class WaypointTest : public ::testing::Test {
 protected:
  const Service& Find(const std::string& name) {
    for (const Service& service : simulation_.FindComponent("s1r.waypoint")->services()) {
      if (service.name == name) return service;
    }
    throw std::runtime_error("no service " + name);
  }
  void Advance(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 60); ++i) {
      simulation_.Sense();
      simulation_.Act();
    }
  }
  std::string Status() { return Find("get_status").run({}).AsString(); }

  Simulation simulation_{
      scene::ParseScenario(R"({"robots": [{"pose": {"x": 1.0, "y": 2.0}}]})", "test.json")};
};

TEST_F(WaypointTest, GotoArrivesWithinTheToleranceAndSaysSo) {
  std::optional<ServiceResult> result;
  Find("goto").start(Json::Array{1.5, 2.5, 0, 0.05, 0.4},
                     [&result](const ServiceResult& r) { result = r; });
  EXPECT_EQ(Status(), "Transit");
  Advance(30.0);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->outcome, Outcome::kSuccess);
  EXPECT_EQ(result->value, Json("Arrived"));
  const Pose2 pose = simulation_.robots()[0]->pose();
  EXPECT_LE(std::hypot(pose.x - 1.5, pose.y - 2.5), 0.05);
  EXPECT_EQ(Status(), "Arrived");
}

TEST_F(WaypointTest, ANewGotoPreemptsTheOldOne) {
  std::optional<ServiceResult> first;
  Find("goto").start(Json::Array{1.5, 2.5, 0}, [&first](const ServiceResult& r) { first = r; });
  Find("goto").start(Json::Array{1.2, 2.0, 0}, [](const ServiceResult&) {});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->outcome, Outcome::kPreempted);
}

TEST_F(WaypointTest, StopKeepsTheGoalAndResumeGoesOn) {
  std::optional<ServiceResult> result;
  Find("goto").start(Json::Array{2.0, 2.0, 0, 0.05, 0.4},
                     [&result](const ServiceResult& r) { result = r; });
  Advance(0.5);
  Find("stop").run({});
  const double x = simulation_.robots()[0]->pose().x;
  Advance(1.0);
  EXPECT_EQ(simulation_.robots()[0]->pose().x, x);
  EXPECT_FALSE(result);
  Find("resume").run({});
  Advance(10.0);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->outcome, Outcome::kSuccess);
}

TEST_F(WaypointTest, TheLastCommandedActuatorHasTheRobot) {
  Find("setdest").run(Json::Array{2.0, 2.0, 0, 0.05, 0.4});
  Advance(0.2);
  auto* motion = dynamic_cast<Actuator*>(simulation_.FindComponent("s1r.motion"));
  motion->Receive(Json::Parse(R"({"v": 0, "w": 0})"));
  const double x = simulation_.robots()[0]->pose().x;
  Advance(1.0);
  EXPECT_EQ(simulation_.robots()[0]->pose().x, x);
}

TEST_F(WaypointTest, NegativeOrEndlessNumbersAreRefused) {
  EXPECT_THROW(Find("setdest").run(Json::Array{0, 0, 0, -1.0}), WrongArgument);
  EXPECT_THROW(Find("setdest").run(Json::Array{0, std::nan(""), 0}), WrongArgument);
}

}  // namespace
}  // namespace ccmorse::sim
