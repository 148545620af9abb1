// Vector field histogram plus (specs: player.md G.2).

#include "navigation/vfh.h"

#include <iostream>

#include "base/error.h"
#include "tests/navigation/rig.h"

namespace ccmorse::navigation {
namespace {

VfhOptions VfhDefaults() {
  VfhOptions options;
  options.robot_radius = 0.1;
  options.cell_size = 0.1;
  options.safety_dist_0ms = 0.0;
  options.free_space_cutoff_0ms = 1e5;
  return options;
}

TEST(Vfh, AnOccupiedCellWeighsByItsDistance) {
  Vfh vfh(VfhDefaults());
  vfh.SetGoal({5.0, 0.0, 0.0});
  const std::vector<Vec2> hits = {{1.0, 0.0}, {1.01, 0.01}};  // one cell
  vfh.Step({}, hits);
  ASSERT_EQ(vfh.histogram().size(), 72U);
  // (3000 - 1000)^4 / 1e8; asin(0.1 / 1) = 5.74 degrees either side: one sector of 5.
  EXPECT_NEAR(vfh.histogram()[0], 1.6e5, 1e-6);
  EXPECT_NEAR(vfh.histogram()[1], 1.6e5, 1e-6);
  EXPECT_NEAR(vfh.histogram()[71], 1.6e5, 1e-6);
  EXPECT_EQ(vfh.histogram()[2], 0.0);
  EXPECT_TRUE(vfh.blocked()[0]);
  EXPECT_FALSE(vfh.blocked()[2]);
}

TEST(Vfh, CutoffsHaveHysteresis) {
  VfhOptions options = VfhDefaults();
  options.free_space_cutoff_0ms = 1e5;
  options.obs_cutoff_0ms = 3e5;
  Vfh vfh(options);
  vfh.SetGoal({5.0, 0.0, 0.0});
  const std::vector<Vec2> one = {{1.0, 0.0}};   // 1.6e5: between
  const std::vector<Vec2> near = {{0.5, 0.0}};  // 3.9e5
  vfh.Step({}, one);
  EXPECT_FALSE(vfh.blocked()[0]);
  vfh.Step({}, near);
  EXPECT_TRUE(vfh.blocked()[0]);
  vfh.Step({}, one);
  EXPECT_TRUE(vfh.blocked()[0]);
  vfh.Step({}, {});
  EXPECT_FALSE(vfh.blocked()[0]);
}

TEST(Vfh, TurningCirclesMaskWhatCannotBeTurnedTo) {
  VfhOptions options = VfhDefaults();
  options.max_turnrate_0ms = 1.0;
  Vfh vfh(options);
  vfh.SetGoal({5.0, 0.0, 0.0});
  // At 0.5 m/s the circle has 0.5 m; what is at (0.3, 0.3) is 0.36 m from its centre (0, 0.5).
  const std::vector<Vec2> hits = {{0.3, 0.3}};
  RobotState moving;
  moving.speed = 0.5;
  vfh.Step(moving, hits);
  EXPECT_TRUE(vfh.masked()[36]);   // behind
  EXPECT_TRUE(vfh.masked()[18]);   // to the left
  EXPECT_FALSE(vfh.masked()[54]);  // to the right
  EXPECT_FALSE(vfh.masked()[0]);
  vfh.Step({}, hits);  // standing, it can turn anywhere
  EXPECT_FALSE(vfh.masked()[18]);
}

TEST(Vfh, CandidatesAreMiddlesOfNarrowAndEdgesOfWideOpenings) {
  // Cells all around but for 25..65 degrees and 100..260.
  std::vector<Vec2> hits;
  for (int i = 0; i < 720; ++i) {
    const double degrees = 0.5 * i;
    if ((degrees > 25.0 && degrees < 65.0) || (degrees > 100.0 && degrees < 260.0)) continue;
    const auto [sine, cosine] = SinCos(Radians(degrees));
    hits.push_back({2.0 * cosine, 2.0 * sine});
  }
  VfhOptions options = VfhDefaults();
  options.free_space_cutoff_0ms = 1.0;
  Vfh sharp(options);
  sharp.SetGoal({-5.0, 0.5, 0.0});
  sharp.Step({}, hits);
  ASSERT_EQ(sharp.candidates().size(), 4U);
  int narrow = 0;
  for (const Vfh::Candidate& candidate : sharp.candidates()) {
    if (!candidate.narrow) continue;
    ++narrow;
    EXPECT_NEAR(Degrees(candidate.angle), 45.0, 5.0);
  }
  EXPECT_EQ(narrow, 1);
  EXPECT_NEAR(sharp.candidates().back().angle, Atan2(0.5, -5.0), 1e-12);
}

TEST(Vfh, TurnsAtTheGoalAndEscapesWhenStalled) {
  VfhOptions options = VfhDefaults();
  options.escape_speed = -0.1;
  options.escape_time = 1.0;
  options.escape_max_turnrate = 0.5;
  Vfh vfh(options);
  EXPECT_EQ(vfh.Step({}, {}).speed, 0.0);  // no goal
  vfh.SetGoal({0.4, 0.0, 1.0});
  const Drive turning = vfh.Step({}, {});
  EXPECT_EQ(turning.speed, 0.0);
  EXPECT_GT(turning.turn_rate, Radians(10.0));
  EXPECT_TRUE(vfh.Step({{0.0, 0.0, 0.9}, 0.0, 0.0, false, 0.1}, {}).at_goal);
  vfh.SetGoal({5.0, 0.0, 0.0});
  EXPECT_EQ(vfh.Step({{}, 0.0, 0.0, true, 1.0}, {}).speed, -0.1);
  EXPECT_EQ(vfh.Step({{}, 0.0, 0.0, false, 1.9}, {}).speed, -0.1);
  EXPECT_GE(vfh.Step({{}, 0.0, 0.0, false, 2.1}, {}).speed, 0.0);
  VfhOptions wrong;
  wrong.window_diameter = 60;
  EXPECT_THROW(Vfh{wrong}, Error);
}

TEST(Vfh, SpeedGrowsWithTheAcceleration) {
  Vfh vfh(VfhDefaults());
  vfh.SetGoal({5.0, 0.0, 0.0});
  EXPECT_EQ(vfh.Step({{}, 0.0, 0.0, false, 0.0}, {}).speed, 0.0);
  EXPECT_NEAR(vfh.Step({{}, 0.0, 0.0, false, 0.5}, {}).speed, 0.1, 1e-12);
  EXPECT_NEAR(vfh.Step({{}, 0.1, 0.0, false, 9.5}, {}).speed, 0.2, 1e-12);
}

TEST(Vfh, ReachesGoalsAroundSingleObstaclesWithoutContact) {
  // A pillar, alone, between start and goal, met at different places.
  int reached = 0;
  int runs = 0;
  for (const double offset : {-0.12, -0.05, 0.0, 0.04, 0.10}) {
    for (const bool back : {false, true}) {
      const double start_x = back ? 2.5 : 0.7;
      Rig rig(Rig::World(R"({"obstacles": {"up": [72]}, "robots": [{"pose": {"x": )" +
                         std::to_string(start_x) + R"(, "y": 2.575, "yaw_deg": )" +
                         (back ? "180" : "0") + "}}]}"));
      Vfh vfh(VfhOptionsForS1r());
      const Pose2 goal{back ? 0.7 : 2.5, 2.575 + offset, 0.0};
      vfh.SetGoal(goal);
      Drive drive;
      const double began = rig.time();
      while (!drive.at_goal && rig.time() < began + 60.0) {
        drive = rig.Step([&] {
          const sim::Twist& twist = rig.robot().twist();
          const std::vector<Vec2> hits = HitPoints(rig.scan());
          return vfh.Step({rig.pose(), twist.v, twist.w, rig.robot().stalled(), rig.time()}, hits);
        });
      }
      ++runs;
      reached += drive.at_goal ? 1 : 0;
      EXPECT_EQ(rig.contacts(), 0U) << offset << " " << back;
      EXPECT_TRUE(drive.at_goal) << offset << " " << back << " at " << rig.pose().x << " "
                                 << rig.pose().y;
    }
  }
  std::cout << "VFH+: " << reached << " of " << runs << " goals\n";
}

}  // namespace
}  // namespace ccmorse::navigation
