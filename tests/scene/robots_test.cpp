// The S1R against the thesis and the published models (specs: syrotek.md A).

#include "scene/robots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/polygon.h"
#include "base/trig.h"

namespace ccmorse::scene {
namespace {

const RobotModel& S1r() { return FindRobotModel("S1R"); }

struct Bounds {
  double min_x = 1e9;
  double max_x = -1e9;
  double min_y = 1e9;
  double max_y = -1e9;
};

Bounds BoundsOf(const std::vector<Vec2>& outline) {
  Bounds b;
  for (const Vec2 p : outline) {
    b.min_x = std::min(b.min_x, p.x);
    b.max_x = std::max(b.max_x, p.x);
    b.min_y = std::min(b.min_y, p.y);
    b.max_y = std::max(b.max_y, p.y);
  }
  return b;
}

TEST(R01, TwoWheelsALaserAndBothKindsOfPosition) {
  EXPECT_DOUBLE_EQ(S1r().wheel_radius, 0.04);
  EXPECT_DOUBLE_EQ(S1r().wheel_width, 0.01);
  EXPECT_DOUBLE_EQ(S1r().wheel_mass, 0.1);
  EXPECT_DOUBLE_EQ(S1r().wheel_track, 0.14);
  EXPECT_DOUBLE_EQ(S1r().mass, 2.0);
  const auto& position = S1r().proxies.at("position2d");
  EXPECT_EQ(position.at(0), "pose");
  EXPECT_EQ(position.at(2), "pose");  // the overhead camera's index on the real system (Q20)
  EXPECT_EQ(position.at(3), "odometry");
  EXPECT_FALSE(position.contains(1));  // the SND driver's
  EXPECT_EQ(S1r().proxies.at("laser").at(0), "hokuyo");
}

TEST(R01, SpeedLimitsCoverWhatProgramsAsk) {
  EXPECT_GE(S1r().max_speed, 0.45);     // SND on the real robot
  EXPECT_LE(S1r().max_speed, 0.5);      // the designers' upper wish
  EXPECT_GE(S1r().max_turn_rate, 2.2);  // the thesis's example (Q05)
}

TEST(R03, HullIsOfConvexPrismsWithRealDimensions) {
  ASSERT_EQ(S1r().hull.size(), 2U);
  for (const HullPart& part : S1r().hull) {
    ASSERT_EQ(part.outline.size(), 8U);
    EXPECT_LT(part.bottom, part.top);
    for (std::size_t i = 0; i < 8; ++i) {
      const Vec2 a = part.outline[i];
      const Vec2 b = part.outline[(i + 1) % 8];
      const Vec2 c = part.outline[(i + 2) % 8];
      EXPECT_GT(Cross(b - a, c - b), 0.0) << i;  // convex and counter-clockwise
    }
  }
  const Bounds bounds = BoundsOf(S1r().footprint);
  EXPECT_NEAR(bounds.max_x - bounds.min_x, 0.174, 1e-12);
  EXPECT_NEAR(bounds.max_y - bounds.min_y, 0.162, 1e-12);
  EXPECT_DOUBLE_EQ(S1r().length, 0.174);
  EXPECT_DOUBLE_EQ(S1r().width, 0.162);
  EXPECT_DOUBLE_EQ(S1r().height, 0.18);
  double radius = 0.0;
  for (const Vec2 p : S1r().footprint) radius = std::max(radius, std::sqrt(Dot(p, p)));
  EXPECT_NEAR(radius, 0.098, 0.0005);
}

TEST(R03, FootprintCoversAllPartsAndWheels) {
  for (const HullPart& part : S1r().hull) {
    for (const Vec2 corner : part.outline) EXPECT_TRUE(Contains(S1r().footprint, corner));
  }
  for (const double side : {-1.0, 1.0}) {
    const double y = side * (S1r().wheel_track + S1r().wheel_width) / 2.0;
    EXPECT_TRUE(Contains(S1r().footprint, {S1r().wheel_radius, y}));
    EXPECT_TRUE(Contains(S1r().footprint, {-S1r().wheel_radius, y}));
  }
}

TEST(R04, BodyIsLiftedHalfACentimetre) {
  EXPECT_DOUBLE_EQ(S1r().ground_clearance, 0.005);
  EXPECT_DOUBLE_EQ(S1r().hull[0].bottom, 0.005);
  EXPECT_DOUBLE_EQ(S1r().hull[0].top, S1r().hull[1].bottom);
  EXPECT_NEAR(S1r().hull[1].top, 0.005 + 0.18, 1e-12);
}

TEST(R05, OriginIsTheCentreOfTheBase) {
  EXPECT_NEAR(S1r().origin_height, (S1r().hull[0].bottom + S1r().hull[0].top) / 2.0, 1e-12);
  Vec2 sum;
  for (const Vec2 p : S1r().hull[0].outline) sum = sum + p;
  EXPECT_NEAR(sum.x, 0.0, 1e-12);
  EXPECT_NEAR(sum.y, 0.0, 1e-12);
}

TEST(R09, AllRobotsCarryTheSameDevices) {
  const Scenario scenario = ParseScenario(
      R"({"robots": [{"name": "a"}, {"name": "b", "pose": {"x": 2.2, "y": 2.6}}]})", "test.json");
  ASSERT_EQ(scenario.robots.size(), 2U);
  EXPECT_EQ(scenario.robots[0].proxies, scenario.robots[1].proxies);
  EXPECT_EQ(scenario.robots[0].proxies, S1r().proxies);
  EXPECT_EQ(scenario.robots[0].laser.samples, scenario.robots[1].laser.samples);
}

TEST(R10, HokuyoSitsAheadOfTheAxleAndScansAtTenHertz) {
  const LaserDef laser = ParseScenario("{}", "test.json").robots[0].laser;
  EXPECT_DOUBLE_EQ(laser.position.x, 0.035);
  EXPECT_DOUBLE_EQ(laser.position.y, 0.0);
  EXPECT_DOUBLE_EQ(laser.position.z, 0.0);
  EXPECT_DOUBLE_EQ(laser.yaw, 0.0);
  EXPECT_DOUBLE_EQ(laser.frequency, 10.0);
}

TEST(R11, HokuyoHasTheThesisProperties) {
  const LaserDef laser = ParseScenario("{}", "test.json").robots[0].laser;
  EXPECT_FALSE(laser.visible_arc);
  EXPECT_DOUBLE_EQ(laser.resolution_deg, 0.39589);
  EXPECT_DOUBLE_EQ(laser.scan_window_deg, 270.0);
  EXPECT_DOUBLE_EQ(laser.range, 5.0);
  EXPECT_DOUBLE_EQ(laser.layer_offset, 0.125);
}

TEST(R12, HokuyoHas682Samples) {
  EXPECT_EQ(ParseScenario("{}", "test.json").robots[0].laser.samples, 682);
  EXPECT_EQ(S1r().laser.samples, 682);
}

TEST(R13, PoseOdometryAndScannerHaveProxies) {
  std::vector<std::string> devices;
  for (const auto& [interface, table] : S1r().proxies) {
    for (const auto& [index, device] : table) devices.push_back(device);
  }
  for (const char* device : {"pose", "odometry", "hokuyo"}) {
    EXPECT_NE(std::find(devices.begin(), devices.end(), device), devices.end()) << device;
  }
}

TEST(RobotModels, UnknownTypeNamesTheKnownOnes) {
  EXPECT_EQ(RobotTypes(), (std::vector<std::string>{"BoxRobot", "S1R"}));
  try {
    FindRobotModel("S2R");
    FAIL() << "must throw";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "unknown robot type 'S2R', known: BoxRobot, S1R; did you mean 'S1R'?");
  }
}

}  // namespace
}  // namespace ccmorse::scene
