// The `ccmorse` program as a user meets it.

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <memory>
#include <set>
#include <sstream>

#include "base/error.h"
#include "base/image.h"
#include "base/json.h"
#include "tests/support/line_client.h"
#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

Finished RunScenario(const std::string& scenario) {
  return RunToEnd({kCcmorse, "run", scenario, "--pace", "max", "--for", "0.1", "--port", "0",
                   "--stream-port", "0"});
}

// One line on stderr that says `what`, and a status that says failure.
void ExpectOneLine(const Finished& run, const std::vector<std::string>& what) {
  EXPECT_NE(run.status, 0);
  EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
  for (const std::string& part : what) {
    EXPECT_NE(run.output.find(part), std::string::npos) << run.output;
  }
}

TEST(CommandLine, VersionAndHelpWithExamples) {
  EXPECT_EQ(RunToEnd({kCcmorse, "--version"}).output, "ccmorse 0.1.0\n");
  const Finished help = RunToEnd({kCcmorse, "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.output.find("Examples:\n  ccmorse run syrotek"), std::string::npos) << help.output;
  EXPECT_NE(RunToEnd({kCcmorse, "run", "--help"}).output.find("--pace"), std::string::npos);
}

TEST(CommandLine, AnUnknownScenarioIsNamedWithTheNearest) {
  ExpectOneLine(RunScenario("syrotk"), {"syrotk", "did you mean 'syrotek'?", "course_map"});
}

TEST(CommandLine, BadJsonIsNamedWithItsLine) {
  const TemporaryFile file(".json", "{\n  \"robots\": [\n}");
  ExpectOneLine(RunScenario(file.path()), {file.path() + ":3"});
}

TEST(CommandLine, AnUnknownKeyIsNamedWithItsLineAndTheNearest) {
  const TemporaryFile file(".json", "{\n  \"robtos\": []\n}");
  ExpectOneLine(RunScenario(file.path()), {file.path() + ":2", "robtos", "robots"});
}

TEST(CommandLine, APortInUseIsNamed) {
  Simulator first({"syrotek"});
  const std::string port = std::to_string(first.port());
  ExpectOneLine(RunToEnd({kCcmorse, "run", "syrotek", "--port", port}), {port, "in use"});
}

TEST(S20, TwoRobotsOfOneNameAreRefused) {
  const TemporaryFile file(".json",
                           "{\"robots\": [\n{\"name\": \"a\", \"pose\": {\"x\": 1, \"y\": 2.4}},\n"
                           "{\"name\": \"a\", \"pose\": {\"x\": 2, \"y\": 2.4}}]}");
  ExpectOneLine(RunScenario(file.path()), {"'a'", ":3"});
}

TEST(C02, AnEmptyScenarioRuns) {
  const TemporaryFile file(".json", "{}");
  const Finished run = RunScenario(file.path());
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_NE(run.output.find("state hash"), std::string::npos);
}

TEST(C01, EditingTheFileChangesTheSimulation) {
  for (const double x : {1.0, 1.5}) {
    const TemporaryFile file(
        ".json", "{\"robots\": [{\"pose\": {\"x\": " + std::to_string(x) + ", \"y\": 2.4}}]}");
    Simulator simulator({file.path()});
    LineClient client(simulator.port());
    const std::string reply = client.Ask("1 s1r.pose get_local_data");
    EXPECT_NEAR(Json::Parse(reply.substr(reply.find('{'))).Find("x")->AsDouble(), x, 1e-9);
  }
}

TEST(C08, TheScenarioChoosesTheTimeStrategyAndTheCommandLineOverrulesIt) {
  const TemporaryFile file(".json", "{\"time\": {\"strategy\": \"lockstep\"}}");
  Simulator asked({file.path()});
  EXPECT_NE(LineClient(asked.port()).Ask("1 ccmorse hello []").find("\"pace\": \"lockstep\""),
            std::string::npos);
  Simulator overruled({file.path(), "--pace", "real"});
  EXPECT_NE(LineClient(overruled.port()).Ask("1 ccmorse hello []").find("\"pace\": \"realtime\""),
            std::string::npos);
}

TEST(CommandLine, CtrlCEndsARunWithItsReport) {
  Simulator simulator({"syrotek"});
  simulator.process().Signal(SIGINT);
  EXPECT_EQ(simulator.process().Wait(), 0);
  EXPECT_NE(simulator.process().output().find("state hash"), std::string::npos);
  EXPECT_NE(simulator.process().output().find("EXITING SIMULATION"), std::string::npos);
}

// So that a run whose program has left gives the same hash whoever was faster.
TEST(CommandLine, SigtermInLockstepEndsTheRunAfterWhatItsClientsHaveSent) {
  constexpr int kClients = 100;
  Simulator simulator({"course_map", "--pace", "lockstep"});
  std::vector<std::unique_ptr<LineClient>> clients;
  // All of this is there when it wakes up: connections, requests and the signal.
  simulator.process().Signal(SIGSTOP);
  for (int i = 0; i < kClients; ++i) {
    clients.push_back(std::make_unique<LineClient>(simulator.port()));
    clients.back()->Send("1 simulation list_robots\n");
  }
  simulator.process().Signal(SIGTERM);
  simulator.process().Signal(SIGCONT);
  for (const auto& client : clients) {
    EXPECT_EQ(client->ReadLine(), "1 SUCCESS [\"s1r\"]");
  }
  clients.clear();
  EXPECT_EQ(simulator.process().Wait(), 0);
}

TEST(CommandLine, SigtermInLockstepDoesNotWaitLongForAClientThatStays) {
  Simulator simulator({"course_map", "--pace", "lockstep"});
  const LineClient client(simulator.port());
  simulator.process().Signal(SIGTERM);
  EXPECT_EQ(simulator.process().Wait(), 0);
}

TEST(CommandLine, TheReportIsJson) {
  const TemporaryFolder folder;
  const std::string report = folder.path() + "/new/report.json";
  const Finished run = RunToEnd({kCcmorse, "run", "docks", "--pace", "max", "--for", "2", "--port",
                                 "0", "--stream-port", "0", "--report", report});
  EXPECT_EQ(run.status, 0) << run.output;
  const Json parsed = Json::Parse(ReadFile(report));
  EXPECT_EQ(parsed.Find("ticks")->AsInt(), 120);
  EXPECT_EQ(parsed.Find("robots")->AsObject().size(), 13U);
}

TEST(CommandLine, AReportThatCannotBeWrittenIsSaidBeforeTheRun) {
  for (const char* option : {"--report", "--picture"}) {
    const Finished run = RunToEnd({kCcmorse, "run", "syrotek", "--pace", "max", "--port", "0",
                                   "--stream-port", "0", option, "/proc/no/such/file"});
    ExpectOneLine(run, {"/proc/no/such/file"});
  }
}

TEST(CommandLine, NumbersThatMakeNoSenseAreRefused) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--for", "nan"},
                                                {"--seed", "-1"},
                                                {"--seed", "99999999999999999999"},
                                                {"--port", "70000"},
                                                {"--clients", "0"}}) {
    std::vector<std::string> command = {kCcmorse, "run", "syrotek", "--pace", "max", "--for", "1"};
    command.insert(command.end(), words.begin(), words.end());
    EXPECT_NE(RunToEnd(command).status, 0) << words[0] << " " << words[1];
  }
}

TEST(CommandLine, TheFleetBenchmarkIsRepeatable) {
  const auto hash = [](const std::string& text) {
    return Json::Parse(text).Find("hash")->AsString();
  };
  const std::vector<std::string> command = {kCcmorse, "bench",     "fleet", "--robots",
                                            "20",     "--seconds", "5",     "--json"};
  const Finished first = RunToEnd(command);
  ASSERT_EQ(first.status, 0) << first.output;
  EXPECT_EQ(Json::Parse(first.output).Find("contacts")->AsInt(), 0);
  EXPECT_EQ(hash(first.output), hash(RunToEnd(command).output));
}

// How fast it is, is no test's business; that each row has its figure is.
TEST(CommandLine, BenchAllMeasuresItsRows) {
  const Finished run = RunToEnd({kCcmorse, "bench", "all", "--seconds", "0.05", "--json"});
  ASSERT_EQ(run.status, 0) << run.output;
  const Json table = Json::Parse(run.output.substr(run.output.find('{')));
  int fleets = 0;
  for (const Json& row : table.Find("rows")->AsArray()) {
    const std::string& what = row.Find("what")->AsString();
    if (!what.starts_with("fleet") && !what.starts_with("planar")) continue;
    ++fleets;
    EXPECT_GT(row.Find("measured")->AsDouble(), 0.0) << what;
    EXPECT_EQ(row.Find("met")->AsBool(),
              row.Find("measured")->AsDouble() >= row.Find("required")->AsDouble());
  }
  EXPECT_EQ(fleets, 6);
}

TEST(CommandLine, RenderMakesAPictureOfAScenarioAndOfARecord) {
  const TemporaryFile picture(".png", "");
  const TemporaryFile record(".mcap", "");
  const Finished run =
      RunToEnd({kCcmorse, "run", "syrotek", "--headless", "--port", "0", "--stream-port", "0",
                "--pace", "max", "--for", "1", "--record", record.path()});
  ASSERT_EQ(run.status, 0) << run.output;
  for (const std::string& what : {std::string("syrotek"), record.path()}) {
    const Finished rendered = RunToEnd({kCcmorse, "render", what, "-o", picture.path(), "--size",
                                        "96x54", "--samples", "1", "--camera", "follow:s1r"});
    ASSERT_EQ(rendered.status, 0) << rendered.output;
    EXPECT_NE(rendered.output.find(what == "syrotek" ? "at 0.000 s" : "at 1.000 s"),
              std::string::npos)
        << rendered.output;
    const Image image = ReadPng(picture.path());
    EXPECT_EQ(image.width, 96);
    EXPECT_EQ(image.height, 54);
    std::set<int> greys;
    for (const Color& color : image.pixels) greys.insert(color.g);
    EXPECT_GT(greys.size(), 30U);
  }
}

TEST(CommandLine, RenderSaysWhatItDoesNotUnderstand) {
  const auto output = [](const std::vector<std::string>& more) {
    std::vector<std::string> command = {kCcmorse, "render", "syrotek"};
    command.insert(command.end(), more.begin(), more.end());
    const Finished run = RunToEnd(command);
    EXPECT_NE(run.status, 0);
    return run.output;
  };
  EXPECT_NE(output({"--camera", "behind"}).find("follow:NAME"), std::string::npos);
  EXPECT_NE(output({"--size", "wide"}).find("1280x720"), std::string::npos);
  EXPECT_NE(output({"--size", "0x9"}).find("width is 1 to 8192"), std::string::npos);
  EXPECT_NE(output({"--at", "1", "2", "3"}).find("--from"), std::string::npos);
}

const std::string kWorlds = CCMORSE_SOURCE_DIR "/tests/worlds/";

TEST(CommandLine, AWorldOfStageAndACfgOfPlayerRun) {
  for (const char* const file : {"hall.world", "course.cfg"}) {
    const Finished run = RunScenario(kWorlds + file);
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_NE(run.output.find("\nr0 "), std::string::npos) << run.output;
  }
}

TEST(CommandLine, WhatAWorldHasAndCcmorseHasNotIsNamed) {
  const Finished run = RunScenario(kWorlds + "devices.cfg");
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.output.find("devices.world:11: fiducial"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("devices.cfg:6: gripper:0"), std::string::npos) << run.output;
}

TEST(CommandLine, AConvertedWorldRunsTheSame) {
  const TemporaryFile scene(".json", "");
  const Finished converted =
      RunToEnd({kCcmorse, "convert", kWorlds + "fleet.cfg", "-o", scene.path()});
  EXPECT_EQ(converted.status, 0) << converted.output;
  const auto hash = [](const Finished& run) {
    const std::size_t at = run.output.find("state hash");
    return at == std::string::npos ? run.output : run.output.substr(at, 29);
  };
  EXPECT_EQ(hash(RunScenario(scene.path())), hash(RunScenario(kWorlds + "fleet.cfg")));
  ExpectOneLine(RunToEnd({kCcmorse, "convert", "no.world"}), {"no.world"});
}

TEST(W11, ThirteenRobotsRunFromTheirDocks) { EXPECT_EQ(RunScenario("docks").status, 0); }

TEST(CommandLine, EveryListedScenarioRuns) {
  const Finished list = RunToEnd({kCcmorse, "list"});
  std::istringstream names(list.output);
  int count = 0;
  for (std::string name; std::getline(names, name); ++count) {
    EXPECT_EQ(RunScenario(name).status, 0) << name;
  }
  EXPECT_GE(count, 4);
}

}  // namespace
}  // namespace ccmorse::testing
