// The exploration task's programs in the simulator, judged by the simulator's record and the world.
#include <gtest/gtest.h>

#include <cstddef>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <tuple>

#include "base/error.h"
#include "base/image.h"
#include "base/json.h"
#include "scene/scenario.h"
#include "tests/end_to_end/arena_floor.h"
#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

constexpr int kWidth = kFloorWidth;
constexpr int kHeight = kFloorHeight;

const std::string kScenario =
    std::string(CCMORSE_SOURCE_DIR) + "/courses/par/exploration/scenario.json";

struct Explored {
  Json report;
  std::string map;  // kWidth x kHeight characters, row by row from the bottom
  Image canvas;
  std::string output;
};

Explored Explore(const std::string& program, const std::string& seconds) {
  const TemporaryFolder folder;
  const std::string report = folder.path() + "/report.json";
  const std::string map = folder.path() + "/map.txt";
  Simulator simulator(
      {kScenario, "--pace", "lockstep", "--report", report, "--out", folder.path()});
  const Finished explorer =
      RunToEnd({BuiltProgram(program), "--port", std::to_string(simulator.port()), "--map", map,
                "--save", "canvas", "--seconds", seconds});
  EXPECT_EQ(explorer.status, 0) << explorer.output;
  simulator.process().Signal(2);
  EXPECT_EQ(simulator.process().Wait(), 0) << simulator.process().output();
  std::istringstream lines(ReadFile(map));
  std::string line;
  std::getline(lines, line);
  std::string cells;
  while (std::getline(lines, line)) cells.insert(0, line);
  return {Json::Parse(ReadFile(report)), cells, ReadPng(folder.path() + "/canvas.png"),
          explorer.output};
}

class T12 : public ::testing::TestWithParam<const char*> {};
class T13 : public ::testing::TestWithParam<const char*> {};
class T14 : public ::testing::TestWithParam<const char*> {};

TEST_P(T12, MapIsRightAndWholeWithoutContact) {
  const Explored outcome = Explore(GetParam(), "400");
  const Json& robot = *outcome.report.Find("robots")->Find("s1r");
  EXPECT_EQ(robot.Find("contacts")->AsInt(), 0);
  EXPECT_LT(outcome.report.Find("simulated_s")->AsDouble(), 400.5);
  ASSERT_EQ(outcome.map.size(), std::size_t{kWidth} * kHeight);
  const scene::World world = scene::LoadScenario(kScenario).world;
  const Floor walls = TrueWalls(world);
  const Floor reachable = Reachable(world);
  int free = 0;
  int right = 0;
  int invented = 0;  // walls in the map, more than a cell from any
  const Floor near_walls = Grown(walls, 1);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    invented += outcome.map[i] == 'O' && near_walls[i] == 0 ? 1 : 0;
    if (reachable[i] == 0 || walls[i] != 0) continue;
    ++free;
    right += outcome.map[i] == '.' ? 1 : 0;
  }
  const double share = static_cast<double>(right) / free;
  std::cout << GetParam() << ": " << 100 * share << " % of " << free << " reachable cells in "
            << outcome.report.Find("simulated_s")->AsDouble() << " s, "
            << robot.Find("distance")->AsDouble() << " m\n";
  EXPECT_GT(free, 20000);
  EXPECT_GE(share, 0.95);
  EXPECT_EQ(invented, 0);
}

// One thread gathers, the other plans; in lock-step, whichever is faster, the run is the same.
TEST_P(T13, TwoThreadsComeToTheSameRunEveryTime) {
  const Explored first = Explore(GetParam(), "20");
  const Explored second = Explore(GetParam(), "20");
  EXPECT_EQ(*first.report.Find("hash"), *second.report.Find("hash"));
  EXPECT_EQ(first.map, second.map);
}

TEST_P(T14, CanvasShowsWhatTheRobotKnowsInTheThesissColours) {
  // Before the end, when there are frontiers left.
  const Image image = Explore(GetParam(), "12.4").canvas;
  ASSERT_EQ(image.width, kWidth);
  ASSERT_EQ(image.height, kHeight);
  std::map<std::tuple<int, int, int>, int> counts;
  for (const Color color : image.pixels) ++counts[{color.r, color.g, color.b}];
  EXPECT_GT((counts[{255, 255, 255}]), 2000);  // free
  EXPECT_GT((counts[{128, 128, 128}]), 1000);  // unexplored
  EXPECT_GT((counts[{128, 0, 128}]), 10);      // frontiers
  EXPECT_GT((counts[{255, 165, 0}]), 5);       // path
  EXPECT_GT((counts[{255, 0, 0}]), 20);        // trace
  // Blue, half transparent over white and over grey.
  int blue = 0;
  int black = 0;
  for (const auto& [color, count] : counts) {
    const auto [r, g, b] = color;
    if (r == g && r < 140 && b > r + 60) blue += count;
    if (r == g && g == b && r < 60) black += count;
  }
  EXPECT_GT(blue, 1000);
  EXPECT_GT(black, 100);
}

const auto kSolutions = ::testing::Values("explorer-nearest-frontier", "explorer-information-gain");
INSTANTIATE_TEST_SUITE_P(Solutions, T12, kSolutions);
INSTANTIATE_TEST_SUITE_P(Solutions, T13, kSolutions);
INSTANTIATE_TEST_SUITE_P(Solutions, T14, kSolutions);

TEST(T01, ExplorationTemplateStartsAndTheRobotStands) {
  const Explored outcome = Explore("explorer-template", "5");
  const Json& robot = *outcome.report.Find("robots")->Find("s1r");
  EXPECT_EQ(robot.Find("distance")->AsDouble(), 0.0);
  EXPECT_EQ(outcome.map, std::string(std::size_t{kWidth} * kHeight, '?'));
}

}  // namespace
}  // namespace ccmorse::testing
