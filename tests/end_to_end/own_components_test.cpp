// Components of one's own, in Python and in C++ (docs/components.md): real simulators, real
// processes of their code, real plug-ins built by make.

#include <gtest/gtest.h>
#include <signal.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "tests/support/line_client.h"
#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

namespace fs = std::filesystem;

// What every script of these tests begins and ends with.
const std::string kHead =
    "from morse.builder import *\n"
    "robot = ATRV()\n"
    "pose = Pose()\n"
    "robot.append(pose)\n";
const std::string kTail =
    "robot.add_default_interface('socket')\n"
    "env = Environment('empty', fastmode=True)\n";

const std::string kImports =
    "import ctypes, os, time\n"
    "import morse.core.sensor, morse.core.actuator\n"
    "from morse.core import status\n"
    "from morse.core.services import service, async_service, interruptible, noninterruptible\n"
    "from morse.helpers.components import add_data, add_property\n";

// A folder with a script, default.py, and its package `own`.
class Project {
 public:
  Project() { fs::create_directories(folder_.path() + "/src/own"); }

  // Makes own/NAME.py with a class `type` of this body, and has the script mount it as NAME.
  void Add(const std::string& kind, const std::string& name, const std::string& body,
           const std::string& settings = "") {
    const std::string base =
        kind == "sensor" ? "morse.core.sensor.Sensor" : "morse.core.actuator.Actuator";
    std::ofstream(file(name)) << kImports << "class Thing(" << base << "):\n" << body;
    const std::string creator = kind == "sensor" ? "SensorCreator" : "ActuatorCreator";
    mounts_ += "class Of_" + name + "(" + creator + "):\n    _classpath = 'own." + name +
               ".Thing'\n" + name + " = Of_" + name + "()\n" + settings + "robot.append(" + name +
               ")\n";
  }
  void AddLines(const std::string& lines) { mounts_ += lines; }

  std::string file(const std::string& name) const {
    return folder_.path() + "/src/own/" + name + ".py";
  }
  const std::string& folder() const { return folder_.path(); }

  std::string WriteScript(const std::string& end = "") const {
    const std::string script = folder_.path() + "/default.py";
    std::ofstream(script) << kHead << "from morse.builder.creator import *\n"
                          << mounts_ << kTail << end;
    return script;
  }

 private:
  TemporaryFolder folder_;
  std::string mounts_;
};

// A simulation of a script, and somebody who talks with it.
class Session {
 public:
  explicit Session(const std::string& script, std::vector<std::string> more = {})
      : simulator_(Words(script, std::move(more))), client_(simulator_.port()) {}

  std::string Ask(const std::string& request) { return client_.Ask("1 " + request); }
  // The result of a call that succeeds.
  Json Get(const std::string& request) {
    const std::string answer = Ask(request);
    const std::string key = "1 SUCCESS ";
    EXPECT_TRUE(answer.starts_with(key)) << request << ": " << answer;
    return answer.starts_with(key) ? Json::Parse(answer.substr(key.size())) : Json();
  }
  Json Data(const std::string& sensor) { return Get(sensor + " get_local_data"); }
  LineClient Stream(const std::string& component) {
    return LineClient(
        static_cast<int>(Get("simulation get_stream_port [\"" + component + "\"]").AsInt()));
  }
  LineClient& client() { return client_; }
  Process& process() { return simulator_.process(); }

 private:
  static std::vector<std::string> Words(const std::string& script, std::vector<std::string> more) {
    std::vector<std::string> words = {script, "--headless", "--no-player"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  Simulator simulator_;
  LineClient client_;
};

double Number(const Json& object, const char* key) {
  const Json* const value = object.Find(key);
  EXPECT_TRUE(value != nullptr && value->IsNumber()) << key << " of " << object.Dump();
  return value != nullptr && value->IsNumber() ? value->AsDouble() : std::nan("");
}

const char* const kCounter =
    "    add_data('count', 0, 'int', 'activations')\n"
    "    add_data('x', 0.0, 'float', 'm')\n"
    "    add_property('_step', 1, 'Step', 'int', 'what it counts by')\n"
    "    @service\n"
    "    def twice(self, number, plus=0):\n"
    "        return 2 * number + plus\n"
    "    @service\n"
    "    def neighbour(self):\n"
    "        return self.call('robot.pose', 'get_local_data')['x']\n"
    "    def default_action(self):\n"
    "        self.local_data['count'] += self._step\n"
    "        self.local_data['x'] = self.position_3d.x\n";

TEST(OwnComponents, ASensorsDataAreStreamedAndItsServicesAnswered) {
  Project project;
  project.Add("sensor", "counter", kCounter,
              "counter.translate(x=0.5)\ncounter.frequency(20)\ncounter.properties(Step=3)\n");
  Session session(project.WriteScript("robot.translate(x=2.0)\n"));
  LineClient stream = session.Stream("robot.counter");
  const Json first = Json::Parse(stream.ReadLine().value_or("null"));
  const Json second = Json::Parse(stream.ReadLine().value_or("null"));
  EXPECT_EQ(Number(second, "count") - Number(first, "count"), 3.0);
  EXPECT_NEAR(Number(second, "timestamp") - Number(first, "timestamp"), 1.0 / 20.0, 1e-9);
  EXPECT_EQ(Number(second, "x"), 2.5);
  EXPECT_EQ(first.AsObject().front().first, "timestamp");

  EXPECT_EQ(session.Ask("robot.counter twice [4]"), "1 SUCCESS 8");
  EXPECT_EQ(session.Ask("robot.counter twice [4, 1]"), "1 SUCCESS 9");
  EXPECT_EQ(session.Ask("robot.counter neighbour"), "1 SUCCESS 2.0");
  EXPECT_NE(session.Ask("robot.counter twice").find("FAILED \"Socket service manager: parameters"),
            std::string::npos);
  EXPECT_NE(session.Ask("robot.counter twice [null]").find("wrong parameter type"),
            std::string::npos);
  EXPECT_EQ(session.Ask("robot.counter set_property [\"Step\", 100]"), "1 SUCCESS");
  stream.ReadLine();
  const Json before = Json::Parse(stream.ReadLine().value_or("null"));
  const Json after = Json::Parse(stream.ReadLine().value_or("null"));
  EXPECT_EQ(Number(after, "count") - Number(before, "count"), 100.0);
  EXPECT_NE(session.Ask("simulation details").find("\"type\": \"Thing\""), std::string::npos);
}

TEST(OwnComponents, AnActuatorDrivesItsRobotByStreamAndService) {
  Project project;
  project.Add(
      "actuator", "drive",
      "    add_data('speed', 0.0, 'float', 'm/s')\n"
      "    @service\n"
      "    def stop(self):\n"
      "        self.local_data['speed'] = 0.0\n"
      "    @service\n"
      "    def jump(self, x, y):\n"
      "        self.robot_parent.force_pose([x, y, 0.0], [0.0, 0.0, 1.0])\n"
      "    def default_action(self):\n"
      "        self.apply_speed('Velocity', [self.local_data['speed'], 0, 0], [0, 0, 0])\n");
  Session session(project.WriteScript(), {"--pace", "max", "--for", "1000000"});
  LineClient stream = session.Stream("robot.drive");
  // Neither of these is a command.
  stream.Send("{\"speed\": \"fast\"}\nnonsense\n{}\n");
  stream.Send("{\"speed\": 0.5}\n");
  Json there;
  do {
    there = session.Data("robot.pose");
  } while (Number(there, "x") < 1.0);
  EXPECT_EQ(session.Ask("robot.drive stop"), "1 SUCCESS");
  EXPECT_EQ(session.Ask("time sleep [0.1]"), "1 SUCCESS");
  const double rest = Number(session.Data("robot.pose"), "x");
  EXPECT_EQ(session.Ask("time sleep [1.0]"), "1 SUCCESS");
  EXPECT_EQ(Number(session.Data("robot.pose"), "x"), rest);
  EXPECT_EQ(session.Ask("robot.drive jump [-3, 4]"), "1 SUCCESS");
  EXPECT_EQ(session.Ask("time sleep [0.1]"), "1 SUCCESS");
  const Json jumped = session.Data("robot.pose");
  EXPECT_EQ(Number(jumped, "x"), -3.0);
  EXPECT_EQ(Number(jumped, "yaw"), 1.0);
}

const char* const kWaiter =
    "    add_data('interrupts', 0, 'int', '')\n"
    "    left = 0\n"
    "    @interruptible\n"
    "    @async_service\n"
    "    def wait(self, ticks):\n"
    "        self.left = ticks\n"
    "    @async_service\n"
    "    def plain(self):\n"
    "        pass\n"
    "    @noninterruptible\n"
    "    @async_service\n"
    "    def stubborn(self):\n"
    "        pass\n"
    "    def interrupt(self):\n"
    "        self.local_data['interrupts'] += 1\n"
    "        super().interrupt()\n"
    "    def default_action(self):\n"
    "        self.left -= 1\n"
    "        if self.left == 0:\n"
    "            self.completed(status.SUCCESS, {'at': self.time > 0})\n";

TEST(OwnComponents, AsynchronousServicesEndArePreemptedAndCancelled) {
  Project project;
  project.Add("sensor", "waiter", kWaiter);
  Session session(project.WriteScript());
  LineClient& client = session.client();
  EXPECT_EQ(client.Ask("7 robot.waiter wait [3]"), "7 SUCCESS {\"at\": true}");
  client.Send("a robot.waiter wait [1000000]\nb robot.waiter wait [2]\n");
  EXPECT_EQ(client.ReadLine(), "a PREEMPTED");
  EXPECT_EQ(client.ReadLine(), "b SUCCESS {\"at\": true}");
  client.Send("c robot.waiter wait [1000000]\nd robot.waiter plain\n");
  EXPECT_EQ(client.ReadLine(),
            "d FAILED \"A service (wait) is already running. I do not know what to do.\"");
  EXPECT_EQ(client.Ask("e robot.waiter stubborn"),
            "e FAILED \"A non-interruptible service (wait) is already running\"");
  client.Send("c cancel\n");
  EXPECT_EQ(client.ReadLine(), "c PREEMPTED");
  EXPECT_EQ(client.Ask("f robot.waiter wait [1]"), "f SUCCESS {\"at\": true}");
  EXPECT_EQ(Number(session.Data("robot.waiter"), "interrupts"), 2.0);
}

// What `what` in a component's default action costs: that component, a line of the log that names
// file and line, and nothing else.
void ExpectSwitchedOff(const std::string& what, const std::string& reason,
                       const std::vector<std::string>& more) {
  Project project;
  project.Add("sensor", "aaa",
              "    add_data('n', 0, 'int', '')\n"
              "    def default_action(self):\n"
              "        self.local_data['n'] += 1\n"
              "        if self.local_data['n'] == 5:\n"
              "            " +
                  what + "\n");
  project.Add("sensor", "counter", kCounter);
  Session session(project.WriteScript(), more);
  const auto line = session.process().WaitForLine("robot.aaa is switched off");
  ASSERT_TRUE(line) << what << ": " << session.process().output();
  // Six lines of imports and class come first.
  EXPECT_NE(line->find(project.file("aaa") + ":11: in default_action: " + reason),
            std::string::npos)
      << *line;
  const double count = Number(session.Data("robot.counter"), "count");
  EXPECT_EQ(session.Ask("time sleep [0.5]"), "1 SUCCESS");
  EXPECT_GT(Number(session.Data("robot.counter"), "count"), count + 20.0);
  EXPECT_EQ(session.Ask("robot.counter twice [1]"), "1 SUCCESS 2");
  EXPECT_EQ(Number(session.Data("robot.aaa"), "n"), 4.0);
}

TEST(OwnComponents, OneThatRaisesIsSwitchedOffAndTheSimulationGoesOn) {
  ExpectSwitchedOff("1 / 0", "ZeroDivisionError", {});
  ExpectSwitchedOff("self.apply_speed('Velocity', [float('nan'), 0, 0], [0, 0, 0])", "ValueError",
                    {"--pace", "max", "--for", "1000000"});
}

TEST(OwnComponents, OneThatHangsIsSwitchedOffAndTheSimulationGoesOn) {
  const std::vector<std::string> soon = {"--component-timeout", "0.75"};
  ExpectSwitchedOff("while True: pass", "it has not ended after 0.75 s", soon);
  ExpectSwitchedOff("time.sleep(1000)", "it has not ended after 0.75 s", soon);
  // C code that Python cannot interrupt: the process is killed, the others get a new one.
  ExpectSwitchedOff("sum(iter(int, 1))", "it has not answered for 1.75 s", soon);
}

TEST(OwnComponents, OneThatCrashesIsSwitchedOffAndTheSimulationGoesOn) {
  ExpectSwitchedOff("ctypes.string_at(1)", "it has ended its process (killed by SIGSEGV)", {});
}

TEST(OwnComponents, OneThatEndsTheProcessOrCannotBeMadeIsSwitchedOff) {
  Project project;
  project.Add("sensor", "aaa", "    def default_action(self):\n        os._exit(3)\n");
  project.Add("sensor", "bbb",
              "    def __init__(self, obj, parent=None):\n        raise RuntimeError('no')\n");
  project.Add("sensor", "counter", kCounter);
  Session session(project.WriteScript());
  const auto unmade = session.process().WaitForLine("robot.bbb is switched off");
  ASSERT_TRUE(unmade) << session.process().output();
  EXPECT_NE(unmade->find(project.file("bbb") + ":8: in __init__: RuntimeError: no"),
            std::string::npos)
      << *unmade;
  const auto ended = session.process().WaitForLine("robot.aaa is switched off");
  ASSERT_TRUE(ended) << session.process().output();
  EXPECT_NE(ended->find("exit status 3"), std::string::npos) << *ended;
  EXPECT_NE(ended->find(project.file("aaa") + ":7: "), std::string::npos) << *ended;
  EXPECT_EQ(session.Ask("time sleep [0.1]"), "1 SUCCESS");
  EXPECT_GT(Number(session.Data("robot.counter"), "count"), 1.0);
  // It is off for good, and says so.
  EXPECT_NE(session.Ask("robot.counter twice [2]").find("SUCCESS"), std::string::npos);
}

// Lines of a script that put an overlay of this body, own.NAME.Thing, onto the robot's pose, or
// `on`.
void AddOverlay(Project& project, const std::string& name, const std::string& body,
                const std::string& on = "pose") {
  std::ofstream(project.file(name)) << kImports << "from morse.core.overlay import MorseOverlay\n"
                                    << "class Thing(MorseOverlay):\n"
                                    << body;
  project.AddLines(on + ".add_overlay('socket', 'own." + name + ".Thing')\n");
}

const char* const kBadOverlay =
    "    def name(self): return 'bad'\n"
    "    @service\n"
    "    def hang(self):\n"
    "        while True: pass\n"
    "    @service\n"
    "    def crash(self):\n"
    "        ctypes.string_at(1)\n";

TEST(OwnComponents, AnOverlayThatHangsOrCrashesIsSwitchedOffAndTheOthersGoOn) {
  for (const std::string what : {"hang", "crash"}) {
    Project project;
    project.Add("sensor", "counter", kCounter);
    AddOverlay(project, "bad", kBadOverlay);
    AddOverlay(project, "good",
               "    def name(self): return 'good'\n"
               "    @service\n"
               "    def x(self): return self.overlaid_object.local_data['x'] + 1.0\n"
               "    @async_service\n"
               "    def never(self): pass\n");
    Session session(project.WriteScript("robot.translate(x=2.0)\n"),
                    {"--component-timeout", "0.75"});
    EXPECT_EQ(session.Ask("good x"), "1 SUCCESS 3.0");
    session.client().Send("n good never\n");
    const std::string answer = session.Ask("bad " + what);
    // A hang ends the one only; with the process goes what all others were doing.
    if (what == "crash") {
      EXPECT_TRUE(answer.starts_with("n FAILED \"The code of overlay own.good.Thing")) << answer;
      const auto next = session.client().ReadLine();
      EXPECT_TRUE(next && next->find("1 FAILED \"overlay own.bad.Thing of robot.pose") == 0)
          << *next;
    } else {
      EXPECT_TRUE(answer.starts_with("1 FAILED \"overlay own.bad.Thing of robot.pose")) << answer;
    }
    const auto line = session.process().WaitForLine("is switched off");
    ASSERT_TRUE(line) << session.process().output();
    EXPECT_NE(
        line->find(project.file("bad") + ":" + (what == "hang" ? "11" : "14") + ": in " + what),
        std::string::npos)
        << *line;
    EXPECT_NE(session.Ask("bad crash").find("was switched off"), std::string::npos);
    EXPECT_EQ(session.Ask("good x"), "1 SUCCESS 3.0");
    EXPECT_EQ(session.Ask("time sleep [0.1]"), "1 SUCCESS");
    EXPECT_EQ(session.Ask("robot.counter twice [1]"), "1 SUCCESS 2");
  }
}

TEST(OwnComponents, AnOverlayThatCannotBeMadeOrHasATakenNameIsSwitchedOff) {
  Project project;
  AddOverlay(project, "raises", "    def __init__(self, one):\n        raise ValueError('no')\n");
  AddOverlay(project, "taken", "    def name(self): return 'robot.pose'\n");
  AddOverlay(project, "words", "    def name(self): return 'two words'\n");
  AddOverlay(project, "good", "    @service\n    def one(self): return 1\n");
  Session session(project.WriteScript());
  EXPECT_EQ(session.Ask("Thing one"), "1 SUCCESS 1");
  EXPECT_EQ(session.Ask("time sleep [0.1]"), "1 SUCCESS");
  EXPECT_TRUE(session.process().WaitForLine("in __init__: ValueError: no"))
      << session.process().output();
  const std::string output = session.process().output();
  for (const std::string reason : {"its name robot.pose is taken", "its name 'two words'"}) {
    EXPECT_NE(output.find(reason), std::string::npos) << reason << ": " << output;
  }
  EXPECT_NE(session.Ask("robot.pose one").find("has not been registered"), std::string::npos);
}

TEST(OwnComponents, WhatAnOverlayHasDoneIsReplayedWithoutIt) {
  Project project;
  project.AddLines("waypoint = Waypoint()\nrobot.append(waypoint)\n");
  AddOverlay(project, "guide",
             "    def name(self): return 'guide'\n"
             "    @interruptible\n"
             "    @async_service\n"
             "    def walk(self, x):\n"
             "        self.overlaid_object.goto(self.chain_callback(self.back), x, 0.0, 0.0, 0.1)\n"
             "    def back(self, result):\n"
             "        self.overlaid_object.setdest(0.0, 0.0, 0.0, 0.1)\n"
             "        return result\n",
             "waypoint");
  const std::string record = project.folder() + "/run.mcap";
  {
    Session session(project.WriteScript(), {"--record", record});
    EXPECT_TRUE(session.Ask("guide walk [0.8]").starts_with("1 SUCCESS"));
    EXPECT_EQ(session.Ask("time sleep [0.5]"), "1 SUCCESS");
    EXPECT_EQ(session.Get("robot.waypoint get_status"), Json("Transit"));  // on its way back
    EXPECT_EQ(session.Ask("simulation quit"), "1 SUCCESS");
    EXPECT_EQ(session.process().Wait(), 0) << session.process().output();
  }
  EXPECT_EQ(ReadFile(record).find(project.folder()), std::string::npos);
  fs::remove_all(project.folder() + "/src");
  const Finished replay = RunToEnd(
      {"/usr/bin/env", "PATH=/nowhere", BuiltProgram("ccmorse"), "replay", record, "--verify"});
  EXPECT_EQ(replay.status, 0) << replay.output;
}

TEST(OwnComponents, AServiceThatRaisesFailsAndTheComponentGoesOn) {
  Project project;
  project.Add("sensor", "counter",
              std::string(kCounter) + "    @service\n    def bad(self):\n        return [][0]\n");
  Session session(project.WriteScript());
  const std::string answer = session.Ask("robot.counter bad");
  EXPECT_TRUE(answer.starts_with("1 FAILED \"")) << answer;
  EXPECT_NE(answer.find("IndexError"), std::string::npos) << answer;
  EXPECT_NE(answer.find(project.file("counter") + ":"), std::string::npos) << answer;
  EXPECT_EQ(session.Ask("robot.counter twice [2]"), "1 SUCCESS 4");
}

TEST(OwnComponents, AScriptWhoseComponentCannotBeImportedStopsWithItsTraceback) {
  Project project;
  project.Add("sensor", "aaa", "    this is no Python\n");
  const Finished run = RunToEnd({BuiltProgram("ccmorse"), "run", project.WriteScript(),
                                 "--headless", "--port", "0", "--for", "0.1"});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.output.find("[ERROR][MORSE]"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find(project.file("aaa")), std::string::npos) << run.output;
}

// Drives by time, draws and sleeps: what is in a record of it is all in the hash.
const char* const kActor =
    "    add_data('speed', 0.5, 'float', 'm/s')\n"
    "    def default_action(self):\n"
    "        import random\n"
    "        self.robot_parent.apply_speed('Velocity', [self.local_data['speed'], 0, 0],\n"
    "                                      [0, 0, random.uniform(-1, 1)])\n"
    "        self.canvas.set_pixel(*self.canvas.cell_at(self.position_3d.x, self.position_3d.y),\n"
    "                              (255, 0, 0))\n"
    "        if self.time > 1.0:\n"
    "            self.local_data['speed'] = -0.5\n";

std::string HashIn(const std::string& output) {
  const std::size_t at = output.find("state hash");
  return at == std::string::npos ? "" : output.substr(at + 13, 16);
}

TEST(OwnComponents, ARecordedRunIsReplayedEquallyWithoutPython) {
  Project project;
  project.Add("actuator", "actor", kActor);
  project.Add("sensor", "aaa",
              "    add_data('n', 0, 'int', '')\n"
              "    def default_action(self):\n"
              "        self.local_data['n'] += 1\n"
              "        if self.time > 0.5: raise RuntimeError('enough')\n");
  project.Add("sensor", "counter", kCounter, "counter.frequency(7)\n");
  const std::string record = project.folder() + "/run.mcap";
  const std::vector<std::string> words = {BuiltProgram("ccmorse"),
                                          "run",
                                          project.WriteScript(),
                                          "--headless",
                                          "--port",
                                          "0",
                                          "--stream-port",
                                          "0",
                                          "--pace",
                                          "max",
                                          "--for",
                                          "2",
                                          "--record",
                                          record};
  const Finished run = RunToEnd(words);
  ASSERT_EQ(run.status, 0) << run.output;
  const std::string hash = HashIn(run.output);
  ASSERT_EQ(hash.size(), 16U) << run.output;
  const std::string bytes = ReadFile(record);
  const std::size_t place = bytes.find(project.folder());
  EXPECT_EQ(place, std::string::npos)
      << "a record names no place: "
      << bytes.substr(place - std::min<std::size_t>(place, 200), 300);
  const Finished again = RunToEnd(words);
  EXPECT_EQ(HashIn(again.output), hash);
  EXPECT_EQ(ReadFile(record), bytes);
  // Neither the code nor a Python is there any more.
  fs::remove_all(project.folder() + "/src");
  const Finished replay = RunToEnd(
      {"/usr/bin/env", "PATH=/nowhere", BuiltProgram("ccmorse"), "replay", record, "--verify"});
  EXPECT_EQ(replay.status, 0) << replay.output;
  EXPECT_NE(replay.output.find("equal: 120 ticks"), std::string::npos) << replay.output;
  EXPECT_NE(replay.output.find(hash), std::string::npos) << replay.output;
}

TEST(OwnComponents, TheyRunUnderBothTimeStrategies) {
  for (const std::string strategy : {"BestEffort", "FixedSimulationStep"}) {
    Project project;
    project.Add("sensor", "counter", kCounter);
    project.Add("sensor", "waiter", kWaiter);
    Session session(
        project.WriteScript("env.set_time_strategy(TimeStrategies." + strategy + ")\n"));
    LineClient stream = session.Stream("robot.counter");
    const Json first = Json::Parse(stream.ReadLine().value_or("null"));
    const Json second = Json::Parse(stream.ReadLine().value_or("null"));
    // A reader that is slow misses lines, never ticks.
    EXPECT_NEAR((Number(second, "timestamp") - Number(first, "timestamp")) * 60.0,
                Number(second, "count") - Number(first, "count"), 1e-6);
    EXPECT_EQ(session.client().Ask("7 robot.waiter wait [3]"), "7 SUCCESS {\"at\": true}");
  }
}

// What `ccmorse add` makes, as it is.
class Added : public ::testing::TestWithParam<bool> {
 protected:
  Added() {
    Do({"create", "mine"});
    for (const std::string kind : {"sensor", "actuator"}) {
      std::vector<std::string> words = {"add", kind, "my_" + kind, "mine", "-d", "One of mine."};
      if (GetParam()) words.emplace_back("--cpp");
      Do(words);
    }
    if (GetParam()) {
      const Finished made = RunToEnd({"/usr/bin/make", "-C", home_ + "/mine/src/mine/plugins"});
      EXPECT_EQ(made.status, 0) << made.output;
      EXPECT_EQ(made.output.find("warning"), std::string::npos) << made.output;
    }
    std::ofstream(home_ + "/mine/default.py")
        << kHead << "from mine.builder.sensors import My_sensor\n"
        << "from mine.builder.actuators import My_actuator\n"
        << "probe = My_sensor()\nprobe.properties(Factor=2.0)\nrobot.append(probe)\n"
        << "drive = My_actuator()\nrobot.append(drive)\n"
        << kTail;
  }

  void Do(const std::vector<std::string>& words) {
    std::vector<std::string> all = {"/usr/bin/env", "-C", home_, "HOME=" + home_,
                                    BuiltProgram("ccmorse")};
    all.insert(all.end(), words.begin(), words.end());
    const Finished run = RunToEnd(all);
    EXPECT_EQ(run.status, 0) << run.output;
  }

  TemporaryFolder folder_;
  const std::string home_ = folder_.path();
};

TEST_P(Added, TheTemplatesDriveMeasureAnswerAndAreReplayed) {
  const std::string record = home_ + "/run.mcap";
  Session session(home_ + "/mine/default.py", {"--pace", "max", "--record", record});
  LineClient& client = session.client();
  EXPECT_EQ(client.Ask("1 robot.drive advance [1.0, 0.5]"), "1 SUCCESS");
  EXPECT_NEAR(Number(session.Data("robot.pose"), "x"), 1.0, 0.05);
  EXPECT_NEAR(Number(session.Data("robot.probe"), "distance"),
              2.0 * Number(session.Data("robot.pose"), "x"), 0.05);
  client.Send("a robot.drive advance [1000, 0.1]\nb robot.drive advance [0.5, -0.5]\n");
  EXPECT_EQ(client.ReadLine(), "a PREEMPTED");
  EXPECT_EQ(client.ReadLine(), "b SUCCESS");
  client.Send("c robot.probe travel [1000]\nc cancel\n");
  EXPECT_EQ(client.ReadLine(), "c PREEMPTED");
  EXPECT_EQ(session.Ask("robot.probe reset_distance"), "1 SUCCESS");
  EXPECT_EQ(Number(session.Data("robot.probe"), "distance"), 0.0);
  LineClient stream = session.Stream("robot.drive");
  stream.Send("{\"speed\": 7.0}\n");
  const std::string moved = session.Ask("robot.probe travel [3.0]");
  EXPECT_TRUE(moved.starts_with("1 SUCCESS 3.")) << moved;
  EXPECT_NE(session.Ask("robot.drive set_property [\"MaxSpeed\", \"x\"]").find("FAILED"),
            std::string::npos);
  EXPECT_EQ(session.Ask("simulation quit"), "1 SUCCESS");
  EXPECT_EQ(session.process().Wait(), 0) << session.process().output();
  fs::remove_all(home_ + "/mine/src");
  const Finished replay = RunToEnd({BuiltProgram("ccmorse"), "replay", record, "--verify"});
  EXPECT_EQ(replay.status, 0) << replay.output;
}

INSTANTIATE_TEST_SUITE_P(OwnComponents, Added, ::testing::Values(false, true),
                         [](const auto& each) { return each.param ? "Cpp" : "Python"; });

// A plug-in of this source in a project that mounts it.
Finished RunPlugin(const std::string& source, const std::string& flags = "") {
  Project project;
  const std::string file = project.folder() + "/plugin";
  std::ofstream(file + ".cpp") << "#include <ccmorse/plugin.h>\n" << source;
  const Finished made =
      RunToEnd({"/bin/sh", "-c",
                "g++ -std=c++17 -shared -fPIC " + flags + " -I" + CCMORSE_SOURCE_DIR +
                    "/include -o " + file + ".so " + file + ".cpp"});
  EXPECT_EQ(made.status, 0) << made.output;
  project.AddLines("class Own(SensorCreator):\n    _plugin = '" + file +
                   ".so'\nown = Own()\nrobot.append(own)\n");
  return RunToEnd({BuiltProgram("ccmorse"), "run", project.WriteScript(), "--headless", "--port",
                   "0", "--stream-port", "0", "--pace", "max", "--for", "0.5"});
}

TEST(OwnComponents, AnExceptionOfAPluginSwitchesItOff) {
  const Finished run = RunPlugin(
      "#include <stdexcept>\n"
      "struct Bad : ccmorse::Sensor {\n"
      "  int n = 0;\n"
      "  void DefaultAction() override { if (++n == 3) throw std::runtime_error(\"broken\"); }\n"
      "};\nCCMORSE_PLUGIN(Bad)\n");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_NE(run.output.find("robot.own is switched off"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("in DefaultAction(): broken"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("Simulated 0.500 s"), std::string::npos) << run.output;
}

TEST(OwnComponents, APluginOfAnotherVersionOrNoneAtAllIsNamed) {
  const std::string sensor =
      "struct Fine : ccmorse::Sensor { void DefaultAction() override {} };\n";
  const Finished old =
      RunPlugin("#undef CCMORSE_PLUGIN_VERSION\n#define CCMORSE_PLUGIN_VERSION 99\n" + sensor +
                "CCMORSE_PLUGIN(Fine)\n");
  EXPECT_EQ(old.status, 1);
  EXPECT_NE(old.output.find("version 99"), std::string::npos) << old.output;
  EXPECT_NE(old.output.find("build it again"), std::string::npos) << old.output;
  const Finished none = RunPlugin(sensor);
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.output.find("lacks CCMORSE_PLUGIN"), std::string::npos) << none.output;
}

TEST(OwnComponents, TheThesissRobotPropertiesAndPenAreSuchComponents) {
  Session session(CCMORSE_SOURCE_DIR "/examples/components/default.py", {"--pace", "max"});
  const Json properties = *session.Data("robot.properties").Find("properties");
  EXPECT_EQ(*properties.Find("name"), Json("robot"));
  EXPECT_EQ(Number(properties, "mass"), 20.0);
  EXPECT_EQ(Number(properties, "proxy_index"), 3.0);
  EXPECT_EQ(session.Ask("robot.properties get_property [\"Owner\"]"), "1 SUCCESS \"nobody\"");
  EXPECT_NE(
      session.Ask("robot.properties get_property [\"Colour\"]").find("FAILED \"The robot has"),
      std::string::npos);

  EXPECT_EQ(session.Ask("robot.pen get_pixel [3, 4]"), "1 SUCCESS [255, 255, 255]");
  EXPECT_EQ(session.Ask("robot.pen draw_line [2, 4, 5, 4, 1, 2, 3]"), "1 SUCCESS");
  EXPECT_EQ(session.Ask("robot.pen get_pixel [3, 4]"), "1 SUCCESS [1, 2, 3]");
  EXPECT_EQ(session.Ask("robot.pen plot [[[7, 7], [8, 8]]]"), "1 SUCCESS \"Plotted\"");
  EXPECT_EQ(session.Ask("robot.pen get_pixel [8, 8]"), "1 SUCCESS [200, 30, 30]");
  EXPECT_EQ(session.Ask("robot.pen clear"), "1 SUCCESS");
  EXPECT_EQ(session.Ask("robot.pen get_pixel [8, 8]"), "1 SUCCESS [255, 255, 255]");
}

}  // namespace
}  // namespace ccmorse::testing
