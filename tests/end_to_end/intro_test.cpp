// The course's introduction program, the simulator and the picture: what ./demo shows.

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>

#include <regex>

#include "base/error.h"
#include "base/image.h"
#include "base/json.h"
#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

struct IntroRun {
  Json report;
  Image picture;
  std::string program;
  int status = -1;
};

// Replays a record; it must come out as it was.
void ExpectVerified(const std::string& record) {
  const Finished verify = RunToEnd({BuiltProgram("ccmorse"), "replay", record, "--verify"});
  EXPECT_EQ(verify.status, 0) << verify.output;
}

IntroRun RunIntro(const std::string& scenario, double seconds) {
  const TemporaryFolder folder;
  const std::string report = folder.path() + "/report.json";
  const std::string picture = folder.path() + "/picture.png";
  const std::string record = folder.path() + "/run.mcap";
  Simulator simulator({scenario, "--pace", "lockstep", "--for", std::to_string(seconds), "--report",
                       report, "--picture", picture, "--record", record});
  const Finished intro = RunToEnd(
      {BuiltProgram("intro"), "--host", "localhost", "--port", std::to_string(simulator.port())});
  EXPECT_EQ(simulator.process().Wait(), 0) << simulator.process().output();
  ExpectVerified(record);
  return {Json::Parse(ReadFile(report)), ReadPng(picture), intro.output, intro.status};
}

TEST(T06, TheIntroductionProgramDrivesAroundTheArenaWithoutContact) {
  const IntroRun outcome = RunIntro("syrotek", 120);
  EXPECT_EQ(outcome.status, 0) << outcome.program;
  const Json& robot = *outcome.report.Find("robots")->Find("s1r");
  EXPECT_EQ(robot.Find("contacts")->AsInt(), 0);
  EXPECT_GT(robot.Find("distance")->AsDouble(), 20.0);
  EXPECT_EQ(robot.Find("scans")->AsInt(), 1200);
  EXPECT_EQ(robot.Find("scans_used")->AsInt(), 1200);
  int green = 0;
  for (const Color color : outcome.picture.pixels) {
    green += color.g > 200 && color.r < 100 && color.b < 100 ? 1 : 0;
  }
  EXPECT_GT(green, 2000);
}

TEST(T06, TheReadmesPictureIsTheOneThatTheDemoMakes) {
  const Image made = RunIntro("syrotek", 120).picture;
  const Image shown = ReadPng(std::string(CCMORSE_SOURCE_DIR) + "/docs/images/intro.png");
  EXPECT_EQ(made.width, shown.width);
  EXPECT_EQ(made.pixels, shown.pixels);
}

TEST(Determinism, TwoRunsOverTcpAreEqualBitForBit) {
  const IntroRun first = RunIntro("course_map", 60);
  const IntroRun second = RunIntro("course_map", 60);
  EXPECT_EQ(*first.report.Find("hash"), *second.report.Find("hash"));
  EXPECT_EQ(first.picture.pixels, second.picture.pixels);
}

TEST(Determinism, TwoProgramsInLockstepAreEqualWhenTimeWaitsForBoth) {
  const auto run = [] {
    const TemporaryFolder folder;
    const std::string report = folder.path() + "/report.json";
    const std::string record = folder.path() + "/run.mcap";
    Simulator simulator({"two_robots", "--pace", "lockstep", "--for", "20", "--clients", "2",
                         "--report", report, "--record", record});
    const std::string port = std::to_string(simulator.port());
    Process one({BuiltProgram("intro"), "--port", port});
    Process two(
        {BuiltProgram("intro"), "--port", port, "--laser-index", "10", "--position2d-index", "10"});
    EXPECT_EQ(one.Wait(), 0) << one.output();
    EXPECT_EQ(two.Wait(), 0) << two.output();
    EXPECT_EQ(simulator.process().Wait(), 0);
    ExpectVerified(record);
    return *Json::Parse(ReadFile(report)).Find("hash");
  };
  EXPECT_EQ(run(), run());
}

TEST(X43, TheLogHasTheListingsLines) {
  const IntroRun outcome = RunIntro("course_map", 2);
  const std::string number = R"(-?[0-9.]+(e-?[0-9]+)?)";
  for (const std::string& line : {"POSITION " + number + " " + number + " " + number,
                                  "SPEED " + number + " " + number + " " + number,
                                  "laser " + number + " " + number + " 682"}) {
    EXPECT_TRUE(std::regex_search(outcome.program, std::regex(line))) << line;
  }
}

TEST(X39, TheProgramsDestructorsRunCleanWhenTheServerIsKilled) {
  Simulator simulator({"course_map"});
  Process intro({BuiltProgram("intro"), "--port", std::to_string(simulator.port())});
  ASSERT_TRUE(intro.WaitForLine("POSITION"));
  simulator.process().Signal(SIGKILL);
  const auto status = intro.Wait();
  ASSERT_TRUE(status) << "it hangs";
  EXPECT_EQ(*status, 1) << intro.output();
  EXPECT_NE(intro.output().find("Morse error: "), std::string::npos) << intro.output();
  EXPECT_NE(intro.output().find("function: "), std::string::npos);
}

TEST(X38, CtrlCStopsTheProgramAndTheRobot) {
  Simulator simulator({"course_map"});
  Process intro({BuiltProgram("intro"), "--port", std::to_string(simulator.port())});
  ASSERT_TRUE(intro.WaitForLine("POSITION"));
  intro.Signal(SIGINT);
  EXPECT_EQ(intro.Wait(), 0) << intro.output();
  EXPECT_NE(intro.output().find("Main loop has been left"), std::string::npos) << intro.output();
}

TEST(Intro, WithoutASimulatorItSaysSo) {
  const Finished intro = RunToEnd({BuiltProgram("intro"), "--port", "1"});
  EXPECT_NE(intro.status, 0);
  EXPECT_NE(intro.output.find("localhost"), std::string::npos) << intro.output;
}

}  // namespace
}  // namespace ccmorse::testing
