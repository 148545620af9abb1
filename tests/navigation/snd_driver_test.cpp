// SndDriver (thesis 3.1.3) against the simulator.

#include <gtest/gtest.h>

#include <iostream>
#include <thread>

#include "libCCMorse/CCMorse.h"
#include "tests/navigation/rig.h"
#include "tests/servers/served_simulation.h"

namespace ccmorse::navigation {
namespace {

using CCMorse::MorseError;
using CCMorse::PlayerClient;
using CCMorse::Position2dProxy;
using CCMorse::SndDriver;
using servers::Pace;
using servers::ServedSimulation;

constexpr char kHost[] = "127.0.0.1";

std::string WithSettings(const std::string& settings) {
  return R"({"robots": [{"name": "s1r", "pose": {"x": 1.2, "y": 2.0, "yaw_deg": 0},
             "drivers": {"snd": )" +
         settings + "}}]}";
}

TEST(L307, TwentyRandomGoalsInTheArenaWithoutContact) {
  constexpr std::uint64_t kSeed = 307;
  constexpr int kGoals = 20;
  // The pillars of the course's map stand.
  ServedSimulation served(
      R"({"obstacles": {"up": [5, 10, 19, 22, 23, 61, 69, 70, 71, 72, 73, 74, 75, 76]}})",
      Pace::kLockstep);
  const Pose2 start = served.simulation().scenario().robots[0].pose;
  const OccupancyGrid free = MapOf(served.simulation().scenario().world, 0.01).Inflated(0.153);
  const std::vector<bool> reachable = ReachableFrom(free, {start.x, start.y});
  int reached = 0;
  {
    PlayerClient client(kHost, served.port());
    SndDriver driver(&client);
    Position2dProxy position(&client, 0);
    driver.Start();
    std::mt19937_64 random(kSeed);
    for (int i = 0; i < kGoals;) {
      const Pose2 goal{Draw(random, 0.34, 2.90), Draw(random, 1.62, 3.18), Draw(random, -kPi, kPi)};
      if (!reachable[free.IndexOf(free.CellOf({goal.x, goal.y}))]) continue;
      ++i;
      driver.GoTo(goal.x, goal.y, goal.yaw);
      if (!driver.WaitForArrival(60.0)) continue;
      ++reached;
      const CCMorse::player_pose2d_t pose = position.GetPose();
      const Vec2 off{goal.x - pose.px, goal.y - pose.py};
      EXPECT_LT(Dot(off, off), 0.06 * 0.06);
      EXPECT_LT(std::abs(NormalizeAngle(goal.yaw - pose.pa)), Radians(35.0));
    }
    driver.Stop();
    driver.Join();
    client.GetMorseClient().Request("simulation", "quit");
  }
  served.Join();
  const sim::RobotTally& tally = served.simulation().robots()[0]->tally();
  std::cout << "seed " << kSeed << ": " << reached << " of " << kGoals << " goals, "
            << tally.contacts << " contacts, " << tally.distance << " m\n";
  EXPECT_GE(reached, 19);
  EXPECT_EQ(tally.contacts, 0U);
}

TEST(L307, StopsWhenTheGoalIsGivenUpAndWhenTheDriverEnds) {
  ServedSimulation served(WithSettings("{}"), Pace::kLockstep);
  PlayerClient client(kHost, served.port());
  Position2dProxy position(&client, 0);
  {
    SndDriver driver(&client);
    EXPECT_FALSE(driver.HasGoal());
    EXPECT_FALSE(driver.WaitForArrival(1.0));  // it does not run: no waiting
    driver.GoTo({2.4, 2.0, 0.0});
    EXPECT_TRUE(driver.HasGoal());
    driver.Start();
    EXPECT_FALSE(driver.WaitForArrival(1.0));
    EXPECT_TRUE(driver.IsRunning());
    driver.Cancel();
    EXPECT_FALSE(driver.HasGoal());
    EXPECT_FALSE(driver.WaitForArrival(1.0));
    EXPECT_EQ(position.GetXSpeed(), 0.0);
    const double x = position.GetXPos();
    EXPECT_GT(x, 1.25);
    driver.GoTo(2.4, 2.0, 0.0);
    EXPECT_FALSE(driver.WaitForArrival(0.5));
    EXPECT_GT(position.GetXPos(), x);
    EXPECT_THROW(driver.GoTo(std::nan(""), 0.0, 0.0), MorseError);
  }
  client.Read();
  const double x = position.GetXPos();
  client.Read();
  EXPECT_EQ(position.GetXPos(), x);
}

TEST(L307, EndOfTheSimulationEndsTheWaitAndComesOutOfJoin) {
  ServedSimulation served(WithSettings("{}"), Pace::kLockstep, 2.0);
  PlayerClient client(kHost, served.port());
  SndDriver driver(&client);
  driver.Start();
  driver.GoTo(2.4, 2.0, 0.0);
  EXPECT_FALSE(driver.WaitForArrival(1000.0));
  try {
    driver.Join();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const MorseError& error) {
    EXPECT_TRUE(error.SimulationEnded());
  }
}

TEST(C06, SettingsOfSndComeFromTheRobotsConfiguration) {
  ServedSimulation served(WithSettings(R"({"robot_radius": 0.1, "min_gap_width": 0.3,
      "obstacle_avoid_dist": 0.2, "max_speed": 0.15, "max_turn_rate": 45,
      "goal_position_tol": 0.02, "goal_angle_tol": 5})"),
                          Pace::kLockstep);
  PlayerClient client(kHost, served.port());
  SndDriver driver(&client);
  EXPECT_DOUBLE_EQ(driver.GetRobotRadius(), 0.1);
  EXPECT_DOUBLE_EQ(driver.GetMinGapWidth(), 0.3);
  EXPECT_DOUBLE_EQ(driver.GetObstacleAvoidDist(), 0.2);
  EXPECT_DOUBLE_EQ(driver.GetMaxSpeed(), 0.15);
  EXPECT_DOUBLE_EQ(driver.GetMaxTurnRate(), kPi / 4.0);
  EXPECT_DOUBLE_EQ(driver.GetGoalPositionTol(), 0.02);
  EXPECT_DOUBLE_EQ(driver.GetGoalAngleTol(), kPi / 36.0);
  // And they are what it drives by.
  Position2dProxy position(&client, 0);
  driver.Start();
  driver.GoTo(2.4, 2.0, 0.0);
  double fastest = 0.0;
  while (!driver.WaitForArrival(0.1) && driver.IsRunning()) {
    fastest = std::max(fastest, position.GetXSpeed());
  }
  EXPECT_TRUE(driver.IsArrived());
  EXPECT_NEAR(fastest, 0.15, 1e-9);
  EXPECT_NEAR(position.GetXPos(), 2.4, 0.02);
  EXPECT_LE(std::abs(position.GetYaw()), kPi / 36.0);
}

TEST(C06, UnknownOrWrongSettingsOfSndAreNamed) {
  const auto message = [](const std::string& settings) {
    ServedSimulation served(WithSettings(settings));
    PlayerClient client(kHost, served.port());
    try {
      const SndDriver driver(&client);
    } catch (const MorseError& error) {
      return error.GetErrorStr();
    }
    return std::string();
  };
  EXPECT_EQ(message("{}"), "");
  EXPECT_NE(message(R"({"max_sped": 1})").find("did you mean 'max_speed'"), std::string::npos);
  EXPECT_NE(message(R"({"max_speed": "fast"})").find("max_speed must be a number"),
            std::string::npos);
  EXPECT_NE(message(R"({"robot_radius": -1})").find("robot_radius must be"), std::string::npos);
}

}  // namespace
}  // namespace ccmorse::navigation
