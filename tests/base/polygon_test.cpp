#include "base/polygon.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "base/trig.h"

namespace ccmorse {
namespace {

double Real(int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) * 1e-3; }

TEST(Polygon, TransformAndItsInverseUndoEachOther) {
  EXPECT_TRUE(rc::check("round trip", [] {
    const Pose2 frame{Real(-5, 5), Real(-5, 5), Real(-4, 4)};
    const Vec2 point{Real(-5, 5), Real(-5, 5)};
    const Vec2 back = InverseTransform(frame, Transform(frame, point));
    RC_ASSERT(std::abs(back.x - point.x) < 1e-12 && std::abs(back.y - point.y) < 1e-12);
  }));
}

TEST(Polygon, OverlapAgreesWithSampledPoints) {
  EXPECT_TRUE(rc::check("a shared inner point means overlap, a gap means none", [] {
    const auto a = BoxCorners({0, 0, Real(-4, 4)}, 1.0, 0.5);
    const Pose2 at{Real(-1, 1), Real(-1, 1), Real(-4, 4)};
    const auto b = BoxCorners(at, 0.7, 0.3);
    bool shared = false;
    for (double u = -0.345; u < 0.35; u += 0.03) {
      for (double v = -0.145; v < 0.15; v += 0.029) {
        shared = shared || Contains(a, Transform(at, {u, v}));
      }
    }
    if (shared) RC_ASSERT(ConvexGap(a, b) <= 0.0);
    if (ConvexGap(a, b) > 0.0) RC_ASSERT(!shared);
    RC_ASSERT(std::abs(ConvexGap(a, b) - ConvexGap(b, a)) < 1e-12);
  }));
}

TEST(Polygon, GapAndDepthAreMetres) {
  const auto a = BoxCorners({0, 0, 0}, 2.0, 2.0);
  EXPECT_NEAR(ConvexGap(a, BoxCorners({2.5, 0, 0}, 2.0, 2.0)), 0.5, 1e-12);
  EXPECT_NEAR(ConvexGap(a, BoxCorners({1.9, 0, 0}, 2.0, 2.0)), -0.1, 1e-12);
}

}  // namespace
}  // namespace ccmorse
