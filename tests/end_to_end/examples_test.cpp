// The programs of examples/player, each against `ccmorse run` as a Player server and in process.

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "tests/support/process.h"

namespace ccmorse {
namespace {

using testing::BuiltProgram;
using testing::Finished;
using testing::RunToEnd;
using testing::Simulator;
using testing::TemporaryFile;
using testing::TemporaryFolder;

// What a program printed, and what the simulator tells of its robots.
struct Outcome {
  std::string output;
  Json robots;
};

class Examples : public ::testing::TestWithParam<const char*> {
 protected:
  // Runs an example in lock-step on a robot of a scenario.
  Outcome Run(const std::string& program, const std::vector<std::string>& arguments,
              const std::string& scenario = "syrotek") {
    const TemporaryFolder folder;
    const std::string report = folder.path() + "/report.json";
    std::vector<std::string> command = {BuiltProgram("example_" + program)};
    const auto add = [&] { command.insert(command.end(), arguments.begin(), arguments.end()); };
    Finished finished;
    if (std::string(GetParam()) == "player") {
      Simulator simulator({scenario, "--pace", "lockstep", "--headless", "--report", report});
      command.push_back("player://127.0.0.1");
      command.push_back(std::to_string(simulator.player_port()));
      add();
      finished = RunToEnd(command);
      simulator.process().Signal(SIGTERM);
      EXPECT_EQ(simulator.process().Wait(), 0);
    } else {
      command.push_back("sim:" + scenario + "?pace=lockstep&report=" + report +
                        (std::string(GetParam()) == "sim" ? "" : "&protocol=player"));
      command.emplace_back("0");
      add();
      finished = RunToEnd(command);
    }
    EXPECT_EQ(finished.status, 0) << finished.output;
    return {finished.output, *Json::Parse(ReadFile(report)).Find("robots")};
  }

  bool simulator() const { return std::string(GetParam()) == "sim"; }
};

// The robot of an outcome drove at least so far, m, and touched nothing.
void ExpectDriven(const Outcome& outcome, double least, const std::string& robot = "s1r") {
  const Json& tally = *outcome.robots.Find(robot);
  EXPECT_GT(tally.Find("distance")->AsDouble(), least) << outcome.output;
  EXPECT_EQ(tally.Find("contacts")->AsDouble(), 0.0) << outcome.output;
  EXPECT_EQ(tally.Find("stalled")->AsDouble(), 0.0) << outcome.output;
}

std::vector<double> PoseIn(const Outcome& outcome, const std::string& robot = "s1r") {
  std::vector<double> pose;
  for (const Json& number : outcome.robots.Find(robot)->Find("pose")->AsArray()) {
    pose.push_back(number.AsDouble());
  }
  return pose;
}

TEST_P(Examples, HelloPrintsPoseAndScan) {
  const Outcome outcome = Run("hello", {});
  EXPECT_NE(outcome.output.find("#Position2D (4:0)"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("682 beams, ahead 0.57824 m"), std::string::npos) << outcome.output;
}

TEST_P(Examples, WanderDrivesAboutWithoutAContact) {
  const Outcome outcome = Run("wander", {"30"});
  ExpectDriven(outcome, 2.0);
  EXPECT_NE(outcome.output.find("ended at "), std::string::npos) << outcome.output;
}

TEST_P(Examples, WallFollowDrivesAlongWithoutAContact) {
  ExpectDriven(Run("wall_follow", {"30"}), 3.0);
}

TEST_P(Examples, GotoSndReachesItsGoals) {
  // A simulator's own position control (index 0) knows no obstacles: places in sight of each other.
  const Outcome outcome = simulator() ? Run("goto_snd", {"0", "1.6", "2.0", "1.3", "2.1"})
                                      : Run("goto_snd", {"1", "0.9", "2.9", "1.65", "2.2"});
  ExpectDriven(outcome, 0.4);
  const std::vector<double> pose = PoseIn(outcome);
  EXPECT_NEAR(pose[0], simulator() ? 1.3 : 1.65, 0.15);
  EXPECT_NEAR(pose[1], simulator() ? 2.1 : 2.2, 0.15);
  EXPECT_NE(outcome.output.find("at "), outcome.output.rfind("at ")) << outcome.output;
}

TEST_P(Examples, MapViewerShowsTheArenasWalls) {
  if (simulator()) {
    const Finished refused =
        RunToEnd({BuiltProgram("example_map_viewer"), "sim:syrotek?pace=lockstep", "0"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.output.find("the simulation has no map"), std::string::npos)
        << refused.output;
    return;
  }
  std::istringstream lines(Run("map_viewer", {}).output);
  std::string size;
  std::getline(lines, size);
  EXPECT_EQ(size, "171 x 186 cells of 0.02 m, from 0, 0");
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  ASSERT_EQ(rows.size(), 31U);
  const std::string wall(57, '#');
  EXPECT_EQ(rows.front(), wall);
  EXPECT_EQ(rows.back(), wall);
  for (const std::string& row : rows) {
    ASSERT_EQ(row.size(), 57U);
    EXPECT_EQ(row.front(), '#');
    EXPECT_EQ(row.back(), '#');
  }
  EXPECT_EQ(rows[3].find_first_not_of('.', 1), 56U);  // a free corridor
}

TEST_P(Examples, MultiRobotTurnsEachOfTheRobots) {
  // A thread that reads two servers in turn cannot do so in lock-step (docs/player.md), so a server
  // a robot goes by the clock, a fast one.
  const TemporaryFile scene(".json", R"({"world": "syrotek", "time": {"factor": 4}, "robots": [
    {"name": "a", "pose": {"x": 1.2, "y": 2.0}}, {"name": "b", "pose": {"x": 2.2, "y": 2.6},
     "proxies": {"position2d": {"10": "pose", "12": "pose", "13": "odometry"}, "laser": {"10": "hokuyo"}}}]})");
  Outcome outcome;
  if (std::string(GetParam()) == "player") {
    const TemporaryFolder folder;
    const std::string report = folder.path() + "/report.json";
    Simulator server({scene.path(), "--headless", "--report", report});
    std::vector<std::string> command = {BuiltProgram("example_multi_robot")};
    for (int i = 0; i < 2; ++i) {
      const std::string key = "Player on 127.0.0.1 port ";
      const auto line = server.process().WaitForLine(key);
      command.emplace_back("127.0.0.1");
      command.push_back(line ? std::to_string(std::atoi(line->c_str() + key.size())) : "");
    }
    const Finished finished = RunToEnd(command);
    EXPECT_EQ(finished.status, 0) << finished.output;
    server.process().Signal(SIGTERM);
    EXPECT_EQ(server.process().Wait(), 0);
    outcome = {finished.output, *Json::Parse(ReadFile(report)).Find("robots")};
  } else {
    const TemporaryFolder folder;
    const std::string report = folder.path() + "/report.json";
    std::string address = "sim:" + scene.path() + "?report=" + report;
    std::vector<std::string> command = {BuiltProgram("example_multi_robot")};
    if (simulator()) {
      command.insert(command.end(), {address + "&pace=lockstep", "0"});
    } else {
      for (const char* robot : {"a", "b"}) {
        command.insert(command.end(), {address + "&protocol=player&robot=" + robot, "0"});
      }
    }
    const Finished finished = RunToEnd(command);
    EXPECT_EQ(finished.status, 0) << finished.output;
    outcome = {finished.output, *Json::Parse(ReadFile(report)).Find("robots")};
  }
  // Three devices of a robot, each turned by ten rounds at 45 degrees a second.
  for (const char* robot : {"a", "b"}) {
    const std::vector<double> pose = PoseIn(outcome, robot);
    EXPECT_GT(std::abs(pose[2]), 0.5) << robot << "\n" << outcome.output;
    EXPECT_NEAR(pose[0], robot[0] == 'a' ? 1.2 : 2.2, 1e-9);
    EXPECT_EQ(outcome.robots.Find(robot)->Find("contacts")->AsDouble(), 0.0);
  }
  std::size_t turned = 0;
  for (std::size_t at = 0; (at = outcome.output.find("turned to", at)) != std::string::npos; ++at) {
    ++turned;
  }
  EXPECT_EQ(turned, 6U) << outcome.output;
}

INSTANTIATE_TEST_SUITE_P(EachAddress, Examples, ::testing::Values("player", "sim", "sim_player"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace ccmorse
