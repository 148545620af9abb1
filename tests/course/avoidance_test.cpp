#include "courses/par/intro/solutions/thesis/avoidance.h"

#include <gtest/gtest.h>

namespace {

using imr::robot::avoid;
using imr::robot::beamWindow;
using imr::robot::SBeamWindow;
using imr::robot::SNearest;
using imr::robot::SVelocity;

constexpr double kDegree = 3.14159265358979323846 / 180.0;

}  // namespace

TEST(X40, ConstantsAreTheThesiss) {
  EXPECT_EQ(imr::robot::VMAX, 0.3);
  EXPECT_EQ(imr::robot::WMAX, 1.0);
  EXPECT_EQ(imr::robot::RNG_ANGL_REACTION, 0.5);
  EXPECT_NEAR(imr::robot::HALF_FOV, 0.6981317008, 1e-10);
  EXPECT_EQ(imr::robot::MIN_OBSTACLE_RANGE, 0.20);
  EXPECT_EQ(imr::robot::SAFE_OBSTACLE_RANGE, 0.50);
  const SBeamWindow start;
  EXPECT_EQ(start.centerToEdge, 340u);
  EXPECT_EQ(start.center, 340u);
  EXPECT_EQ(start.left, 0u);
  EXPECT_EQ(start.right, 681u);
}

TEST(X41, WindowFollowsTheScan) {
  struct Case {
    unsigned count;
    double degrees;  // a beam
    unsigned to_edge, left, center, right;
  };
  // Worked out by hand: 40 degrees / resolution, rounded down, on either side of count / 2.
  const Case cases[] = {
      {682, 0.39589, 101, 240, 341, 442},  // S1R in the simulator
      {682, 0.3516, 113, 228, 341, 454},   // the device's own 240 degrees
      {622, 0.3516, 113, 198, 311, 424},   // what the real S1R delivers
      {270, 1.0, 40, 95, 135, 175},        // a beam a degree
      {361, 0.5, 80, 100, 180, 260},       // an odd count
  };
  for (const Case& c : cases) {
    const SBeamWindow window = beamWindow(c.count, c.degrees * kDegree);
    EXPECT_EQ(window.centerToEdge, c.to_edge) << c.count;
    EXPECT_EQ(window.left, c.left) << c.count;
    EXPECT_EQ(window.center, c.center) << c.count;
    EXPECT_EQ(window.right, c.right) << c.count;
  }
}

TEST(X41, NarrowScanIsUsedWholeAndNeverLeft) {
  for (unsigned count = 0; count < 90; ++count) {
    const SBeamWindow window = beamWindow(count, 1.0 * kDegree);
    EXPECT_LE(window.left, window.center);
    EXPECT_LT(window.right, count == 0 ? 1u : count);
    if (count > 0 && count <= 80) {
      EXPECT_EQ(window.left, 0u) << count;
      EXPECT_EQ(window.right, count - 1) << count;
    }
  }
}

TEST(X41, NonsenseResolutionUsesTheWholeScan) {
  EXPECT_EQ(beamWindow(10, 0.0).left, 0u);
  EXPECT_EQ(beamWindow(10, 0.0).right, 9u);
}

TEST(X42, VelocitiesMatchTheTable) {
  struct Case {
    SNearest left, right;
    double v, w;
  };
  // Worked out by hand from C.2 l.231-264, with HALF_FOV = 0.698131700798, for the nearer obstacle
  // (r, a): v = (r - 0.2) / 0.3 * 0.3, w = +-(0.1 / r + 0.5 * (1.396263401596 - 2.864788975655 a)).
  const Case cases[] = {
      // Free: full speed ahead. The limit itself is not free.
      {{5.0, 0.0}, {5.0, 0.0}, 0.3, 0.0},
      {{0.5001, -0.1}, {5.0, 0.0}, 0.3, 0.0},
      {{0.50, 0.0}, {5.0, 0.0}, 0.3, 0.898131700798},
      // An obstacle among the low indexes turns the robot one way ...
      {{0.35, -0.2}, {5.0, 0.0}, 0.15, 1.270324884078},
      {{0.25, -0.6981317007977318}, {5.0, 0.0}, 0.05, 2.098131700798},
      {{0.2000001, -0.6981317007977318}, {5.0, 0.0}, 0.0000001, 2.198131450798},
      // ... and one among the high indexes the other way, weakly: the law is not symmetric,
      {{5.0, 0.0}, {0.35, 0.2}, 0.15, -0.697367088947},
      // and far out to the side it even turns towards the obstacle.
      {{5.0, 0.0}, {0.50, 0.65}, 0.3, 0.032924716290},
      // The nearer one counts; at equal ranges the one among the high indexes.
      {{0.40, -0.3}, {0.30, 0.1}, 0.1, -0.888225585349},
      {{0.30, -0.3}, {0.30, 0.1}, 0.1, -0.888225585349},
      // Too near: turning on the spot, always the same way.
      {{0.20, -0.3}, {5.0, 0.0}, 0.0, 1.0},
      {{5.0, 0.0}, {0.20, 0.3}, 0.0, 1.0},
      {{0.05, -0.3}, {0.1, 0.3}, 0.0, 1.0},
  };
  for (const Case& c : cases) {
    const SVelocity velocity = avoid(c.left, c.right);
    EXPECT_NEAR(velocity.v, c.v, 1e-9) << c.left.range << " " << c.right.range;
    EXPECT_NEAR(velocity.w, c.w, 1e-9) << c.left.range << " " << c.right.range;
  }
}

TEST(Q05, TurnIsZeroInItsBearingPartAtTheNotedBearing) {
  // Only 0.1 / r is left there (avoidance.h).
  EXPECT_NEAR(avoid({5.0, 0.0}, {0.4, 0.4873878}).w, -0.25, 1e-6);
  // The strongest turn, noted as 2.2 rad/s.
  EXPECT_NEAR(avoid({0.2000001, -imr::robot::HALF_FOV}, {5.0, 0.0}).w, 2.198, 1e-3);
}
