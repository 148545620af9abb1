#include "sim/physics/kinematics.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "base/polygon.h"
#include "base/trig.h"
#include "scene/robots.h"

namespace ccmorse::sim {
namespace {

double Real(int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) * 1e-3; }

TEST(Kinematics, TheArcIsTheLimitOfSmallSteps) {
  EXPECT_TRUE(rc::check("one arc against 100000 Euler steps in the middle of each", [] {
    const Pose2 start{Real(-2, 2), Real(-2, 2), Real(-3, 3)};
    const double v = Real(-1, 1);
    const double w = Real(-3, 3);
    const double seconds = 0.5;
    double x = start.x;
    double y = start.y;
    double yaw = start.yaw;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
      const double h = seconds / kSteps;
      x += v * h * std::cos(yaw + w * h / 2);
      y += v * h * std::sin(yaw + w * h / 2);
      yaw += w * h;
    }
    const Pose2 end = DriveArc(start, v, w, seconds);
    RC_ASSERT(std::abs(end.x - x) < 1e-8);
    RC_ASSERT(std::abs(end.y - y) < 1e-8);
    RC_ASSERT(std::abs(std::remainder(end.yaw - yaw, 2 * kPi)) < 1e-9);
  }));
}

TEST(Kinematics, TwoHalvesAreTheWhole) {
  EXPECT_TRUE(rc::check("arc composition", [] {
    const Pose2 start{0, 0, Real(-3, 3)};
    const double v = Real(-1, 1);
    const double w = Real(-3, 3) * 1e-3;  // nearly straight, where the formula is delicate
    const Pose2 whole = DriveArc(start, v, w, 1.0);
    const Pose2 halves = DriveArc(DriveArc(start, v, w, 0.5), v, w, 0.5);
    RC_ASSERT(std::abs(whole.x - halves.x) < 1e-12);
    RC_ASSERT(std::abs(whole.y - halves.y) < 1e-12);
  }));
}

TEST(Contact, NothingEverOverlapsAndABlockedRobotStandsCloseToWhatBlocksIt) {
  const Footprint footprint = Footprint::Make(scene::FindRobotModel("S1R").footprint);
  EXPECT_TRUE(rc::check("random drives among random boxes", [&footprint] {
    std::vector<Obstacle> boxes;
    for (int i = 0; i < 12; ++i) {
      const auto corners = BoxCorners({Real(-1, 1), Real(-1, 1), Real(-3, 3)}, 0.04, 0.32);
      boxes.push_back(Obstacle::Make({corners.begin(), corners.end()}, i + 1));
    }
    std::vector<const Obstacle*> all;
    for (const Obstacle& box : boxes) all.push_back(&box);
    Pose2 pose{0, 0, Real(-3, 3)};
    if (Collides(footprint, pose, all)) return;
    for (int i = 0; i < 60; ++i) {
      const MotionResult moved =
          DriveUntilContact(footprint, pose, Real(-1, 1), Real(-4, 4), 1.0 / 10, all);
      pose = moved.pose;
      double nearest = 1e9;
      for (const Obstacle& box : boxes) {
        nearest = std::min(nearest, ConvexGap(footprint.At(pose), box.outline));
      }
      RC_ASSERT(nearest >= -1e-12);
      if (moved.blocked) RC_ASSERT(nearest < 1e-3);
    }
  }));
}

TEST(Contact, AFastRobotDoesNotJumpOverAThinWall) {
  const Footprint footprint = Footprint::Make(scene::FindRobotModel("S1R").footprint);
  const auto corners = BoxCorners({1.0, 0.0, 0.0}, 0.02, 4.0);
  const Obstacle wall = Obstacle::Make({corners.begin(), corners.end()}, 1);
  const Obstacle* const all[] = {&wall};
  const MotionResult moved = DriveUntilContact(footprint, {}, 100.0, 0.0, 1.0, all);
  EXPECT_TRUE(moved.blocked);
  EXPECT_LT(moved.pose.x, 0.99 - 0.087 + 1e-9);
  EXPECT_GT(moved.pose.x, 0.99 - 0.087 - 1e-3);
}

}  // namespace
}  // namespace ccmorse::sim
