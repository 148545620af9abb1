// One program, three kinds of address: morse://, player:// and sim:, a simulation within the
// program (issue: Player, both ways; docs/player.md).

#include <dirent.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "libCCMorse/CCMorse.h"
#include "libplayerc++/playerc++.h"
#include "tests/support/process.h"

namespace ccmorse {
namespace {

using CCMorse::MorseClient;
using CCMorse::MorseError;
using testing::BuiltProgram;
using testing::Finished;
using testing::RunToEnd;
using testing::Simulator;
using testing::TemporaryFile;
using testing::TemporaryFolder;
using Clock = std::chrono::steady_clock;

std::string Sim(const std::string& folder, const std::string& options = "") {
  return "sim:syrotek?pace=lockstep&report=" + folder + "/report.json&record=" + folder +
         "/run.mcap" + options;
}

std::string HashIn(const std::string& folder) {
  return Json::Parse(ReadFile(folder + "/report.json")).Find("hash")->AsString();
}

// trace_program's output for an address.
std::string TraceOf(const std::string& address) {
  const Finished finished = RunToEnd({BuiltProgram("trace_program"), address, "30"});
  EXPECT_EQ(finished.status, 0) << finished.output;
  return finished.output;
}

// The same by `ccmorse run`, in lock-step, whose record and report are complete when it returns.
std::string TraceOverTcp(const std::string& scheme, const std::string& folder) {
  Simulator simulator({"syrotek", "--pace", "lockstep", "--headless", "--report",
                       folder + "/report.json", "--record", folder + "/run.mcap"});
  int port = simulator.port();
  if (scheme == "player") port = simulator.player_port();
  const std::string trace = TraceOf(scheme + "://127.0.0.1:" + std::to_string(port));
  simulator.process().Signal(SIGTERM);
  EXPECT_EQ(simulator.process().Wait(), 0);
  return trace;
}

std::vector<std::vector<double>> Numbers(const std::string& trace) {
  std::vector<std::vector<double>> lines;
  std::istringstream in(trace);
  for (std::string line; std::getline(in, line);) {
    std::vector<double>& numbers = lines.emplace_back();
    std::istringstream words(line);
    for (std::string word; words >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
  }
  return lines;
}

TEST(ThreeAddresses, AProgramGoesTheSameWayOverMorsePlayerAndInProcess) {
  const TemporaryFolder of_morse;
  const TemporaryFolder of_player;
  const TemporaryFolder of_sim;
  const std::string morse = TraceOverTcp("morse", of_morse.path());
  const std::string player = TraceOverTcp("player", of_player.path());
  const std::string sim = TraceOf(Sim(of_sim.path()));

  // It is a way worth comparing: data of 30 s at 10 Hz, and metres driven.
  const auto exact = Numbers(sim);
  ASSERT_EQ(exact.size(), 300U) << sim;
  const Json report = Json::Parse(ReadFile(of_sim.path() + "/report.json"));
  EXPECT_GT(report.Find("robots")->Find("s1r")->Find("distance")->AsDouble(), 2.0);

  // In process everything is what it is over TCP, to the last bit; so is what the simulator took in
  // and at which tick, which the record holds.
  EXPECT_EQ(sim, morse);
  EXPECT_EQ(HashIn(of_sim.path()), HashIn(of_morse.path()));
  EXPECT_EQ(ReadFile(of_sim.path() + "/run.mcap"), ReadFile(of_morse.path() + "/run.mcap"));

  // Player's wire carries times and poses as doubles, exactly, and ranges as floats: each is the
  // nearest float to the exact one.
  const auto floats = Numbers(player);
  ASSERT_EQ(floats.size(), exact.size());
  constexpr std::size_t kFirstRange = 6;
  for (std::size_t line = 0; line < exact.size(); ++line) {
    ASSERT_EQ(floats[line].size(), exact[line].size());
    ASSERT_EQ(floats[line].size(), kFirstRange + 22);
    for (std::size_t i = 0; i < exact[line].size(); ++i) {
      const double wanted = i < kFirstRange
                                ? exact[line][i]
                                : static_cast<double>(static_cast<float>(exact[line][i]));
      ASSERT_EQ(floats[line][i], wanted) << "line " << line << ", number " << i;
    }
  }
  EXPECT_EQ(HashIn(of_player.path()), HashIn(of_morse.path()));
}

TEST(ThreeAddresses, PlayersProtocolInProcessIsThatOverTcp) {
  const TemporaryFolder of_player;
  const TemporaryFolder of_sim;
  EXPECT_EQ(TraceOf(Sim(of_sim.path(), "&protocol=player&robot=s1r")),
            TraceOverTcp("player", of_player.path()));
  EXPECT_EQ(ReadFile(of_sim.path() + "/run.mcap"), ReadFile(of_player.path() + "/run.mcap"));
}

TEST(ThreeAddresses, AProgramWithTheUsualAddressBuiltInRunsInProcessByTheEnvironment) {
  const TemporaryFolder folder;
  EXPECT_EQ(::setenv("CCMORSE_HOST", Sim(folder.path()).c_str(), 1), 0);
  const Finished hello = RunToEnd({BuiltProgram("example_hello")});
  const Finished wander = RunToEnd({BuiltProgram("example_wander"), "localhost", "4000", "2"});
  EXPECT_EQ(::unsetenv("CCMORSE_HOST"), 0);
  EXPECT_EQ(hello.status, 0) << hello.output;
  EXPECT_NE(hello.output.find("682 beams"), std::string::npos) << hello.output;
  EXPECT_EQ(wander.status, 0) << wander.output;
}

TEST(ThreeAddresses, TheCoursesProgramRunsInProcess) {
  const TemporaryFolder folder;
  const Finished intro =
      RunToEnd({BuiltProgram("intro"), "--host", Sim(folder.path()), "--seconds", "10"});
  EXPECT_EQ(intro.status, 0) << intro.output;
  const Json robots = *Json::Parse(ReadFile(folder.path() + "/report.json")).Find("robots");
  EXPECT_GT(robots.Find("s1r")->Find("distance")->AsDouble(), 0.5);
  EXPECT_EQ(robots.Find("s1r")->Find("contacts")->AsDouble(), 0.0);
}

// The error that opening an address gives; "" where it gives none.
std::string ErrorOf(const std::string& address) {
  std::string by_player;
  try {
    const PlayerCc::PlayerClient client(address);
  } catch (const PlayerCc::PlayerError& error) {
    by_player = error.GetErrorStr();
  }
  try {
    MorseClient::Share(address);
  } catch (const MorseError& error) {
    EXPECT_EQ(error.GetErrorStr(), by_player);
    return by_player;
  }
  EXPECT_EQ(by_player, "");
  return "";
}

// What `ccmorse run` says of a scenario.
std::string RunError(const std::string& scenario) {
  const Finished finished = RunToEnd({BuiltProgram("ccmorse"), "run", scenario, "--port", "0"});
  EXPECT_EQ(finished.status, 1);
  const std::string begin = "ccmorse: ";
  EXPECT_TRUE(finished.output.starts_with(begin) && finished.output.ends_with("\n"));
  return finished.output.substr(begin.size(), finished.output.size() - begin.size() - 1);
}

TEST(InProcess, ErrorsOfScenariosAreThoseOfCcmorseRun) {
  // A name may be an environment's as well on the command line, so the two are worded differently.
  for (const std::string& error : {ErrorOf("sim:syrotk"), RunError("syrotk")}) {
    EXPECT_NE(error.find("scenario 'syrotk'; did you mean 'syrotek'?"), std::string::npos) << error;
  }
  const TemporaryFile broken(".json", R"({"world": "syrotek", "robts": []})");
  EXPECT_EQ(ErrorOf("sim:" + broken.path()), RunError(broken.path()));
  EXPECT_NE(ErrorOf("sim:" + broken.path()).find(":1: "), std::string::npos);
}

TEST(InProcess, AWrongOptionIsNamedWithWhatItMayBe) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"sim:", "names a scenario"},
      {"sim:?pace=max", "names a scenario"},
      {"sim:syrotek?pac=max", "no option 'pac'; did you mean 'pace'?; there are"},
      {"sim:syrotek?pace=quick", "option pace is 'quick', must be real, lockstep or max"},
      {"sim:syrotek?pace", "option pace has no value"},
      {"sim:syrotek?pace=max&pace=real", "option pace is given twice"},
      {"sim:syrotek?seed=-1", "option seed is '-1', must be a whole number from 0 to"},
      {"sim:syrotek?seed=1.5", "option seed is '1.5'"},
      {"sim:syrotek?threads=0", "option threads is '0', must be a whole number from 1 to 256"},
      {"sim:syrotek?clients=x", "option clients is 'x'"},
      {"sim:syrotek?for=0", "option for is '0', must be a number above 0"},
      {"sim:syrotek?for=nan", "option for is 'nan'"},
      {"sim:syrotek?factor=-2", "option factor is '-2'"},
      {"sim:syrotek?log=all", "option log is 'all', must be off, error, warning or info"},
      {"sim:syrotek?name=%4", "begins no %XX"},
      {"sim:syrotek?name=%zz", "begins no %XX"},
      {"sim:syrotek?protocol=http", "option protocol is 'http', must be morse or player"},
      {"sim:syrotek?robot=s1r", "option robot goes with protocol=player"},
      {"sim:syrotek?report=/dev/null/x", "/dev/null"},
      {"sim:syrotek?report=/tmp/x&record=/tmp/x", "both are called /tmp/x"},
  };
  for (const auto& [address, expected] : wrong) {
    std::string what = "nothing";
    try {
      const PlayerCc::PlayerClient client(address);
    } catch (const PlayerCc::PlayerError& error) {
      what = error.GetErrorStr();
    }
    EXPECT_NE(what.find(expected), std::string::npos) << address << ": " << what;
  }
  EXPECT_NE(ErrorOf("http://localhost:4000").find("sim:"), std::string::npos);
}

TEST(InProcess, EachSideOfTheLibraryRefusesTheOthersProtocol) {
  EXPECT_THROW(MorseClient::Share("sim:syrotek?protocol=player"), MorseError);
  EXPECT_THROW(MorseClient::Share("player://localhost:6665"), MorseError);
  try {
    const PlayerCc::PlayerClient client("sim:syrotek?protocol=player&robot=s1");
    ADD_FAILURE() << "there is no robot s1";
  } catch (const PlayerCc::PlayerError& error) {
    EXPECT_NE(error.GetErrorStr().find("did you mean 's1r'"), std::string::npos)
        << error.GetErrorStr();
  }
}

TEST(InProcess, AMissingOrStrangeLibraryIsSaidWithWhatToInstall) {
  const Finished missing =
      RunToEnd({"/usr/bin/env", "CCMORSE_SIM_LIBRARY=/nowhere/libccmorse-sim.so",
                BuiltProgram("trace_program"), "sim:syrotek"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.output.find("needs libccmorse-sim.so."), std::string::npos) << missing.output;
  EXPECT_NE(missing.output.find("/nowhere/libccmorse-sim.so"), std::string::npos) << missing.output;
  const std::string strange = std::string(CCMORSE_BINARY_DIR) + "/lib/libCCMorse.so";
  const Finished other = RunToEnd({"/usr/bin/env", "CCMORSE_SIM_LIBRARY=" + strange,
                                   BuiltProgram("trace_program"), "sim:syrotek"});
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.output.find("is of another version"), std::string::npos) << other.output;
}

TEST(InProcess, TheLibraryPrintsOnlyWhereTheLogIsAskedFor) {
  // What a scenario cannot have of a world is a warning of `ccmorse run`.
  const std::string world = std::string(CCMORSE_SOURCE_DIR) + "/tests/worlds/shapes.world";
  const std::vector<std::string> command = {BuiltProgram("example_hello"),
                                            "sim:" + world + "?pace=lockstep", "0"};
  const Finished quiet = RunToEnd(command);
  EXPECT_EQ(quiet.output.find("[warning]"), std::string::npos) << quiet.output;
  const Finished loud = RunToEnd({command[0], command[1] + "&log=warning", "0"});
  EXPECT_EQ(loud.status, quiet.status);
  EXPECT_NE(loud.output.find("[warning]"), std::string::npos) << loud.output;
}

int Threads() {
  DIR* const folder = ::opendir("/proc/self/task");
  int count = 0;
  while (const dirent* const entry = ::readdir(folder)) count += entry->d_name[0] != '.' ? 1 : 0;
  ::closedir(folder);
  return count;
}

// A thread's entry in /proc outlives pthread_join by a moment: the kernel wakes who waits first.
bool ThreadsBecome(int expected) {
  const auto end = Clock::now() + std::chrono::seconds(10);
  while (Threads() != expected && Clock::now() < end) std::this_thread::yield();
  return Threads() == expected;
}

// How many threads there are without a simulation. The thread sanitizer starts one of its own
// beside the first that a program starts, and keeps it.
int OwnThreads() {
  std::atomic<bool> end{false};
  std::thread first([&end] { end.wait(false); });
  const int with_first = Threads();
  end = true;
  end.notify_one();
  first.join();
  return with_first - 1;
}

std::size_t OpenFiles() {
  const std::filesystem::directory_iterator files("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

// Drives a course of its own in a simulation and gives the pose after each read.
struct Driver {
  explicit Driver(const std::string& address, double turn_in)
      : client(address), position(&client, 0), turn(turn_in) {}
  void Step() {
    client.Read();
    poses.push_back({position.GetXPos(), position.GetYPos(), position.GetYaw()});
    position.SetSpeed(0.1, turn);
  }
  PlayerCc::PlayerClient client;
  PlayerCc::Position2dProxy position;
  double turn;
  std::vector<std::vector<double>> poses;
};

TEST(InProcess, TwoSimulationsAtOnceDoNotKnowOfEachOther) {
  Driver alone("sim:syrotek?pace=lockstep&name=alone", 0.5);
  for (int i = 0; i < 30; ++i) alone.Step();
  Driver left("sim:syrotek?pace=lockstep&name=left", 0.5);
  Driver right("sim:syrotek?pace=lockstep&name=right", -0.5);
  for (int i = 0; i < 30; ++i) {
    left.Step();
    right.Step();
  }
  EXPECT_EQ(left.poses, alone.poses);
  EXPECT_NE(right.poses, alone.poses);
  EXPECT_GT(left.poses.back()[2], left.poses.front()[2]);
  EXPECT_LT(right.poses.back()[2], right.poses.front()[2]);
}

TEST(InProcess, ClientsOfOneAddressShareTheSimulationWhateverTheySpeak) {
  const std::string address = "sim:syrotek?pace=max&name=shared";
  CCMorse::PlayerClient morse(address);
  CCMorse::Position2dProxy base(&morse, 0);
  PlayerCc::PlayerClient player(address + "&protocol=player");
  PlayerCc::Position2dProxy camera(&player, 2);
  player.Read();
  while (!camera.IsFresh()) player.Read();
  const double before = camera.GetYaw();
  base.SetSpeed(0.0, 1.0);
  morse.Read();
  const auto limit = Clock::now() + std::chrono::seconds(20);
  while (camera.GetYaw() == before && Clock::now() < limit) player.Read();
  EXPECT_NE(camera.GetYaw(), before);
  EXPECT_EQ(&MorseClient::GetInstance(address), &morse.GetMorseClient());
  EXPECT_EQ(morse.GetMorseClient().GetLink(), "fast");
}

TEST(InProcess, ASimulationEndsWithItsLastClientAndLeavesNothingBehind) {
  { const PlayerCc::PlayerClient first("sim:syrotek?pace=real"); }
  const int threads = OwnThreads();
  const std::size_t files = OpenFiles();
  Clock::duration ending{};
  for (const char* options : {"pace=real", "pace=lockstep", "pace=max", "pace=real&threads=4",
                              "pace=max&protocol=player", "pace=lockstep&protocol=player"}) {
    auto client = std::make_unique<PlayerCc::PlayerClient>(std::string("sim:syrotek?") + options);
    auto position = std::make_unique<PlayerCc::Position2dProxy>(client.get(), 0);
    client->StartThread();
    position->SetSpeed(0.1, 0.1);
    client->StopThread();
    client->StartThread();  // it reads while the client goes
    const auto start = Clock::now();
    client.reset();
    ending += Clock::now() - start;
    EXPECT_NO_THROW(position->SetSpeed(0.2, 0.2));
    position.reset();
    EXPECT_TRUE(ThreadsBecome(threads)) << options << ": " << Threads();
    EXPECT_EQ(OpenFiles(), files) << options;
  }
  EXPECT_LT(ending, std::chrono::seconds(6));  // 2 s each would be those that a hanging client has
}

TEST(InProcess, AMorseClientThatIsClosedEndsItsSimulation) {
  const int threads = OwnThreads();
  MorseClient& client = MorseClient::GetInstance("sim:syrotek?pace=max&name=closed");
  client.Read();
  EXPECT_GT(Threads(), threads);
  client.Close();
  EXPECT_TRUE(ThreadsBecome(threads)) << Threads();
  EXPECT_THROW(client.Read(), MorseError);
  // The address can be had again: another simulation, from its start.
  MorseClient& again = MorseClient::GetInstance("sim:syrotek?pace=lockstep&name=closed");
  again.Read();
  EXPECT_EQ(again.GetTime(), 0.0);
  again.Close();
}

TEST(InProcess, TheEndOfTheTimeThatWasAskedForIsAnErrorThatSaysSo) {
  PlayerCc::PlayerClient client("sim:syrotek?pace=lockstep&for=1");
  int reads = 0;
  try {
    for (; reads < 100; ++reads) client.Read();
    ADD_FAILURE() << "it goes on";
  } catch (const MorseError& error) {
    EXPECT_TRUE(error.SimulationEnded()) << error.GetErrorStr();
  }
  EXPECT_EQ(reads, 10);
}

TEST(InProcess, SignalsAreLeftToTheProgramsOwnThreads) {
  const PlayerCc::PlayerClient client("sim:syrotek?pace=real&threads=3");
  int others = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    if (task.path().filename() == std::to_string(::getpid())) continue;
    std::ifstream status(task.path() / "status");
    for (std::string line; std::getline(status, line);) {
      if (!line.starts_with("SigBlk:")) continue;
      ++others;
      const auto blocked = std::stoull(line.substr(7), nullptr, 16);
      for (const int signal : {SIGINT, SIGTERM, SIGALRM, SIGUSR1, SIGCHLD}) {
        EXPECT_NE(blocked >> (signal - 1) & 1U, 0U) << task.path() << " " << signal;
      }
    }
  }
  EXPECT_GE(others, 1);
}

TEST(InProcess, HoweverAProgramEndsItsSimulationEndsInOrder) {
  for (const char* protocol : {"morse", "player"}) {
    for (const char* end : {"return", "exit", "leave"}) {
      for (const char* pace : {"lockstep", "real&factor=5"}) {
        const TemporaryFolder folder;
        const std::string address = std::string("sim:syrotek?pace=") + pace +
                                    "&protocol=" + protocol + "&report=" + folder.path() +
                                    "/report.json";
        const Finished finished =
            RunToEnd({BuiltProgram("trace_program"), address, "1", end}, std::chrono::seconds(20));
        EXPECT_EQ(finished.status, 0) << address << " " << end << ": " << finished.output;
        const Json report = Json::Parse(ReadFile(folder.path() + "/report.json"));
        EXPECT_GT(report.Find("robots")->Find("s1r")->Find("distance")->AsDouble(), 0.0);
      }
    }
  }
}

TEST(InProcess, AProgramThatThrowsDiesOfThatAlone) {
  const Finished finished =
      RunToEnd({BuiltProgram("trace_program"), "sim:syrotek?pace=real&factor=5", "1", "throw"},
               std::chrono::seconds(20));
  EXPECT_EQ(finished.status, 128 + SIGABRT) << finished.output;
  EXPECT_NE(finished.output.find("the program's own"), std::string::npos) << finished.output;
}

}  // namespace
}  // namespace ccmorse
