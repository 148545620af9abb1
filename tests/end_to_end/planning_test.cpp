// The planning task's programs in the simulator.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <tuple>

#include "base/error.h"
#include "base/image.h"
#include "base/json.h"
#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

const std::string kTask = std::string(CCMORSE_SOURCE_DIR) + "/courses/par/planning";

using Counts = std::map<std::tuple<int, int, int>, int>;

Counts CountColors(const Image& image) {
  Counts counts;
  for (const Color color : image.pixels) ++counts[{color.r, color.g, color.b}];
  return counts;
}

// Runs a planner until it ends, and returns its canvas.
Image Shown(const std::string& program, int expected_status) {
  const TemporaryFolder folder;
  Simulator simulator({kTask + "/scenario.json", "--pace", "lockstep", "--out", folder.path()});
  const Finished planner =
      RunToEnd({BuiltProgram(program), "--port", std::to_string(simulator.port()), "--map",
                kTask + "/maps/arena.txt", "--save", "canvas"});
  EXPECT_EQ(planner.status, expected_status) << planner.output;
  return ReadPng(folder.path() + "/canvas.png");
}

class T11 : public ::testing::TestWithParam<const char*> {};

TEST_P(T11, DilatedMapIsLightBlueThePathDarkBlueAndTheSmoothedOneOrange) {
  const Image image = Shown(GetParam(), 0);
  ASSERT_EQ(image.width, 171);
  ASSERT_EQ(image.height, 186);
  Counts counts = CountColors(image);
  EXPECT_EQ((counts[{0, 0, 0}]), 6222);
  EXPECT_GT((counts[{255, 255, 255}]), 10000);
  // All that is floor and nearer than 5 cells to a wall: no path goes there.
  EXPECT_EQ((counts[{173, 216, 230}]), 171 * 186 - 6222 - 11344);
  EXPECT_GT((counts[{0, 0, 160}]), 100);
  EXPECT_GT((counts[{255, 165, 0}]), 200);
  EXPECT_EQ(counts.size(), 5U);
  // Row 0 is at the bottom: the paths end at (160, 10) there, in the smoothed path's colour.
  EXPECT_EQ(image.pixels[std::size_t{(185 - 10) * 171 + 160}], (Color{255, 165, 0}));
  EXPECT_EQ(image.pixels[std::size_t{(185 - 172) * 171 + 26}], (Color{255, 165, 0}));
}

INSTANTIATE_TEST_SUITE_P(Solutions, T11,
                         ::testing::Values("planner-dijkstra", "planner-theta-star"));

TEST(T01, PlanningTemplateStartsAndShowsTheMapWithoutAPath) {
  Counts counts = CountColors(Shown("planner-template", 1));
  EXPECT_EQ((counts[{0, 0, 0}]), 6222);
  EXPECT_EQ((counts[{0, 0, 160}]), 0);
  EXPECT_EQ((counts[{255, 165, 0}]), 0);
}

TEST(T10, RobotDrivesAlongThePlannedPathWithoutContact) {
  const TemporaryFolder folder;
  const std::string report = folder.path() + "/report.json";
  Simulator simulator({kTask + "/scenario.json", "--pace", "lockstep", "--report", report});
  const Finished planner =
      RunToEnd({BuiltProgram("planner-dijkstra"), "--port", std::to_string(simulator.port()),
                "--map", kTask + "/maps/arena.txt", "--drive"});
  EXPECT_EQ(planner.status, 0) << planner.output;
  simulator.process().Signal(2);
  EXPECT_EQ(simulator.process().Wait(), 0) << simulator.process().output();
  const Json robot = *Json::Parse(ReadFile(report)).Find("robots")->Find("s1r");
  EXPECT_EQ(robot.Find("contacts")->AsInt(), 0);
  EXPECT_GT(robot.Find("distance")->AsDouble(), 5.5);
}

}  // namespace
}  // namespace ccmorse::testing
