// Adaptive Monte Carlo localisation (specs: player.md G.5).

#include "navigation/amcl.h"

#include <cstring>
#include <iostream>

#include "base/error.h"
#include "navigation/snd.h"
#include "navigation/wavefront.h"
#include "tests/navigation/rig.h"

namespace ccmorse::navigation {
namespace {

// The S1R on a tour of the hall, with an odometry that drifts: 3 % too long, 2 % of each turn, and
// a pull to the left of 0.01 rad each metre.
class Tour {
 public:
  Tour()
      : rig_(Rig::Named("course_map")),
        map_(MapOf(rig_.simulation().world().scene(), 0.02)),
        planner_(map_, WavefrontOptionsForS1r()),
        snd_(SndOptionsForS1r()),
        last_(rig_.pose()) {}

  const OccupancyGrid& map() const { return map_; }
  const Pose2& truth() const { return rig_.pose(); }
  const Pose2& odometry() const { return odometry_; }
  double time() const { return rig_.time(); }

  // Drives to the next scan, which `look` gets while the robot is where it was taken.
  template <typename Look>
  void Step(const Look& look) {
    rig_.Step([&] {
      const Vec2 moved = InverseTransform(last_, {rig_.pose().x, rig_.pose().y});
      const double turned = NormalizeAngle(rig_.pose().yaw - last_.yaw);
      last_ = rig_.pose();
      const Vec2 there = Transform(odometry_, {1.03 * moved.x, 1.03 * moved.y});
      odometry_ = {there.x, there.y,
                   NormalizeAngle(odometry_.yaw + 1.02 * turned + 0.01 * std::abs(moved.x))};
      look(rig_.scan());
      if (!planner_.goal() || planner_.Step(rig_.pose(), rig_.time()).done || arrived_) {
        constexpr Pose2 kStops[] = {{2.6, 2.7, 0.0},  {0.5, 1.8, 0.0}, {0.5, 2.95, 0.0},
                                    {2.0, 1.75, 0.0}, {2.7, 1.8, 0.0}, {1.5, 2.9, 0.0}};
        planner_.SetGoal(kStops[stop_++ % 6]);
        current_ = -1;
      }
      const WavefrontStatus status = planner_.Step(rig_.pose(), rig_.time());
      if (status.waypoint && (status.planned || status.current != current_)) {
        current_ = status.current;
        snd_.SetGoal(*status.waypoint);
      }
      const Drive drive = snd_.Step(rig_.pose(), rig_.scan());
      arrived_ = drive.at_goal;
      return drive;
    });
  }

 private:
  Rig rig_;
  OccupancyGrid map_;
  Wavefront planner_;
  Snd snd_;
  Pose2 last_;
  Pose2 odometry_;
  int current_ = -1;
  std::size_t stop_ = 0;
  bool arrived_ = false;
};

double Error2d(const Pose2& a, const Pose2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

constexpr double kPositionError = 0.06;  // m
constexpr double kAngleError = Radians(5.0);

void ExpectNear(const Pose2& best, const Pose2& truth, const char* when) {
  EXPECT_LT(Error2d(best, truth), kPositionError) << when;
  EXPECT_LT(std::abs(NormalizeAngle(best.yaw - truth.yaw)), kAngleError) << when;
}

TEST(Amcl, FindsItsPlaceInTheArenaOnSeveralSeeds) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    Tour tour;
    AmclOptions options = AmclOptionsForS1r();
    options.seed = seed;
    Amcl amcl(tour.map(), options);
    amcl.SetPoseUnknown();
    std::size_t fewest = amcl.particles().size();
    double worst = 0.0;
    while (tour.time() < 60.0) {
      tour.Step([&](const ScanView& scan) {
        amcl.Step(tour.odometry(), scan);
        fewest = std::min(fewest, amcl.particles().size());
        ASSERT_GE(amcl.particles().size(), 200U);
        ASSERT_LE(amcl.particles().size(), 10000U);
        if (tour.time() > 30.0) worst = std::max(worst, Error2d(amcl.BestPose(), tour.truth()));
      });
    }
    std::cout << "seed " << seed << ": " << amcl.updates() << " updates, worst error after 30 s "
              << worst << " m, last " << Error2d(amcl.BestPose(), tour.truth()) << " m, " << fewest
              << " particles at least, " << amcl.hypotheses().size() << " hypotheses\n";
    ExpectNear(amcl.BestPose(), tour.truth(), "at the end");
    EXPECT_LT(worst, 0.10) << seed;
    EXPECT_LT(fewest, 3000U);  // far fewer than at the start
    const AmclHypothesis& best = amcl.hypotheses().front();
    EXPECT_GT(best.weight, 0.9);
    EXPECT_LT(best.covariance[0], 0.05 * 0.05);
    EXPECT_LT(best.covariance[1], 0.05 * 0.05);
  }
}

TEST(Amcl, SetPosePutsAKidnappedFilterRight) {
  Tour tour;
  Amcl amcl(tour.map(), AmclOptionsForS1r());
  amcl.SetPose({0.5, 0.5, 1.0}, {0.02, 0.02, 0.05});  // in the maze: wrong, and sure of it
  while (tour.time() < 5.0) {
    tour.Step([&](const ScanView& scan) { amcl.Step(tour.odometry(), scan); });
  }
  EXPECT_GT(Error2d(amcl.BestPose(), tour.truth()), 0.5);
  amcl.SetPose({tour.truth().x + 0.1, tour.truth().y - 0.1, tour.truth().yaw + 0.2},
               {0.15, 0.15, 0.3});
  while (tour.time() < 20.0) {
    tour.Step([&](const ScanView& scan) { amcl.Step(tour.odometry(), scan); });
  }
  ExpectNear(amcl.BestPose(), tour.truth(), "15 s later");
}

std::vector<AmclParticle> Particles(std::uint64_t seed) {
  Tour tour;
  AmclOptions options = AmclOptionsForS1r();
  options.pf_max_samples = 2000;
  options.seed = seed;
  Amcl amcl(tour.map(), options);
  while (tour.time() < 5.0) {
    tour.Step([&](const ScanView& scan) { amcl.Step(tour.odometry(), scan); });
  }
  return amcl.particles();
}

TEST(Amcl, SameSeedSameParticlesBitForBit) {
  const auto first = Particles(7);
  const auto second = Particles(7);
  const auto other = Particles(8);
  ASSERT_EQ(first.size(), second.size());
  EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(AmclParticle)), 0);
  EXPECT_NE(first[0].pose.x, other[0].pose.x);
}

TEST(Amcl, KldSamplingAsksForMoreWhereMoreBinsAreNeeded) {
  OccupancyGrid map(10, 10, 0.1);
  AmclOptions options;
  const Amcl amcl(map, options);
  EXPECT_EQ(amcl.SampleLimit(1), 100);
  // k = 11: a = 2/90, b = 1 - a + 3 sqrt(a) = 1.42499, 10 / 0.02 b^3 = 1446.8.
  EXPECT_EQ(amcl.SampleLimit(11), 1447);
  EXPECT_EQ(amcl.SampleLimit(1000), 10000);
}

TEST(Amcl, HypothesesAreClustersWithMeanAndCovariance) {
  OccupancyGrid map(100, 100, 0.1);
  AmclOptions options;
  options.pf_max_samples = 10000;
  options.init_pose = {5.0, 5.0, kPi};  // over the end of the circle
  options.init_pose_var = {0.2, 0.1, 0.05};
  const Amcl amcl(map, options);
  ASSERT_EQ(amcl.hypotheses().size(), 1U);
  const AmclHypothesis& one = amcl.hypotheses()[0];
  EXPECT_NEAR(one.weight, 1.0, 1e-9);
  EXPECT_NEAR(one.mean.x, 5.0, 0.01);
  EXPECT_NEAR(one.mean.y, 5.0, 0.01);
  EXPECT_LT(std::abs(NormalizeAngle(one.mean.yaw - kPi)), 0.005);
  EXPECT_NEAR(one.covariance[0], 0.04, 0.003);
  EXPECT_NEAR(one.covariance[1], 0.01, 0.001);
  EXPECT_NEAR(one.covariance[2], 0.0025, 0.0002);
  EXPECT_NEAR(one.covariance[3], 0.0, 0.001);
  EXPECT_NEAR(one.covariance[4], 0.0, 0.001);
  EXPECT_NEAR(one.covariance[5], 0.0, 0.001);
}

TEST(Amcl, WorksOnlyAfterAMove) {
  OccupancyGrid map(20, 20, 0.1);
  Amcl amcl(map, AmclOptions());
  const std::vector<double> ranges(10, 8.0);
  const ScanView scan{-1.0, 0.2, 8.0, ranges, {}};
  EXPECT_TRUE(amcl.Step({}, scan));
  EXPECT_FALSE(amcl.Step({0.15, 0.1, 0.0}, scan));
  EXPECT_FALSE(amcl.Step({0.0, 0.0, -0.5}, scan));
  EXPECT_TRUE(amcl.Step({0.15, 0.15, 0.0}, scan));
  EXPECT_TRUE(amcl.Step({0.15, 0.15, 0.53}, scan));
  EXPECT_EQ(amcl.updates(), 3U);
  EXPECT_THROW(amcl.SetPose({std::nan(""), 0.0, 0.0}, {}), Error);
  EXPECT_THROW(amcl.SetPose({}, {-1.0, 0.0, 0.0}), Error);
  EXPECT_THROW(amcl.SetPoseUnknown(), Error);  // no free cell is known
  AmclOptions wrong;
  wrong.pf_max_samples = 10;
  EXPECT_THROW(Amcl(map, wrong), Error);
}

}  // namespace
}  // namespace ccmorse::navigation
