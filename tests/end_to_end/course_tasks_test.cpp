// The introduction and the follow-up tasks in the simulator, judged by its report and record: each
// template starts, and each solution does what it should.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/image.h"
#include "base/json.h"
#include "base/pose.h"
#include "scene/scenario.h"
#include "tests/end_to_end/arena_floor.h"
#include "tests/support/process.h"
#include "tests/support/record_file.h"

namespace ccmorse::testing {
namespace {

const std::string kCourses = CCMORSE_SOURCE_DIR "/courses/";

struct TaskOutcome {
  Json report;
  std::map<std::string, std::vector<Vec2>> ways;  // robot -> where it was, 10 times a second
  std::vector<std::string> answers;               // the arguments of all submissions
  Image canvas;

  const Json& Robot(const std::string& name = "s1r") const {
    return *report.Find("robots")->Find(name);
  }
  std::int64_t Contacts(const std::string& name = "s1r") const {
    return Robot(name).Find("contacts")->AsInt();
  }
  double Distance(const std::string& name = "s1r") const {
    return Robot(name).Find("distance")->AsDouble();
  }
};

TaskOutcome Drive(const std::string& program, const std::string& scenario, double seconds) {
  const TemporaryFolder folder;
  const std::string report = folder.path() + "/report.json";
  const std::string record = folder.path() + "/run.mcap";
  Simulator simulator({scenario, "--pace", "lockstep", "--report", report, "--record", record,
                       "--hash-every", "1000", "--out", folder.path()});
  const Finished driven =
      RunToEnd({BuiltProgram(program), "--port", std::to_string(simulator.port()), "--seconds",
                std::to_string(seconds), "--save", "canvas"},
               std::chrono::seconds(120));
  EXPECT_EQ(driven.status, 0) << driven.output;
  simulator.process().Signal(2);
  EXPECT_EQ(simulator.process().Wait(), 0) << simulator.process().output();
  TaskOutcome outcome;
  outcome.report = Json::Parse(ReadFile(report));
  outcome.canvas = ReadPng(folder.path() + "/canvas.png");
  for (const RecordedMessage& message : ReadMessages(record)) {
    if (message.topic == "/tf") {
      const Json transforms = Json::Parse(message.data);
      for (const Json& one : transforms.Find("transforms")->AsArray()) {
        const Json& at = *one.Find("translation");
        outcome.ways[one.Find("child_frame_id")->AsString()].push_back(
            {at.Find("x")->AsDouble(), at.Find("y")->AsDouble()});
      }
    } else if (message.topic == "/input") {
      const Json input = Json::Parse(message.data);
      if (input.Find("service")->AsString() == "submit") {
        outcome.answers.push_back(input.Find("arguments")->AsString());
      }
    }
  }
  return outcome;
}

int Count(const Image& image, Color color) {
  return static_cast<int>(std::count(image.pixels.begin(), image.pixels.end(), color));
}

constexpr Color kGreen{0, 255, 0};
constexpr Color kMagenta{255, 0, 255};
constexpr Color kOrange{255, 165, 0};

// --- The introduction

// A scenario file with a start somewhere that is free, at least 12 cm from walls, and noise.
std::string RandomStart(const std::string& folder, unsigned seed) {
  const std::string file = kCourses + "par/intro/scenario.json";
  const Floor middles = ReachableMiddles(scene::LoadScenario(file).world);
  std::mt19937 random(seed);
  const auto share = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  std::size_t start = 0;
  for (bool found = false; !found;) {
    start = random() % middles.size();
    found = middles[start] != 0;
    for (const std::size_t step : {std::size_t{1}, std::size_t{kFloorWidth}}) {
      found = found && middles[start - step] != 0 && middles[start + step] != 0;
    }
  }
  Json scenario = Json::Parse(ReadFile(file));
  const double x = (static_cast<double>(start % kFloorWidth) + 0.5) * kFloorCell;
  const double y = (static_cast<double>(start / kFloorWidth) + 0.5) * kFloorCell;
  const std::string robots = R"([{"name": "s1r", "laser": {"range_std": 0.005}, "pose": {"x": )" +
                             std::to_string(x) + R"(, "y": )" + std::to_string(y) + R"(, "yaw": )" +
                             std::to_string(6.2831 * share()) + "}}]";
  const std::string path = folder + "/scene.json";
  std::ofstream(path) << R"({"world": "syrotek", "obstacles": )" +
                             scenario.Find("obstacles")->Dump() + R"(, "seed": )" +
                             std::to_string(seed) + R"(, "robots": )" + robots + "}";
  return path;
}

double Coverage(const std::vector<Vec2>& way) {
  const Floor reachable =
      Reachable(scene::LoadScenario(kCourses + "par/intro/scenario.json").world);
  Floor visited(reachable.size(), 0);
  for (const Vec2& at : way) {
    visited[FloorAt(static_cast<int>(at.x / kFloorCell), static_cast<int>(at.y / kFloorCell))] = 1;
  }
  visited = Grown(visited, 5);
  int all = 0;
  int seen = 0;
  for (std::size_t i = 0; i < reachable.size(); ++i) {
    all += reachable[i];
    seen += reachable[i] != 0 && visited[i] != 0 ? 1 : 0;
  }
  EXPECT_GT(all, 20000);
  return static_cast<double>(seen) / all;
}

class T05 : public ::testing::TestWithParam<const char*> {};
class T06 : public ::testing::TestWithParam<const char*> {};

// CCMORSE_COURSE_SEEDS=20 measures what the README of the task says.
TEST_P(T05, FiveMinutesWithoutContactAndMostOfTheFloorVisited) {
  const char* wanted = std::getenv("CCMORSE_COURSE_SEEDS");
  const unsigned seeds = wanted != nullptr ? static_cast<unsigned>(std::atoi(wanted)) : 2;
  double least = 1.0;
  double mean = 0.0;
  double way = 0.0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const TemporaryFolder folder;
    const TaskOutcome outcome = Drive(GetParam(), RandomStart(folder.path(), seed), 300.0);
    EXPECT_EQ(outcome.Contacts(), 0) << "seed " << seed;
    EXPECT_GT(outcome.report.Find("simulated_s")->AsDouble(), 299.9);
    const double coverage = Coverage(outcome.ways.at("s1r"));
    EXPECT_GE(coverage, 0.60) << "seed " << seed;
    least = std::min(least, coverage);
    mean += coverage / seeds;
    way += outcome.Distance() / seeds;
  }
  std::cout << GetParam() << ": " << seeds << " starts, coverage at least " << 100 * least
            << " %, mean " << 100 * mean << " %, way " << way << " m\n";
}

// Figure 4.8: the green line, and the robot's position.
TEST_P(T06, CanvasShowsTheWayInGreenAndThePositionInMagenta) {
  const TaskOutcome outcome = Drive(GetParam(), kCourses + "par/intro/scenario.json", 60.0);
  EXPECT_EQ(outcome.Contacts(), 0);
  EXPECT_GT(Count(outcome.canvas, kGreen), 300);
  EXPECT_EQ(Count(outcome.canvas, kMagenta), 1);
}

const auto kIntroSolutions = ::testing::Values("intro-wall-following", "intro-braitenberg");
INSTANTIATE_TEST_SUITE_P(Solutions, T05, kIntroSolutions);
INSTANTIATE_TEST_SUITE_P(Solutions, T06, kIntroSolutions);

// T04: the task's scenario is a file that the builder makes and `ccmorse run` takes as it is.
TEST(T04, EveryTasksScenarioLoads) {
  for (const char* task :
       {"par/intro", "par/planning", "par/exploration", "syrotek/wall_following", "syrotek/pid",
        "syrotek/dead_reckoning", "syrotek/trajectory", "syrotek/two_robots"}) {
    const scene::Scenario scenario = scene::LoadScenario(kCourses + task + "/scenario.json");
    EXPECT_GE(scenario.robots.size(), 1u) << task;
    const TemporaryFolder folder;
    Simulator simulator({kCourses + task + "/scenario.json", "--out", folder.path()});
    simulator.process().Signal(2);
    EXPECT_EQ(simulator.process().Wait(), 0) << task << simulator.process().output();
  }
}

// T02: the same sources, built for the real robot, drive it by Player's protocol: the base takes
// speeds at position2d:0, and :2 only tells where the robot is (specs: syrotek.md A).

// Runs a program to its end; it has to drive more than `least` m and to touch nothing.
void DriveByPlayer(const std::string& program, const std::string& task, double least,
                   const std::vector<std::string>& options) {
  const TemporaryFolder folder;
  const std::string report = folder.path() + "/report.json";
  Simulator simulator({kCourses + task + "/scenario.json", "--pace", "lockstep", "--report", report,
                       "--out", folder.path()});
  std::vector<std::string> command = {BuiltProgram(program), "--host", "player://127.0.0.1",
                                      "--port", std::to_string(simulator.player_port())};
  command.insert(command.end(), options.begin(), options.end());
  const Finished driven = RunToEnd(command, std::chrono::seconds(120));
  EXPECT_EQ(driven.status, 0) << driven.output;
  simulator.process().Signal(2);
  EXPECT_EQ(simulator.process().Wait(), 0) << simulator.process().output();
  const Json robots = *Json::Parse(ReadFile(report)).Find("robots");
  EXPECT_GT(robots.Find("s1r")->Find("distance")->AsDouble(), least) << driven.output;
  EXPECT_EQ(robots.Find("s1r")->Find("contacts")->AsInt(), 0) << driven.output;
}

class T02 : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(T02, TheProgramForTheRealRobotDrivesItByPlayersProtocol) {
  DriveByPlayer(GetParam().first, GetParam().second, 1.0, {"--seconds", "20"});
}

INSTANTIATE_TEST_SUITE_P(
    Solutions, T02,
    ::testing::Values(std::pair("intro-wall-following-syrotek", "par/intro"),
                      std::pair("intro-braitenberg-syrotek", "par/intro"),
                      std::pair("explorer-nearest-frontier-syrotek", "par/exploration"),
                      std::pair("wall-following-pd-syrotek", "syrotek/wall_following"),
                      std::pair("dead-reckoning-calibrated-syrotek", "syrotek/dead_reckoning"),
                      std::pair("pid-tuned-syrotek", "syrotek/pid"),
                      std::pair("trajectory-kanayama-syrotek", "syrotek/trajectory")),
    [](const auto& each) {
      std::string name = each.param.first;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

// On the real robot SND is a driver of the server: position2d:1.
TEST(T02Planner, DrivesTheRealRobotToItsGoalByPlayersProtocol) {
  DriveByPlayer("planner-dijkstra-syrotek", "par/planning", 5.0,
                {"--map", kCourses + "par/planning/maps/arena.txt", "--drive"});
}

// T15: two implementations of each task of the course.
TEST(T15, ThereAreTwoSolutionsOfEachTask) {
  for (const char* program :
       {"intro-wall-following", "intro-braitenberg", "planner-dijkstra", "planner-theta-star",
        "explorer-nearest-frontier", "explorer-information-gain"}) {
    const Finished help = RunToEnd({BuiltProgram(program), "--help"});
    EXPECT_EQ(help.status, 0) << program;
    EXPECT_NE(help.output.find("--port"), std::string::npos) << program;
  }
}

// --- Templates

struct Template {
  const char* program;
  const char* task;
  double farthest;  // m that it drives as it is, at most
};

void PrintTo(const Template& one, std::ostream* out) { *out << one.program; }

class T01 : public ::testing::TestWithParam<Template> {};

TEST_P(T01, TemplateStartsAndTouchesNothing) {
  const std::string scenario = kCourses + GetParam().task + "/scenario.json";
  const TaskOutcome outcome = Drive(GetParam().program, scenario, 10.0);
  for (const auto& [robot, way] : outcome.ways) {
    EXPECT_EQ(outcome.Contacts(robot), 0) << robot;
    EXPECT_LE(outcome.Distance(robot), GetParam().farthest) << robot;
    EXPECT_GT(way.size(), 20u) << robot;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Tasks, T01,
    ::testing::Values(Template{"intro-template", "par/intro", 1.1},
                      Template{"wall-following-template", "syrotek/wall_following", 1.1},
                      Template{"pid-template", "syrotek/pid", 1.6},
                      Template{"dead-reckoning-template", "syrotek/dead_reckoning", 0.1},
                      Template{"trajectory-template", "syrotek/trajectory", 1.5},
                      Template{"two-robots-template", "syrotek/two_robots", 1.1}));

// --- Follow-up tasks

std::string Scenario(const std::string& task) {
  return kCourses + "syrotek/" + task + "/scenario.json";
}

double Rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// The distance from the walls of the hall, and from the pillar 73 in it, m.
double FromHallsWalls(const Vec2& at) {
  const double walls = std::min({at.x - 0.36, 2.88 - at.x, at.y - 1.64, 3.16 - at.y});
  const double dx = std::max(std::fabs(at.x - 2.40) - 0.08, 0.0);
  const double dy = std::max(std::fabs(at.y - 2.94) - 0.08, 0.0);
  return std::min(walls, std::hypot(dx, dy));
}

TEST(CourseTasks, WallFollowingKeepsItsDistanceAllTheWayRound) {
  const TaskOutcome outcome = Drive("wall-following-pd", Scenario("wall_following"), 60.0);
  EXPECT_EQ(outcome.Contacts(), 0);
  EXPECT_GT(outcome.Distance(), 9.0);
  std::vector<double> errors;
  const std::vector<Vec2>& way = outcome.ways.at("s1r");
  for (std::size_t i = 60; i < way.size(); ++i) errors.push_back(FromHallsWalls(way[i]) - 0.25);
  EXPECT_GT(errors.size(), 500u);
  EXPECT_LT(Rms(errors), 0.045);
  EXPECT_GT(Count(outcome.canvas, kGreen), 200);
}

// The line's y at an x of the PID task.
double Line(const Vec2& at) { return at.x < 1.4 ? 2.1 : 2.3; }

TEST(CourseTasks, PidBringsTheWornRobotToBothLines) {
  const TaskOutcome outcome = Drive("pid-tuned", Scenario("pid"), 0.0);
  EXPECT_EQ(outcome.Contacts(), 0);
  std::vector<double> late;
  double beyond = 0.0;
  for (const Vec2& at : outcome.ways.at("s1r")) {
    if (at.x > 2.2) late.push_back(at.y - Line(at));
    beyond = std::max(beyond, at.y - 2.3);
  }
  ASSERT_GT(late.size(), 10u);
  EXPECT_LT(Rms(late), 0.015);
  EXPECT_LT(beyond, 0.05);
}

TEST(CourseTasks, PidsTemplateLeavesTheLine) {
  const TaskOutcome outcome = Drive("pid-template", Scenario("pid"), 8.0);
  EXPECT_LT(outcome.ways.at("s1r").back().y, 1.95);
}

TEST(CourseTasks, DeadReckoningKnowsWhereItIsAfterTwoRounds) {
  for (const char* seed : {"1", "2", "3"}) {
    const TemporaryFolder folder;
    std::string text = ReadFile(Scenario("dead_reckoning"));
    text.insert(text.find('{') + 1, std::string("\"seed\": ") + seed + ",");
    const std::string scenario = folder.path() + "/scene.json";
    std::ofstream(scenario) << text;
    const TaskOutcome outcome = Drive("dead-reckoning-calibrated", scenario, 0.0);
    EXPECT_EQ(outcome.Contacts(), 0);
    EXPECT_GT(outcome.Distance(), 8.5);
    ASSERT_EQ(outcome.answers.size(), 1u);
    const Json arguments = Json::Parse(outcome.answers[0]);
    EXPECT_EQ(arguments.AsArray()[0].AsString(), "pose");
    const auto& pose = arguments.AsArray()[1].AsArray();
    const Vec2 truth = outcome.ways.at("s1r").back();
    const double error = std::hypot(pose[0].AsDouble() - truth.x, pose[1].AsDouble() - truth.y);
    EXPECT_LT(error, 0.06) << "seed " << seed;
    EXPECT_LT(std::hypot(truth.x - 0.90, truth.y - 2.00), 0.08) << "seed " << seed;
  }
}

TEST(CourseTasks, TrajectoryIsFollowedWithinTwoCentimetres) {
  const TaskOutcome outcome = Drive("trajectory-kanayama", Scenario("trajectory"), 0.0);
  EXPECT_EQ(outcome.Contacts(), 0);
  const std::vector<Vec2>& way = outcome.ways.at("s1r");
  ASSERT_GT(way.size(), 590u);
  std::vector<double> errors;
  for (std::size_t i = 60; i < 590; ++i) {
    // Where the robot should be at that moment, not only on the line.
    const double angle = 2 * M_PI / 60.0 * (static_cast<double>(i) / 10.0);
    errors.push_back(std::hypot(1.62 + 0.9 * std::sin(angle) - way[i].x,
                                2.40 + 0.4 * std::sin(2 * angle) - way[i].y));
  }
  EXPECT_LT(Rms(errors), 0.025);
  EXPECT_GT(Count(outcome.canvas, kGreen) + Count(outcome.canvas, kOrange), 200);
}

TEST(CourseTasks, TwoRobotsChangePlacesAndKeepClear) {
  const TaskOutcome outcome = Drive("two-robots-keep-right", Scenario("two_robots"), 0.0);
  double nearest = 10.0;
  const std::vector<Vec2>& one = outcome.ways.at("s1r_1");
  const std::vector<Vec2>& other = outcome.ways.at("s1r_2");
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
    nearest = std::min(nearest, std::hypot(one[i].x - other[i].x, one[i].y - other[i].y));
  }
  EXPECT_EQ(outcome.Contacts("s1r_1") + outcome.Contacts("s1r_2"), 0);
  EXPECT_GT(nearest, 2 * 0.098 + 0.03);  // middle to middle; 0.098 m is the circle around each
  EXPECT_LT(std::hypot(one.back().x - 2.54, one.back().y - 2.40), 0.05);
  EXPECT_LT(std::hypot(other.back().x - 0.70, other.back().y - 2.40), 0.05);
}

}  // namespace
}  // namespace ccmorse::testing
