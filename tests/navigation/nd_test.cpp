// Nearness diagram navigation (specs: player.md G.3).

#include "navigation/nd.h"

#include <iostream>

#include "base/error.h"
#include "tests/navigation/rig.h"

namespace ccmorse::navigation {
namespace {

NdOptions Options() {
  NdOptions options;
  options.robot_radius = 0.1;
  options.goal_position_tol = 0.1;
  options.avoid_dist = 0.4;
  options.laser_buffer = 1;
  return options;
}

// Hits on a circle of `distance` (m) from one bearing to another (degrees).
void AddArc(std::vector<Vec2>& hits, double from, double to, double distance) {
  for (double degrees = from; degrees <= to; degrees += 0.5) {
    const auto [sine, cosine] = SinCos(Radians(degrees));
    hits.push_back({distance * cosine, distance * sine});
  }
}

TEST(Nd, SituationsAreTold) {
  struct Case {
    NdSituation situation;
    std::vector<std::array<double, 3>> arcs;
    double least, most;  // degrees, of the direction
  };
  const Case cases[] = {
      // Free: straight to the goal.
      {NdSituation::kHighSafetyGoal, {}, -0.1, 0.1},
      // An obstacle on the way, nothing near: round it, by the way that is wide.
      {NdSituation::kHighSafetyWide, {{-10.0, 40.0, 1.5}}, -40.0, -20.0},
      // A wall with a door of 40 degrees to the left: its middle.
      {NdSituation::kHighSafetyNarrow, {{-180.0, 20.0, 1.5}, {60.0, 180.0, 1.5}}, 36.0, 44.0},
      // Near on the left side: to the right of the goal; near on both: ahead.
      {NdSituation::kLowSafety1, {{70.0, 110.0, 0.3}}, -60.0, -5.0},
      {NdSituation::kLowSafety1, {{-110.0, -70.0, 0.3}}, 5.0, 60.0},
      {NdSituation::kLowSafety2, {{70.0, 110.0, 0.3}, {-110.0, -70.0, 0.3}}, -3.0, 3.0},
  };
  for (const Case& c : cases) {
    Nd nd(Options());
    nd.SetGoal({3.0, 0.0, 0.0});
    std::vector<Vec2> hits;
    for (const auto& arc : c.arcs) AddArc(hits, arc[0], arc[1], arc[2]);
    const Drive drive = nd.Step({}, hits);
    EXPECT_EQ(nd.situation(), c.situation);
    EXPECT_GE(Degrees(nd.direction()), c.least);
    EXPECT_LE(Degrees(nd.direction()), c.most);
    EXPECT_FALSE(drive.stalled);
  }
}

TEST(Nd, FreeAheadIsFullSpeedAndASideIsATurn) {
  Nd nd(Options());
  nd.SetGoal({3.0, 0.0, 0.0});
  const Drive ahead = nd.Step({}, {});
  EXPECT_NEAR(ahead.speed, 0.3, 1e-12);
  EXPECT_EQ(ahead.turn_rate, 0.0);
  nd.SetGoal({0.0, 3.0, 0.0});
  const Drive left = nd.Step({}, {});
  EXPECT_EQ(left.speed, 0.0);
  EXPECT_NEAR(left.turn_rate, Radians(45.0), 1e-12);
}

TEST(Nd, TurnsAtTheGoal) {
  Nd nd(Options());
  EXPECT_EQ(nd.Step({}, {}).speed, 0.0);
  nd.SetGoal({0.05, 0.0, 1.0});
  const Drive turning = nd.Step({}, {});
  EXPECT_EQ(turning.speed, 0.0);
  EXPECT_GT(turning.turn_rate, 0.0);
  EXPECT_TRUE(nd.Step({{0.0, 0.0, 0.95}, 0.0, 0.0, false, 0.1}, {}).at_goal);
  EXPECT_THROW(nd.SetGoal({std::nan(""), 0.0, 0.0}), Error);
  NdOptions wrong;
  wrong.avoid_dist = 0.0;
  EXPECT_THROW(Nd{wrong}, Error);
}

TEST(Nd, NoWayOutIsSaid) {
  Nd nd(Options());
  nd.SetGoal({3.0, 0.0, 0.0});
  std::vector<Vec2> hits;
  AddArc(hits, -180.0, 180.0, 1.0);
  const Drive drive = nd.Step({}, hits);
  EXPECT_TRUE(drive.stalled);
  EXPECT_EQ(drive.speed, 0.0);
  EXPECT_FALSE(nd.Step({}, {}).stalled);  // when there is one, it goes on
}

TEST(Nd, StuckWhenItDoesNotGetOn) {
  Nd nd(Options());
  nd.SetGoal({3.0, 0.0, 0.0});
  RobotState state;
  for (state.time = 0.0; state.time <= 2.0; state.time += 0.5) {
    EXPECT_FALSE(nd.Step(state, {}).stalled);
  }
  state.time = 2.1;
  EXPECT_TRUE(nd.Step(state, {}).stalled);  // driving for more than 2 s, and still there
  state.time = 2.2;
  EXPECT_EQ(nd.Step(state, {}).speed, 0.0);  // until the next goal
  nd.SetGoal({3.0, 1.0, 0.0});
  EXPECT_FALSE(nd.Step(state, {}).stalled);
  // Turning without getting on.
  nd.SetGoal({-3.0, 0.1, 0.0});
  EXPECT_FALSE(nd.Step(state, {}).stalled);
  state.time = 4.1;
  EXPECT_FALSE(nd.Step(state, {}).stalled);
  state.time = 4.3;
  EXPECT_TRUE(nd.Step(state, {}).stalled);
  // Getting on is not being stuck.
  Nd moving(Options());
  moving.SetGoal({3.0, 0.0, 0.0});
  RobotState on;
  for (int i = 0; i < 50; ++i) {
    on.time = 0.1 * i;
    on.pose.x = 0.03 * i;
    EXPECT_FALSE(moving.Step(on, {}).stalled);
  }
}

TEST(Nd, WaitsOnAStallWhenToldTo) {
  NdOptions options = Options();
  options.wait_on_stall = true;
  Nd nd(options);
  nd.SetGoal({3.0, 0.0, 0.0});
  RobotState state;
  state.stalled = true;
  EXPECT_TRUE(nd.Step(state, {}).stalled);
  state.stalled = false;
  EXPECT_GT(nd.Step(state, {}).speed, 0.0);
}

TEST(Nd, RemembersTheLastScans) {
  NdOptions options = Options();
  options.laser_buffer = 2;
  Nd nd(options);
  nd.SetGoal({3.0, 0.0, 0.0});
  const std::vector<Vec2> hits = {{1.0, 0.0}};
  nd.Step({}, hits);
  nd.Step({{0.5, 0.0, 0.0}, 0.0, 0.0, false, 0.1}, {});
  EXPECT_NEAR(nd.distances()[Nd::kSectors / 2], 0.5, 1e-12);  // where it was, nearer now
  nd.Step({{0.5, 0.0, 0.0}, 0.0, 0.0, false, 0.2}, {});
  EXPECT_EQ(nd.distances()[Nd::kSectors / 2], Nd::kFree);
}

TEST(Nd, ReachesGoalsAroundSingleObstaclesWithoutContact) {
  int reached = 0;
  int runs = 0;
  for (const double offset : {-0.12, -0.05, 0.0, 0.04, 0.10}) {
    for (const bool back : {false, true}) {
      const double start_x = back ? 2.5 : 0.7;
      Rig rig(Rig::World(R"({"obstacles": {"up": [72]}, "robots": [{"pose": {"x": )" +
                         std::to_string(start_x) + R"(, "y": 2.575, "yaw_deg": )" +
                         (back ? "180" : "0") + "}}]}"));
      Nd nd(NdOptionsForS1r());
      nd.SetGoal({back ? 0.7 : 2.5, 2.575 + offset, 0.0});
      Drive drive;
      while (!drive.at_goal && rig.time() < 60.0) {
        drive = rig.Step([&] {
          const sim::Twist& twist = rig.robot().twist();
          const std::vector<Vec2> hits = HitPoints(rig.scan());
          return nd.Step({rig.pose(), twist.v, twist.w, rig.robot().stalled(), rig.time()}, hits);
        });
      }
      ++runs;
      reached += drive.at_goal ? 1 : 0;
      EXPECT_EQ(rig.contacts(), 0U) << offset << " " << back;
      EXPECT_TRUE(drive.at_goal) << offset << " " << back << " at " << rig.pose().x << " "
                                 << rig.pose().y << " " << rig.pose().yaw << " v " << drive.speed
                                 << " w " << drive.turn_rate << " stalled " << drive.stalled;
    }
  }
  std::cout << "ND: " << reached << " of " << runs << " goals\n";
}

}  // namespace
}  // namespace ccmorse::navigation
