// Smooth nearness diagram navigation (specs: player.md G.1), step by step and in the arena.

#include "navigation/snd.h"

#include <iostream>

#include "base/error.h"
#include "navigation/wavefront.h"
#include "tests/navigation/rig.h"

namespace ccmorse::navigation {
namespace {

// 360 sectors, sector 180 ahead; 181 beams from sector 90 to sector 270.
constexpr double kResolution = 2.0 * kPi / 359.8;
constexpr int kFirst = 90;

SndOptions SndDefaults() {
  SndOptions options;
  options.robot_radius = 0.1;
  options.min_gap_width = 0.2;
  options.obstacle_avoid_dist = 0.4;
  options.max_speed = 0.5;
  options.max_turn_rate = 1.0;
  return Snd::Resolved(options);
}

struct Span {
  int from;  // sector
  int to;
  double distance;  // m
};

NearnessDiagram Diagram(const std::vector<Span>& obstacles, int beams = 181) {
  std::vector<double> ranges(static_cast<std::size_t>(beams), 5.0);
  const int first = 180 - beams / 2;
  for (const Span& span : obstacles) {
    for (int i = span.from; i <= span.to; ++i) {
      ranges[static_cast<std::size_t>(i - first)] = span.distance;
    }
  }
  return MakeNearnessDiagram({(first - 180) * kResolution, kResolution, 5.0, ranges, {}},
                             SndDefaults());
}

TEST(Snd, DefaultsAreThoseOfPlayersManual) {
  const SndOptions options = Snd::Resolved({});
  EXPECT_EQ(options.robot_radius, 0.25);
  EXPECT_EQ(options.min_gap_width, 0.5);
  EXPECT_EQ(options.obstacle_avoid_dist, 1.0);
  EXPECT_EQ(options.max_speed, 0.5);
  EXPECT_DOUBLE_EQ(options.max_turn_rate, kPi / 3.0);
  EXPECT_EQ(options.goal_position_tol, 0.125);
  EXPECT_DOUBLE_EQ(options.goal_angle_tol, kPi / 6.0);
  SndOptions wrong;
  wrong.robot_radius = 0.0;
  EXPECT_THROW(Snd{wrong}, Error);
  wrong = {};
  wrong.max_turn_rate = std::nan("");
  EXPECT_THROW(Snd{wrong}, Error);
}

TEST(Snd, SectorsCoverTheFullCircleWithTheScanInTheMiddle) {
  const NearnessDiagram diagram = Diagram({{180, 180, 0.3}});
  EXPECT_EQ(diagram.count, 360);
  EXPECT_EQ(diagram.ahead(), 180);
  EXPECT_EQ(diagram.first, kFirst);
  EXPECT_EQ(diagram.distance[180], 0.3);
  EXPECT_EQ(diagram.distance[0], 5.0);    // behind: not seen
  EXPECT_EQ(diagram.nearness[179], 0.0);  // nothing in range
  EXPECT_NEAR(diagram.nearness[180], 5.0 + 0.2 - 0.3, 1e-12);
  EXPECT_EQ(diagram.nearest, 0.3);
  EXPECT_EQ(diagram.Between(350, 10), 20);
  EXPECT_EQ(diagram.Between(10, 350), -20);
  EXPECT_EQ(diagram.Wrap(-1), 359);
}

TEST(Snd, SafetyDistanceShrinksNearObstacles) {
  EXPECT_NEAR(Diagram({{180, 180, 0.30}}).safety, 0.4, 1e-12);   // 5 (0.3 - 0.1) is more
  EXPECT_NEAR(Diagram({{180, 180, 0.15}}).safety, 0.25, 1e-12);  // 5 (0.15 - 0.1)
  EXPECT_EQ(Diagram({{180, 180, 0.08}}).safety, 0.0);
}

TEST(Snd, NoReturnsAndNonsenseAreFree) {
  const std::vector<double> ranges = {std::nan(""), -1.0, 7.0, 5.0, 1.0};
  const NearnessDiagram diagram =
      MakeNearnessDiagram({-2 * kResolution, kResolution, 5.0, ranges, {}}, SndDefaults());
  EXPECT_EQ(diagram.nearest, 1.0);
  for (int i = 178; i <= 181; ++i) EXPECT_EQ(diagram.distance[static_cast<std::size_t>(i)], 5.0);
  SndOptions blind = SndDefaults();
  blind.min_range = 1.5;
  EXPECT_EQ(MakeNearnessDiagram({-2 * kResolution, kResolution, 5.0, ranges, {}}, blind).nearest,
            5.0);
}

TEST(Snd, GapsAreJumpsOfNearness) {
  // An obstacle 1 m ahead; the ends of the narrow scan are gaps as well.
  const auto gaps = FindGaps(Diagram({{170, 180, 1.0}}), SndDefaults());
  const std::vector<SndGap> expected = {
      {90, 1, 5.0}, {169, 1, 1.0}, {181, -1, 1.0}, {270, -1, 5.0}};
  EXPECT_EQ(gaps, expected);
  // A jump of 0.19 m is no gap, one of 0.21 m is.
  EXPECT_EQ(FindGaps(Diagram({{90, 180, 1.0}, {181, 270, 1.19}}), SndDefaults()).size(), 2U);
  EXPECT_EQ(FindGaps(Diagram({{90, 180, 1.0}, {181, 270, 1.21}}), SndDefaults()).size(), 3U);
}

TEST(Snd, GapsSideBySideAreOne) {
  const auto gaps =
      FindGaps(Diagram({{168, 168, 2.0}, {169, 180, 1.0}, {181, 181, 2.0}}), SndDefaults());
  const std::vector<SndGap> expected = {
      {90, 1, 5.0}, {167, 1, 2.0}, {182, -1, 2.0}, {270, -1, 5.0}};
  EXPECT_EQ(gaps, expected);
}

TEST(Snd, FullCircleHasNoForcedGaps) {
  const auto gaps = FindGaps(Diagram({{0, 10, 1.0}, {350, 359, 1.0}}, 360), SndDefaults());
  const std::vector<SndGap> expected = {{11, -1, 1.0}, {349, 1, 1.0}};
  EXPECT_EQ(gaps, expected);
}

TEST(Snd, ValleysLieBetweenGaps) {
  const NearnessDiagram diagram = Diagram({{170, 180, 1.0}});
  const auto valleys = FindValleys(diagram, FindGaps(diagram, SndDefaults()), 180, SndDefaults());
  ASSERT_EQ(valleys.size(), 3U);
  // Right of the obstacle, by its right corner and on to the right.
  EXPECT_EQ(valleys[0].right, 90);
  EXPECT_EQ(valleys[0].left, 169);
  EXPECT_EQ(valleys[0].rising.sector, 169);
  EXPECT_EQ(valleys[0].direction, -1);
  // Left of it.
  EXPECT_EQ(valleys[1].rising.sector, 181);
  EXPECT_EQ(valleys[1].direction, 1);
  // Behind: both ends rise.
  EXPECT_EQ(valleys[2].right, 270);
  EXPECT_EQ(valleys[2].left, 90);
}

TEST(Snd, BothEdgesRiseTheNearerToTheGoalCounts) {
  const NearnessDiagram diagram = Diagram({{90, 150, 1.0}, {210, 270, 1.0}});
  const auto rising = [&](int goal) {
    const auto valleys =
        FindValleys(diagram, FindGaps(diagram, SndDefaults()), goal, SndDefaults());
    for (const SndValley& valley : valleys) {
      if (valley.right == 151) return valley.rising.sector;
    }
    return -1;
  };
  EXPECT_EQ(rising(160), 151);
  EXPECT_EQ(rising(200), 209);
}

TEST(Snd, GapIsSafeWithRoomBesideItsCorner) {
  // Corner at 1 m in sector 169; 9 sectors are 0.157 m there, 13 are 0.227 m; 2.2 R = 0.22 m.
  const SndGap corner{169, 1, 1.0};
  EXPECT_FALSE(IsSafeGap(Diagram({{170, 180, 1.0}, {150, 160, 1.0}}), corner, SndDefaults()));
  EXPECT_TRUE(IsSafeGap(Diagram({{170, 180, 1.0}, {146, 156, 1.0}}), corner, SndDefaults()));
  // What is on the other side does not matter.
  EXPECT_TRUE(IsSafeGap(Diagram({{170, 180, 1.0}, {181, 190, 0.95}}), corner, SndDefaults()));
}

TEST(Snd, ValleyNearestToTheGoalIsChosenFirstOfThoseAhead) {
  const NearnessDiagram diagram = Diagram({{170, 180, 1.0}});
  const auto chosen = [&](int goal) {
    const auto valleys =
        FindValleys(diagram, FindGaps(diagram, SndDefaults()), goal, SndDefaults());
    return ChooseValley(diagram, valleys, goal).value().rising.sector;
  };
  EXPECT_EQ(chosen(178), 181);
  EXPECT_EQ(chosen(172), 169);
  // 169 is 93 sectors from 76, more than n/4 + 1: the one behind counts, too.
  EXPECT_EQ(chosen(76), 90);
  EXPECT_EQ(chosen(79), 169);  // 90 sectors
  EXPECT_FALSE(ChooseValley(diagram, {}, 180));
}

TEST(Snd, CorridorIsAsWideAsTheRobotAndAsLongAsTheWay) {
  const NearnessDiagram diagram = Diagram({{170, 180, 1.0}});
  EXPECT_FALSE(IsCorridorClear(diagram, 178, 3.0, SndDefaults()));
  EXPECT_TRUE(IsCorridorClear(diagram, 178, 1.05, SndDefaults()));  // 1.05 - R < 1
  // The corner at sector 180: asin(0.1 / 1) is 5.7 sectors.
  EXPECT_FALSE(IsCorridorClear(diagram, 185, 3.0, SndDefaults()));
  EXPECT_TRUE(IsCorridorClear(diagram, 186, 3.0, SndDefaults()));
  EXPECT_TRUE(IsCorridorClear(diagram, 0, 3.0, SndDefaults()));
}

TEST(Snd, TargetKeepsClearOfTheCorner) {
  const NearnessDiagram diagram = Diagram({{170, 180, 1.0}});
  const SndValley left{181, 270, {181, -1, 1.0}, 1};
  // asin((D + R) / c) = asin(0.5) = 30 degrees: 30 sectors from the corner.
  EXPECT_EQ(TargetSector(diagram, left, 178, 3.0, SndDefaults()), 211);
  // The goal itself when the way there is clear and ahead.
  EXPECT_EQ(TargetSector(diagram, left, 200, 3.0, SndDefaults()), 200);
  EXPECT_EQ(TargetSector(diagram, left, 178, 1.05, SndDefaults()), 178);
  // Goals beyond a quarter turn are not gone for directly.
  EXPECT_EQ(TargetSector(diagram, left, 275, 3.0, SndDefaults()), 211);
  const SndValley right{90, 169, {169, 1, 1.0}, -1};
  EXPECT_EQ(TargetSector(diagram, right, 172, 3.0, SndDefaults()), 139);
}

TEST(Snd, TargetIsTheMiddleOfANarrowValley) {
  // From the corner at 181 it is open up to sector 200: 19 sectors, 19 / 2 - 1 = 8.
  const NearnessDiagram diagram = Diagram({{170, 180, 1.0}, {201, 230, 0.9}});
  const SndValley valley{181, 200, {181, -1, 1.0}, 1};
  EXPECT_EQ(TargetSector(diagram, valley, 178, 3.0, SndDefaults()), 189);
  // Corners nearer than D + R: a quarter turn, but no more than beams / 3 = 60.
  const NearnessDiagram near = Diagram({{170, 180, 0.45}});
  EXPECT_EQ(TargetSector(near, SndValley{181, 270, {181, -1, 0.45}, 1}, 178, 3.0, SndDefaults()),
            181 + 43);  // the middle of 89 is nearer still
  EXPECT_EQ(TargetSector(near, SndValley{181, 90, {181, -1, 0.45}, 1}, 178, 3.0, SndDefaults()),
            181 + 60);
}

TEST(Snd, WithoutAValleyItGoesToTheGoalOrTurnsAround) {
  const NearnessDiagram diagram = Diagram({{90, 270, 1.0}});
  EXPECT_EQ(TargetSector(diagram, std::nullopt, 180, 0.5, SndDefaults()), 180);
  EXPECT_EQ(TargetSector(diagram, std::nullopt, 180, 3.0, SndDefaults()), 0);
  EXPECT_EQ(TargetSector(Diagram({{90, 270, 0.09}}), std::nullopt, 100, 3.0, SndDefaults()), 180);
}

TEST(Snd, ObstaclesWithinTheSafetyDistanceDeflect) {
  // 0.3 m to the left: w = (0.4 + 0.1 - 0.3) / 0.4 = 0.5, delta = -90: S = w^3 delta / w^2 = -45.
  EXPECT_NEAR(Deflection(Diagram({{270, 270, 0.3}}), 180, 0.1), -45.0, 1e-9);
  EXPECT_NEAR(Deflection(Diagram({{90, 90, 0.3}}), 180, 0.1), 45.0, 1e-9);
  EXPECT_NEAR(Deflection(Diagram({{90, 90, 0.3}, {270, 270, 0.3}}), 180, 0.1), 0.0, 1e-9);
  // Right at 0.3 m (w 0.5) and left at 0.4 m (w 0.25): 90 (0.125 - 0.015625) / 0.3125.
  EXPECT_NEAR(Deflection(Diagram({{90, 90, 0.3}, {270, 270, 0.4}}), 180, 0.1), 31.5, 1e-9);
  EXPECT_EQ(Deflection(Diagram({{270, 270, 0.6}}), 180, 0.1), 0.0);   // beyond
  EXPECT_EQ(Deflection(Diagram({{270, 270, 0.09}}), 180, 0.1), 0.0);  // Ds = 0: not 0 / 0
}

TEST(Snd, SpeedLaws) {
  const auto expect = [](double angle, double distance, double nearest, double speed, double turn) {
    const Drive drive = SndSpeeds(angle, distance, nearest, SndDefaults());
    EXPECT_NEAR(drive.speed, speed, 1e-12) << angle << " " << distance << " " << nearest;
    EXPECT_NEAR(drive.turn_rate, turn, 1e-12) << angle << " " << distance << " " << nearest;
  };
  expect(0.0, 3.0, 5.0, 0.5, 0.0);
  expect(kPi / 12.0, 3.0, 0.3, 0.125, 1.0 / 6.0);  // half for the angle, half for the obstacle
  expect(-kPi / 12.0, 3.0, 0.3, 0.125, -1.0 / 6.0);
  expect(0.0, 0.25, 5.0, 0.25, 0.0);  // 2 * 0.25 m
  expect(kPi / 6.0, 3.0, 5.0, 0.0, 1.0 / 3.0);
  expect(kPi, 3.0, 5.0, 0.0, 1.0);
  expect(0.0, 3.0, 0.1, 0.0, 0.0);
}

TEST(Snd, TurnsAtTheGoalAndStops) {
  SndOptions options = SndDefaults();
  options.goal_angle_tol = 0.1;
  Snd snd(options);
  const std::vector<double> ranges(181, 5.0);
  const ScanView scan{-90 * kResolution, kResolution, 5.0, ranges, {}};
  EXPECT_EQ(snd.Step({0.0, 0.0, 0.0}, scan).speed, 0.0);  // no goal
  EXPECT_FALSE(snd.Step({0.0, 0.0, 0.0}, scan).at_goal);
  snd.SetGoal({1.0, 2.0, 3.0});
  // From -3 to 3 rad it is 2 pi - 6 to the right, not 6 to the left.
  const Drive turning = snd.Step({1.01, 2.0, -3.0}, scan);
  EXPECT_EQ(turning.speed, 0.0);
  EXPECT_NEAR(turning.turn_rate, (6.0 - 2.0 * kPi) / 3.0, 1e-9);
  EXPECT_FALSE(turning.at_goal);
  const Drive there = snd.Step({1.01, 2.0, 2.95}, scan);
  EXPECT_TRUE(there.at_goal);
  EXPECT_EQ(there.turn_rate, 0.0);
  // Pushed away it waits for the next goal all the same.
  EXPECT_TRUE(snd.Step({1.5, 2.0, 2.0}, scan).at_goal);
  snd.SetGoal({5.0, 2.0, 0.0});
  EXPECT_GT(snd.Step({1.0, 2.0, 0.0}, scan).speed, 0.0);
  // 1000 m away only the heading of the goal counts.
  snd.SetGoal({3000.0, 2.0, 0.5});
  EXPECT_GT(snd.Step({1.0, 2.0, 0.0}, scan).turn_rate, 0.1);
  EXPECT_THROW(snd.SetGoal({std::nan(""), 0.0, 0.0}), Error);
}

TEST(Snd, StandsWithSomethingInsideItsRadius) {
  Snd snd(SndDefaults());
  snd.SetGoal({5.0, 0.0, 0.0});
  std::vector<double> ranges(181, 5.0);
  ranges[10] = 0.09;
  const Drive drive = snd.Step({}, {-90 * kResolution, kResolution, 5.0, ranges, {}});
  EXPECT_TRUE(drive.stalled);
  EXPECT_EQ(drive.speed, 0.0);
  EXPECT_EQ(drive.turn_rate, 0.0);
}

TEST(Snd, ScannerAwayFromTheMiddleIsPutRight) {
  // A wall at x = 1, seen from (0.2, 0.1, 0.3), must be a wall at x = 1 from the robot's middle.
  const Pose2 mount{0.2, 0.1, 0.3};
  const double resolution = Radians(0.5);
  std::vector<double> ranges;
  for (int i = 0; i < 240; ++i) {
    const auto [sine, cosine] = SinCos(mount.yaw + (i - 120) * resolution);
    ranges.push_back(cosine > 0.0 ? std::min(5.0, 0.8 / cosine) : 5.0);
  }
  const Scan centred = CentreScan({-120 * resolution, resolution, 5.0, ranges, mount});
  ASSERT_EQ(centred.ranges.size(), 720U);
  for (int i = 340; i <= 420; ++i) {
    const auto [sine, cosine] = SinCos(centred.min_angle + i * resolution);
    EXPECT_NEAR(centred.ranges[static_cast<std::size_t>(i)] * cosine, 1.0, 0.02) << i;
  }
  EXPECT_EQ(centred.ranges[0], 5.0);
}

// Goals in the open hall of the arena (specs: syrotek.md B) that the robot can reach with `margin`
// (m) around it.
std::vector<Pose2> HallGoals(const Rig& rig, double margin, int count, std::uint64_t seed) {
  const OccupancyGrid free = MapOf(rig.simulation().world().scene(), 0.01)
                                 .Inflated(rig.robot().footprint().radius + margin);
  const std::vector<bool> reachable = ReachableFrom(free, {rig.pose().x, rig.pose().y});
  std::mt19937_64 random(seed);
  std::vector<Pose2> goals;
  while (static_cast<int>(goals.size()) < count) {
    const Pose2 goal{Draw(random, 0.34, 2.90), Draw(random, 1.62, 3.18), Draw(random, -kPi, kPi)};
    if (reachable[free.IndexOf(free.CellOf({goal.x, goal.y}))]) goals.push_back(goal);
  }
  return goals;
}

// Goes to the goals one after the other, at most a minute each; with a planner, by its waypoints.
// The number reached.
int DriveTour(Rig& rig, const std::vector<Pose2>& goals, Wavefront* planner) {
  Snd snd(SndOptionsForS1r());
  int reached = 0;
  for (const Pose2& goal : goals) {
    snd.SetGoal(goal);
    if (planner) planner->SetGoal(goal);
    int current = -1;
    bool there = false;
    const double start = rig.time();
    while (!there && rig.time() < start + 60.0) {
      const Drive drive = rig.Step([&] {
        if (planner) {
          const WavefrontStatus status = planner->Step(rig.pose(), rig.time());
          if (status.waypoint && (status.planned || status.current != current)) {
            current = status.current;
            snd.SetGoal(*status.waypoint);
          }
        }
        return snd.Step(rig.pose(), rig.scan());
      });
      const Vec2 off{goal.x - rig.pose().x, goal.y - rig.pose().y};
      there = drive.at_goal && Dot(off, off) < 0.06 * 0.06 &&
              std::abs(NormalizeAngle(goal.yaw - rig.pose().yaw)) < Radians(35.0);
    }
    reached += there ? 1 : 0;
  }
  return reached;
}

void Report(const Rig& rig, const char* what, std::uint64_t seed, int reached) {
  std::cout << what << ": seed " << seed << ", reached " << reached << " of 100, " << rig.contacts()
            << " contacts, " << rig.time() << " s, " << rig.robot().tally().distance << " m\n";
}

constexpr std::uint64_t kSeed = 1;
// More than the goal's tolerance: where SND may stop must be clear as well.
constexpr double kMargin = 0.055;  // m

TEST(Snd, HundredGoalsAmongThePillarsOfTheArena) {
  // The course's map without its three slabs, which make a pocket.
  Rig rig(Rig::World(
      R"({"obstacles": {"up": [5, 10, 19, 22, 23, 61, 69, 70, 71, 72, 73, 74, 75, 76]}})"));
  const int reached = DriveTour(rig, HallGoals(rig, kMargin, 100, kSeed), nullptr);
  Report(rig, "SND alone, pillars", kSeed, reached);
  EXPECT_GE(reached, 98);
  EXPECT_EQ(rig.contacts(), 0U);
}

TEST(Snd, HundredGoalsOnTheCourseMapByWaypoints) {
  Rig rig(Rig::Named("course_map"));
  Wavefront planner(MapOf(rig.simulation().world().scene(), 0.02), WavefrontOptionsForS1r());
  const int reached = DriveTour(rig, HallGoals(rig, kMargin, 100, kSeed), &planner);
  Report(rig, "SND and wavefront, course map", kSeed, reached);
  EXPECT_GE(reached, 98);
  EXPECT_EQ(rig.contacts(), 0U);
}

TEST(Snd, AloneOnTheCourseMapItTouchesNothing) {
  // Whoever keeps no map does not get out of the slabs' pocket towards a goal behind it; but it
  // must not touch them either.
  Rig rig(Rig::Named("course_map"));
  const int reached = DriveTour(rig, HallGoals(rig, kMargin, 100, kSeed), nullptr);
  Report(rig, "SND alone, course map", kSeed, reached);
  EXPECT_GE(reached, 75);
  EXPECT_EQ(rig.contacts(), 0U);
}

}  // namespace
}  // namespace ccmorse::navigation
