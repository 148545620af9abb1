#include "sim/rays/planar_scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>

#include "base/polygon.h"
#include "base/trig.h"
#include "scene/scenario.h"

namespace ccmorse::sim {
namespace {

// The reference: every ray against every edge, in long double, with the C library's trigonometry.
struct Reference {
  long double range;
  bool near_edge;  // a corner lies within 1e-9 rad of the beam: either answer is right
};

Reference CastBruteForce(const Pose2& pose, long double bearing, double range,
                         const PlanarWorld& world, int self) {
  const long double angle = static_cast<long double>(pose.yaw) + bearing;
  const long double dx = std::cos(angle);
  const long double dy = std::sin(angle);
  Reference result{range, false};
  for (const PlanarWorld::Outline& outline : world.outlines()) {
    if (outline.owner >= 0 && outline.owner == self) continue;
    const auto corners = world.Corners(outline);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 from = corners[i];
      const Vec2 to = corners[(i + 1) % corners.size()];
      const long double ax = static_cast<long double>(from.x) - pose.x;
      const long double ay = static_cast<long double>(from.y) - pose.y;
      const long double ex = static_cast<long double>(to.x) - from.x;
      const long double ey = static_cast<long double>(to.y) - from.y;
      const long double across = dx * ay - dy * ax;
      const long double along = dx * ax + dy * ay;
      if (along > 0 && std::fabs(across / along) < 1e-9L) result.near_edge = true;
      const long double parallel = dx * ey - dy * ex;
      if (parallel == 0) continue;
      const long double distance = (ax * ey - ay * ex) / parallel;
      const long double part = (ax * dy - ay * dx) / parallel;
      if (distance >= 0 && part >= 0 && part <= 1) result.range = std::min(result.range, distance);
    }
  }
  return result;
}

int Mismatches(PlanarScanner& scanner, double first, double step, const Pose2& pose,
               const PlanarWorld& fixed, const PlanarWorld& moving, int self) {
  std::vector<double> ranges(static_cast<std::size_t>(scanner.count()));
  scanner.Scan(pose, fixed, moving, self, ranges);
  int wrong = 0;
  for (int i = 0; i < scanner.count(); ++i) {
    const long double bearing =
        static_cast<long double>(first) + i * static_cast<long double>(step);
    const Reference a = CastBruteForce(pose, bearing, scanner.range(), fixed, self);
    const Reference b = CastBruteForce(pose, bearing, scanner.range(), moving, self);
    if (a.near_edge || b.near_edge) continue;
    const double expected = static_cast<double>(std::min(a.range, b.range));
    const double got = ranges[static_cast<std::size_t>(i)];
    if (!(std::fabs(got - expected) <= 1e-9)) {
      ++wrong;
      std::cout << "beam " << i << " is " << got << ", the reference says " << expected << "\n";
    }
  }
  return wrong;
}

TEST(PlanarScan, AgreesWithBruteForceOnRandomScenes) {
  const std::uint64_t seed = std::random_device{}();
  std::cout << "random seed " << seed << "\n";
  std::mt19937_64 random(seed);
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int wrong = 0;
  for (int scene = 0; scene < 1000; ++scene) {
    PlanarWorld fixed;
    PlanarWorld moving;
    const Pose2 pose{uniform(-2, 2), uniform(-2, 2), uniform(-4, 4)};
    const int boxes = static_cast<int>(uniform(0, 40));
    for (int i = 0; i < boxes; ++i) {
      const Pose2 at{uniform(-4, 4), uniform(-4, 4), uniform(-4, 4)};
      const auto corners = BoxCorners(at, uniform(0.02, 1.0), uniform(0.02, 1.0));
      if (Contains(corners, {pose.x, pose.y})) continue;
      (i % 3 == 0 ? moving : fixed).Add(corners, i % 3 == 0 ? i : -1);
    }
    fixed.Finish();
    moving.Finish();
    const int count = static_cast<int>(uniform(1, 300));
    const double window = uniform(0.1, 2 * kPi);
    const double step = window / count;
    const double first = uniform(-kPi, kPi - 0.1);
    PlanarScanner scanner(count, first, step, uniform(0.5, 6.0));
    wrong += Mismatches(scanner, first, step, pose, fixed, moving, 3);
  }
  EXPECT_EQ(wrong, 0);
}

TEST(PlanarScan, AgreesWithBruteForceInTheSyrotekArena) {
  const scene::Scenario scenario = scene::LoadScenario(scene::FindScenario("course_map"));
  PlanarWorld boxes;
  for (const scene::Box& box : scenario.world.boxes) {
    if (box.raised) boxes.Add(BoxCorners(box.pose, box.size_x, box.size_y));
  }
  boxes.Finish();
  const scene::LaserDef laser;
  const double first = -Radians(laser.scan_window_deg) / 2.0;
  const double step = Radians(laser.resolution_deg);
  PlanarScanner scanner(laser.samples, first, step, laser.range);
  int wrong = 0;
  for (const Pose2 pose : {Pose2{1.2, 2.0, 2.618}, Pose2{0.18, 3.4, -1.57}, Pose2{1.15, 0.5, 0.0},
                           Pose2{3.1, 1.0, kPi}, Pose2{1.654, 2.253, -1.6}}) {
    wrong += Mismatches(scanner, first, step, pose, boxes, {}, -1);
  }
  EXPECT_EQ(wrong, 0);
}

TEST(PlanarScan, CornersCloseToABeamCoverWhatTheyShould) {
  // Rough angles decide but where they are in doubt: corners 1e-8 to 1e-5 rad beside a beam, at the
  // fan's ends and behind them, too.
  const std::uint64_t seed = std::random_device{}();
  std::cout << "random seed " << seed << "\n";
  std::mt19937_64 random(seed);
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int wrong = 0;
  for (int scene = 0; scene < 1000; ++scene) {
    const int count = 2 + scene % 90;
    const double first = uniform(-kPi, kPi);
    const double step = scene % 4 == 0 ? 2 * kPi / count : uniform(0.2, 1.0) * 2 * kPi / count;
    PlanarScanner scanner(count, first, step, 5.0);
    PlanarWorld world;
    for (int i = 0; i < 4; ++i) {
      const int beam = i == 0 ? 0 : i == 1 ? count - 1 : static_cast<int>(uniform(0, count));
      const double beside = std::pow(10.0, uniform(-8, -5)) * (random() % 2 == 0 ? 1.0 : -1.0);
      const double bearing = first + beam * step + beside;
      const double distance = uniform(0.5, 4.0);
      // A triangle on either side of that corner.
      const double turn = uniform(0.01, 0.5) * (random() % 2 == 0 ? 1.0 : -1.0);
      const auto at = [distance](double angle, double further) {
        return Vec2{(distance + further) * std::cos(angle), (distance + further) * std::sin(angle)};
      };
      Vec2 corners[] = {at(bearing, 0), at(bearing + turn, 0.1), at(bearing + turn, 0.6)};
      if (turn > 0.0) std::swap(corners[1], corners[2]);
      world.Add(corners);
    }
    world.Finish();
    wrong += Mismatches(scanner, first, step, {}, world, {}, -1);
  }
  EXPECT_EQ(wrong, 0);
}

TEST(PlanarScan, WhatIsRememberedWhileTheSensorMovesHidesNothingThatIsSeen) {
  const std::uint64_t seed = std::random_device{}();
  std::cout << "random seed " << seed << "\n";
  std::mt19937_64 random(seed);
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int wrong = 0;
  for (int scene = 0; scene < 100; ++scene) {
    // Long walls with small things and other walls before and behind them.
    PlanarWorld world;
    std::vector<std::array<Vec2, 4>> boxes;
    for (int i = 0; i < 60; ++i) {
      const bool wall = i % 4 == 0;
      const Pose2 at{uniform(-4, 4), uniform(-4, 4), uniform(-4, 4)};
      boxes.push_back(BoxCorners(at, wall ? uniform(1.0, 4.0) : uniform(0.05, 0.3), 0.05));
      world.Add(boxes.back());
    }
    world.Finish();
    PlanarScanner scanner(120, -kPi, kPi / 60, 5.0);
    Pose2 pose{uniform(-2, 2), uniform(-2, 2), 0.0};
    for (int i = 0; i < 20; ++i) {
      pose = {pose.x + uniform(-0.1, 0.1), pose.y + uniform(-0.1, 0.1), uniform(-4, 4)};
      const bool inside = std::any_of(boxes.begin(), boxes.end(), [&](const auto& corners) {
        return Contains(corners, {pose.x, pose.y});
      });
      if (!inside) wrong += Mismatches(scanner, -kPi, kPi / 60, pose, world, {}, -1);
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(PlanarScan, EveryInstructionSetGivesTheSameBits) {
  std::mt19937_64 random(1);
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int scene = 0; scene < 200; ++scene) {
    PlanarWorld world;
    for (int i = 0; i < 30; ++i) {
      world.Add(BoxCorners({uniform(-4, 4), uniform(-4, 4), uniform(-4, 4)}, 0.5, 0.3));
    }
    world.Finish();
    const Pose2 pose{uniform(-2, 2), uniform(-2, 2), uniform(-4, 4)};
    PlanarScanner scanner(301, -2.0, 0.013, 5.0);
    std::vector<double> best(301);
    std::vector<double> portable(301);
    scanner.Scan(pose, world, {}, -1, best);
    PlanarScanner::ForcePortable(true);
    scanner.Scan(pose, world, {}, -1, portable);
    PlanarScanner::ForcePortable(false);
    EXPECT_EQ(best, portable);
  }
}

// Angles are looked up roughly, to 1e-6 rad; with steps finer than that, or at the seam of a full
// turn, the exact part of the work has to make up for it.
TEST(PlanarScan, EdgesNearTheEndsOfAFanCoverTheRightBeams) {
  const std::uint64_t seed = std::random_device{}();
  std::cout << "random seed " << seed << "\n";
  std::mt19937_64 random(seed);
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int wrong = 0;
  for (int scene = 0; scene < 3000; ++scene) {
    // A box with a corner within a few rough errors of the first or the last beam.
    const int count = static_cast<int>(uniform(2, 60));
    const double step = scene % 3 == 0 ? 2 * kPi / count : std::pow(10.0, uniform(-9, -3));
    const double first = scene % 3 == 0 ? -kPi : uniform(-kPi, kPi - 0.1);
    const double end = scene % 2 == 0 ? first : first + (count - 1) * step;
    const double angle = end + uniform(-1, 1) * std::pow(10.0, uniform(-8, -3));
    const double distance = uniform(0.5, 2.0);
    PlanarWorld fixed;
    const Vec2 corner{distance * std::cos(angle), distance * std::sin(angle)};
    const double turn = uniform(-4, 4);
    const double side = uniform(1e-5, 0.4);
    const Vec2 middle = Transform({corner.x, corner.y, turn}, {side, side});
    fixed.Add(BoxCorners({middle.x, middle.y, turn}, 2 * side, 2 * side));
    if (Contains(fixed.Corners(fixed.outlines()[0]), {0, 0})) continue;
    fixed.Finish();
    PlanarScanner scanner(count, first, step, 4.0);
    wrong += Mismatches(scanner, first, step, {}, fixed, {}, -1);
  }
  EXPECT_EQ(wrong, 0);
}

TEST(PlanarScan, ItsOwnRobotIsInvisible) {
  PlanarWorld moving;
  moving.Add(BoxCorners({1.0, 0.0, 0.0}, 0.2, 0.2), 5);
  moving.Finish();
  PlanarScanner scanner(1, 0.0, 0.1, 4.0);
  std::vector<double> range(1);
  scanner.Scan({}, {}, moving, 5, range);
  EXPECT_EQ(range[0], 4.0);
  scanner.Scan({}, {}, moving, 4, range);
  EXPECT_NEAR(range[0], 0.9, 1e-12);
}

TEST(PlanarScan, ABeamWithoutAHitGivesExactlyTheRange) {
  PlanarScanner scanner(3, -0.1, 0.1, 5.0);
  std::vector<double> ranges(3);
  PlanarWorld far_away;
  far_away.Add(BoxCorners({5.2, 0.0, 0.0}, 0.2, 3.0));
  far_away.Finish();
  scanner.Scan({}, far_away, {}, -1, ranges);
  for (const double range : ranges) EXPECT_EQ(range, 5.0);
}

}  // namespace
}  // namespace ccmorse::sim
