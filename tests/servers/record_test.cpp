// Records and replays (docs/records.md): runs over real sockets, replayed in process. Every
// ServedSimulation records its run and replays it at its end, so each test of a run is one of
// `--verify`, too.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <set>

#include "base/json.h"
#include "servers/record/replay.h"
#include "tests/servers/served_simulation.h"
#include "tests/support/line_client.h"
#include "tests/support/record_file.h"

namespace ccmorse::servers {
namespace {

using testing::LineClient;
using testing::ReadBytes;
using testing::ReadMessages;
using testing::RecordedMessage;
using testing::TemporaryFolder;
using testing::WriteBytes;
using testing::WriteMessages;

constexpr const char* kTwoRobots =
    R"({"robots": [{"name": "s1r", "pose": {"x": 1.2, "y": 2.0}},
                   {"name": "two", "pose": {"x": 2.2, "y": 2.6}}]})";

class Listener : public RunWatcher {
 public:
  explicit Listener(bool wants) : wants_(wants) {}
  bool WantsInputs() const override { return wants_; }
  void Incoming(const Input& /*input*/) override { ++heard_; }
  int heard() const { return heard_; }

 private:
  bool wants_;
  int heard_ = 0;
};

TEST(RunWatcher, InputsAreToldToThoseWhoWantThem) {
  sim::Simulation simulation(scene::ParseScenario("{}", "test.json"));
  RunOptions options;
  options.morse.port = 0;
  options.morse.first_stream_port = 0;
  Runner runner(simulation, options);
  Listener looks_only(false);
  Listener reads(true);
  runner.AddWatcher(looks_only);
  runner.AddWatcher(reads);
  std::thread thread([&] { runner.Run(); });
  EXPECT_EQ(LineClient(runner.morse().port()).Ask("1 s1r.pen set_pixel [1, 1, 1, 2, 3]"),
            "1 SUCCESS");
  runner.Stop();
  thread.join();
  EXPECT_EQ(looks_only.heard(), 0);
  EXPECT_EQ(reads.heard(), 1);
}

// A lock-step run of `seconds` in which a client sends lines before each read (ten a second).
std::string RecordLockstep(const std::string& folder, double seconds,
                           const std::function<std::string(int)>& lines,
                           const RecordOptions& options = {}) {
  const std::string kept = folder + "/run.mcap";
  ServedSimulation served(kTwoRobots, Pace::kLockstep, seconds, {}, 1, options);
  {
    LineClient client(served.port());
    std::string reply;
    for (int i = 0; reply.find("r FAILED") == std::string::npos; ++i) {
      client.Send(lines(i) + "r ccmorse read\n");
      do {
        reply = client.ReadLine().value();
      } while (reply.substr(0, 1) != "r");
    }
  }
  served.Join();
  std::filesystem::copy_file(served.record(), kept,
                             std::filesystem::copy_options::overwrite_existing);
  return kept;
}

// Drives both robots and draws.
std::string SomeCommands(int i) {
  const std::string w = std::to_string(i % 5 - 2);
  const std::string cell = std::to_string(i);
  return "1 s1r.motion set_speed [0.2, " + w + "]\n" + "2 two.motion set_speed [-0.1, " + w +
         "]\n" + "3 s1r.pen set_pixel [" + cell + ", 3, 255, 0, 0]\n" +
         "4 s1r.hokuyo get_local_data\n";
}

std::string Topics(const std::string& file) {
  std::set<std::string> topics;
  for (const RecordedMessage& message : ReadMessages(file)) topics.insert(message.topic);
  std::string text;
  for (const std::string& topic : topics) text += topic + " ";
  return text;
}

std::vector<Json> InputsOf(const std::string& file) {
  std::vector<Json> inputs;
  for (const RecordedMessage& message : ReadMessages(file)) {
    if (message.topic == "/input") inputs.push_back(Json::Parse(message.data));
  }
  return inputs;
}

Replay ReplayToTheEnd(const std::string& file) {
  Replay replay(file);
  while (replay.Step()) {
  }
  return replay;
}

// The record with one message changed, with right checksums.
std::string Tampered(const std::string& file, const std::string& topic, std::size_t index,
                     const std::function<void(Json&)>& change) {
  std::vector<RecordedMessage> messages = ReadMessages(file);
  for (RecordedMessage& message : messages) {
    if (message.topic != topic || index-- != 0) continue;
    Json json = Json::Parse(message.data);
    change(json);
    message.data = json.Dump();
    const std::string changed = file + ".tampered";
    WriteMessages(changed, messages);
    return changed;
  }
  throw std::runtime_error("no such message");
}

TEST(Record, EqualRunsGiveEqualBytes) {
  const TemporaryFolder one;
  const TemporaryFolder two;
  const RecordOptions options{"all", {}};
  EXPECT_EQ(ReadBytes(RecordLockstep(one.path(), 3.0, SomeCommands, options)),
            ReadBytes(RecordLockstep(two.path(), 3.0, SomeCommands, options)));
}

TEST(Record, HoldsEveryCommandWithItsTickInOrderAndNoQuestion) {
  const TemporaryFolder folder;
  const std::vector<Json> inputs = InputsOf(RecordLockstep(folder.path(), 1.0, SomeCommands));
  ASSERT_EQ(inputs.size(), 33U);  // 11 reads, the last is told of the end
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Json& input = inputs[i];
    // The first commands come before the first read, and then one lot each 6 ticks.
    const std::int64_t tick = i < 6 ? 0 : static_cast<std::int64_t>(i / 3 - 1) * 6;
    EXPECT_EQ(input.Find("tick")->AsInt(), tick) << i;
    EXPECT_EQ(input.Find("order")->AsInt(), static_cast<std::int64_t>(i < 6 ? i : i % 3)) << i;
    EXPECT_EQ(input.Find("kind")->AsString(), "service");
  }
  EXPECT_EQ(inputs[4].Find("component")->AsString(), "two.motion");
  EXPECT_EQ(inputs[4].Find("service")->AsString(), "set_speed");
  EXPECT_EQ(inputs[4].Find("arguments")->AsString(), "[-0.1, -1]");
}

TEST(Record, ARealTimeRunWithCommandsAtAnyTimeComesOutTheSame) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  ServedSimulation served(kTwoRobots);
  LineClient client(served.port());
  for (int i = 0; i < 40; ++i) {
    const std::string robot = random() % 2 == 0 ? "s1r" : "two";
    const double v = static_cast<double>(random() % 1000) / 1000.0 - 0.5;
    const double w = static_cast<double>(random() % 1000) / 500.0 - 1.0;
    client.Ask("1 " + robot + ".motion set_speed [" + std::to_string(v) + ", " + std::to_string(w) +
               "]");
    // Until any time between two ticks: what comes when must not matter.
    client.Ask("2 ccmorse peek [" + std::to_string(static_cast<double>(random() % 40) / 1000.0) +
               "]");
  }
}

TEST(Record, StreamsComeOutTheSame) {
  ServedSimulation served(kTwoRobots);
  LineClient client(served.port());
  const auto port = [&client](const std::string& component) {
    const std::string reply = client.Ask("1 simulation get_stream_port [\"" + component + "\"]");
    return std::stoi(reply.substr(reply.rfind(' ') + 1));
  };
  LineClient motion(port("s1r.motion"));
  LineClient other(port("s1r.motion"));
  LineClient waypoint(port("two.waypoint"));
  for (int i = 0; i < 10; ++i) {
    motion.Send("{\"v\": 0.3, \"w\": " + std::to_string(i % 3 - 1) + "}\n");
    other.Send("{\"v\": 0.1, \"w\": \"no number\"}\nno JSON\n");
    waypoint.Send("{\"x\": 1.7, \"y\": 2.8, \"tolerance\": 0.1, \"speed\": 0.4}\n");
    client.Ask("2 time sleep [0.05]");
  }
  client.Ask("3 simulation quit");
  served.Join();
  std::map<std::string, int> streams;
  for (const Json& input : InputsOf(served.record())) {
    if (input.Find("kind")->AsString() == "stream") {
      ++streams[input.Find("component")->AsString()];
    }
  }
  EXPECT_GT(streams["s1r.motion"], 0);
  EXPECT_GT(streams["two.waypoint"], 0);
}

TEST(Record, DrawingComesOutTheSame) {
  ServedSimulation served(kTwoRobots, Pace::kLockstep, 1.0);
  LineClient client(served.port());
  for (const char* line :
       {"s1r.pen set_line [0, 0, 50, 20, 200, 10, 10, 0.5]", "two.pen set_pixel [4, 5, 1, 2, 3]",
        "s1r.pen resize_canvas [20, 10]", "s1r.pen update_image_data [[[1, 1, 9, 9, 9]]]",
        "s1r.pen set_line [0, 9, 19, 0, 0, 200, 10, 0.25]", "s1r.pen set_pixel [1, 2, 3]",
        "s1r.pen get_image_data"}) {
    client.Ask(std::string("1 ") + line);
    client.Ask("2 ccmorse read");
  }
}

TEST(Record, ServicesThatTakeTimeComeOutTheSame) {
  ServedSimulation served(kTwoRobots, Pace::kLockstep, 8.0);
  LineClient client(served.port());
  const auto read = [&client](int times) {
    for (int i = 0; i < times; ++i) client.Send("r ccmorse read\n");
    for (int i = 0; i < times;) {
      if (client.ReadLine().value().substr(0, 1) == "r") ++i;
    }
  };
  read(1);
  client.Send("a s1r.waypoint goto [1.5, 2.0, 0, 0.05, 0.3]\n");
  read(10);
  client.Send("b s1r.waypoint goto [1.5, 2.3, 0, 0.05, 0.3]\n");  // preempts a
  read(10);
  client.Send("b cancel\n");
  read(5);
  client.Send("c two.waypoint goto [2.0, 2.6, 0, 0.05, 0.3]\n");
  {
    LineClient leaves(served.port());
    leaves.Ask("1 s1r.waypoint setdest [1.0, 2.3, 0, 0.05, 0.3]");
    leaves.Send("2 s1r.waypoint goto [1.0, 2.4, 0, 0.05, 0.3]\n");
    leaves.Ask("3 ccmorse ping");
  }
  read(40);
  client.Send("d simulation quit\n");
  served.Join();
  int interrupts = 0;
  for (const Json& input : InputsOf(served.record())) {
    interrupts += input.Find("kind")->AsString() == "interrupt" ? 1 : 0;
  }
  EXPECT_EQ(interrupts, 1);
}

TEST(Record, WhatChangesTheSimulationItselfComesOutTheSame) {
  ServedSimulation served(kTwoRobots, Pace::kLockstep, 3.0);
  LineClient client(served.port());
  for (const char* line :
       {"s1r.motion set_speed [0.3, 0.5]", "simulation deactivate [\"s1r.hokuyo\"]",
        "simulation suspend_dynamics", "simulation restore_dynamics",
        "simulation activate [\"s1r.hokuyo\"]",
        "simulation set_object_position [\"two\", [2.4, 2.7, 0], [0, 0, 1]]",
        "simulation set_object_position [\"two\", [0.0, 0.0, 0]]", "simulation reset_objects",
        "two.motion set_speed [0.3, NaN]", "two.motion set_speed [9.9, 9.9]",
        "simulation set_camarafp_position [[1, 2, 3]]", "time set_time_scale [2]"}) {
    client.Ask(std::string("1 ") + line);
    client.Ask("2 ccmorse read");
  }
}

TEST(Record, CommandsBehindTheLastTickCount) {
  const TemporaryFolder folder;
  const std::string file = RecordLockstep(folder.path(), 0.5, [](int) { return std::string(); });
  ServedSimulation served(kTwoRobots, Pace::kLockstep, 0.5);
  LineClient client(served.port());
  for (int i = 0; i < 5; ++i) client.Ask("1 ccmorse read");
  client.Send("2 ccmorse read\n3 s1r.pen set_pixel [1, 1, 9, 9, 9]\n");
  while (client.ReadLine().value().substr(0, 1) != "3") {
  }
  client.Reset();
  served.Join();
  EXPECT_NE(served.simulation().Hash(), ReplayToTheEnd(file).simulation().Hash());
  EXPECT_EQ(InputsOf(served.record()).back().Find("tick")->AsInt(), 30);
}

TEST(Record, ARunThatStopsBetweenSensingAndActingComesOutTheSame) {
  ServedSimulation served(kTwoRobots, Pace::kLockstep);
  LineClient client(served.port());
  client.Send("1 ccmorse read\n2 s1r.motion set_speed [0.2, 0]\n3 ccmorse read\n");
  client.ReadLine();
  client.ReadLine();
  client.ReadLine();
  client.Ask("4 simulation quit");
  served.Join();
  const RecordInfo info = ReadRecordInfo(served.record());
  EXPECT_TRUE(info.sensed);
  EXPECT_EQ(info.ticks, 6U);
  EXPECT_EQ(info.hash, served.simulation().Hash());
}

TEST(Record, AChangedInputIsFoundInItsTickAndComponent) {
  const TemporaryFolder folder;
  const std::string file = RecordLockstep(folder.path(), 2.0, SomeCommands);
  const std::vector<Json> inputs = InputsOf(file);
  struct Case {
    std::string component;
    std::string arguments;
    std::string differs;
    std::string driver;
  };
  for (const Case& wrong : {Case{"two.motion", "[-0.1, 0.125]", "two", "two.motion"},
                            Case{"s1r.motion", "[0.2000000001, 1]", "s1r", "s1r.motion"},
                            Case{"s1r.pen", "[99, 99, 0, 0, 0]", "canvas", ""}}) {
    std::size_t index = 20;
    while (inputs[index].Find("component")->AsString() != wrong.component) ++index;
    const std::string changed = Tampered(
        file, "/input", index, [&wrong](Json& input) { input.Set("arguments", wrong.arguments); });
    const Replay replay = ReplayToTheEnd(changed);
    ASSERT_TRUE(replay.difference()) << wrong.component;
    EXPECT_EQ(replay.difference()->component, wrong.differs);
    EXPECT_EQ(replay.difference()->driver, wrong.driver);
    const auto tick = static_cast<std::uint64_t>(inputs[index].Find("tick")->AsInt());
    EXPECT_EQ(replay.difference()->first_tick, tick);
    EXPECT_EQ(replay.difference()->last_tick, tick);
  }
}

TEST(Record, AChangedScenarioIsFoundInTheFirstSensorThatSeesIt) {
  const TemporaryFolder folder;
  const std::string file = RecordLockstep(folder.path(), 1.0, SomeCommands);
  const auto robot = [](Json& start, std::size_t index) -> Json& {
    for (auto& [key, value] : start.AsObject()) {
      if (key != "scenario") continue;
      for (auto& [name, part] : value.AsObject()) {
        if (name == "robots") return part.AsArray()[index];
      }
    }
    throw std::runtime_error("no robots");
  };
  const Replay moved = ReplayToTheEnd(Tampered(file, "/start", 0, [&robot](Json& start) {
    robot(start, 0).Set("pose", Json::Object{{"x", 1.25}, {"y", 2.0}, {"yaw", 0.0}});
  }));
  ASSERT_TRUE(moved.difference());
  EXPECT_EQ(moved.difference()->first_tick, 0U);
  EXPECT_EQ(moved.difference()->component, "s1r.pose");
  EXPECT_GT(moved.difference()->others, 0U);
}

TEST(Record, NoiseComesOutTheSameAndAnotherSeedIsFound) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/run.mcap";
  ServedSimulation served(R"({"seed": 7, "robots": [{"pose": {"x": 1.2, "y": 2.0},
                              "laser": {"range_std": 0.01}, "pose_noise": {"pos_std": 0.01}}]})",
                          Pace::kMax, 1.0);
  served.Join();
  std::filesystem::copy_file(served.record(), file);
  const Replay other = ReplayToTheEnd(Tampered(file, "/start", 0, [](Json& start) {
    Json scenario = *start.Find("scenario");
    ASSERT_EQ(scenario.Find("seed")->AsInt(), 7);
    scenario.Set("seed", 8);
    start.Set("scenario", scenario);
  }));
  ASSERT_TRUE(other.difference());
  EXPECT_EQ(other.difference()->first_tick, 0U);
  EXPECT_EQ(other.difference()->component, "s1r.pose");
}

TEST(Record, AChangedHashIsFound) {
  const TemporaryFolder folder;
  const std::string file = RecordLockstep(folder.path(), 1.0, SomeCommands);
  const std::string other = "0123456789abcdef";
  const Replay laser = ReplayToTheEnd(Tampered(file, "/hash", 6, [&other](Json& hash) {
    ASSERT_NE(hash.Find("components")->Find("two.hokuyo"), nullptr);
    Json components = *hash.Find("components");
    components.Set("two.hokuyo", other);
    hash.Set("components", components);
  }));
  ASSERT_TRUE(laser.difference());
  EXPECT_EQ(laser.difference()->component, "two.hokuyo");
  EXPECT_EQ(laser.difference()->first_tick, 6U);
  EXPECT_EQ(laser.difference()->recorded, other);
  EXPECT_EQ(laser.difference()->others, 0U);
  const Replay ghost = ReplayToTheEnd(Tampered(file, "/hash", 6, [&other](Json& hash) {
    Json components = *hash.Find("components");
    components.Set("three.pose", other);
    hash.Set("components", components);
  }));
  ASSERT_TRUE(ghost.difference());
  EXPECT_EQ(ghost.difference()->component, "three.pose");
  EXPECT_EQ(ghost.difference()->simulated, "nothing");
  const Replay end = ReplayToTheEnd(
      Tampered(file, "/end", 0, [&other](Json& message) { message.Set("hash", other); }));
  ASSERT_TRUE(end.difference());
  EXPECT_EQ(end.difference()->component, "");
}

TEST(Record, HashesEveryKTicksSayBetweenWhich) {
  const TemporaryFolder folder;
  const std::string file = RecordLockstep(folder.path(), 2.0, SomeCommands, {"none", 25});
  std::vector<std::int64_t> ticks;
  for (const RecordedMessage& message : ReadMessages(file)) {
    if (message.topic != "/hash") continue;
    const Json hash = Json::Parse(message.data);
    ticks.push_back(hash.Find("tick")->AsInt());
    EXPECT_NE(hash.Find("hash"), nullptr);
  }
  EXPECT_EQ(ticks, (std::vector<std::int64_t>{25, 50, 75, 100}));
  const std::vector<Json> inputs = InputsOf(file);
  std::size_t index = 0;
  while (inputs[index].Find("tick")->AsInt() != 54) ++index;
  const Replay replay = ReplayToTheEnd(
      Tampered(file, "/input", index, [](Json& input) { input.Set("arguments", "[0.2, 0.123]"); }));
  ASSERT_TRUE(replay.difference());
  EXPECT_EQ(replay.difference()->first_tick, 50U);
  EXPECT_EQ(replay.difference()->last_tick, 74U);
}

TEST(Replay, JumpsToAnySecondExactly) {
  const TemporaryFolder folder;
  Replay replay(RecordLockstep(folder.path(), 4.0, SomeCommands));
  std::vector<std::uint64_t> hashes = {replay.simulation().Hash()};
  while (replay.Step()) hashes.push_back(replay.simulation().Hash());
  ASSERT_EQ(hashes.size(), 241U);
  const unsigned seed = std::random_device{}();
  std::mt19937 random(seed);
  for (int i = 0; i < 30; ++i) {
    const std::size_t tick = random() % 240;
    replay.Seek(static_cast<double>(tick) / 60.0);
    EXPECT_EQ(replay.simulation().tick(), tick) << "seed " << seed;
    EXPECT_EQ(replay.simulation().Hash(), hashes[tick]) << "seed " << seed;
  }
  for (const double seconds : {-1.0, 1e300, 0.0, 4.0}) {
    replay.Seek(seconds);
    EXPECT_EQ(replay.simulation().tick(), seconds > 0.0 ? 240U : 0U);
  }
  EXPECT_FALSE(replay.difference());
}

TEST(Record, OneThatBreaksOffIsReplayedAsFarAsItGoes) {
  const TemporaryFolder folder;
  const std::string file = RecordLockstep(folder.path(), 4.0, SomeCommands);
  const std::string whole = ReadBytes(file);
  const std::string cut = folder.path() + "/cut.mcap";
  std::set<std::uint64_t> lengths;
  for (std::size_t size = 1000; size < whole.size(); size += whole.size() / 50) {
    WriteBytes(cut, whole.substr(0, size));
    try {
      const Replay replay = ReplayToTheEnd(cut);
      EXPECT_FALSE(replay.difference()) << size;
      EXPECT_EQ(replay.simulation().tick(), replay.info().ticks);
      lengths.insert(replay.info().ticks);
    } catch (const RecordError& error) {
      EXPECT_NE(std::string(error.what()).find("before its first chunk"), std::string::npos);
      EXPECT_TRUE(lengths.empty());
    }
  }
  EXPECT_GE(lengths.size(), 4U);  // a chunk a second
}

TEST(Record, OneWithAChangedByteIsRefused) {
  const TemporaryFolder folder;
  const std::string file = RecordLockstep(folder.path(), 1.5, SomeCommands);
  const std::string good = ReadBytes(file);
  const unsigned seed = std::random_device{}();
  std::mt19937 random(seed);
  for (int i = 0; i < 300; ++i) {
    // Half of them in the summary at the end, which is small.
    const std::size_t span = i % 2 == 0 ? good.size() : std::min<std::size_t>(good.size(), 4000);
    const std::size_t at = good.size() - 1 - random() % span;
    std::string bad = good;
    bad[at] = static_cast<char>(static_cast<unsigned char>(bad[at]) ^ (1 + random() % 255));
    WriteBytes(file, bad);
    try {
      ReadRecordInfo(file);
      ADD_FAILURE() << "byte " << at << ", seed " << seed;
    } catch (const RecordError& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find(file), std::string::npos);
      EXPECT_NE(what.find("at byte"), std::string::npos) << what;
    }
  }
}

TEST(Record, NonsenseWithRightChecksumsIsRefused) {
  const TemporaryFolder folder;
  const std::string file = RecordLockstep(folder.path(), 0.5, SomeCommands);
  const auto refused = [&file](const std::string& topic, const std::function<void(Json&)>& change) {
    const std::string changed = Tampered(file, topic, topic == "/input" ? 1 : 0, change);
    try {
      ReplayToTheEnd(changed);
      ADD_FAILURE() << topic;
    } catch (const RecordError& error) {
      EXPECT_NE(std::string(error.what()).find(changed), std::string::npos) << error.what();
    }
  };
  for (const char* key : {"tick", "kind", "component", "service", "arguments"}) {
    refused("/input", [key](Json& input) { input.Set(key, Json()); });
    refused("/input", [key](Json& input) { input.Set(key, -1); });
  }
  refused("/input", [](Json& input) { input.Set("kind", "rumour"); });
  refused("/input", [](Json& input) { input.Set("component", "nobody"); });
  refused("/input", [](Json& input) { input.Set("tick", 29); });
  refused("/input", [](Json& input) { input = Json("text"); });
  refused("/input", [](Json& input) {
    input.Set("kind", "stream");
    input.Set("component", "s1r.motion");
    input.Set("arguments", "{");
  });
  for (const char* key : {"format", "ccmorse", "name", "hash_every", "scenario"}) {
    refused("/start", [key](Json& start) { start.Set(key, Json()); });
  }
  refused("/start", [](Json& start) { start.Set("format", 2); });
  refused("/start", [](Json& start) { start.Set("hash_every", 0); });
  refused("/start", [](Json& start) { start.Set("scenario", Json::Object{{"robtos", 1}}); });
  refused("/hash", [](Json& hash) { hash.Set("components", 1); });
  refused("/hash", [](Json& hash) { hash.Set("tick", 2); });
  for (const char* key : {"tick", "sensed", "hash"}) {
    refused("/end", [key](Json& end) { end.Set(key, "x"); });
  }
  refused("/end", [](Json& end) { end.Set("tick", 31); });
}

TEST(Record, AReplayAsksNoServiceThatAnswersOrWritesFiles) {
  const TemporaryFolder folder;
  const std::string file = RecordLockstep(folder.path(), 0.5, SomeCommands);
  const std::string changed = Tampered(file, "/input", 0, [](Json& input) {
    input.Set("component", "s1r.pen");
    input.Set("service", "save_image_copy");
    input.Set("arguments", "[\"x\"]");
  });
  EXPECT_THROW(ReplayToTheEnd(changed), RecordError);
}

TEST(Record, AnotherMcapFileIsNoRecord) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/other.mcap";
  WriteMessages(file, {{"/other", "Other", 0, "{}"}});
  EXPECT_THROW(ReadRecordInfo(file), RecordError);
  WriteMessages(file, {});
  EXPECT_THROW(ReadRecordInfo(file), RecordError);
  EXPECT_THROW(ReadRecordInfo(folder.path() + "/none"), RecordError);
  EXPECT_THROW(ReadRecordInfo(folder.path()), RecordError);
}

TEST(Record, DataAreThoseThatWereAskedFor) {
  const TemporaryFolder folder;
  const auto topics = [&folder](const std::string& data) {
    return Topics(RecordLockstep(folder.path(), 1.1, SomeCommands, {data, {}}));
  };
  const std::string always = "/end /hash /input ";
  EXPECT_EQ(topics("none"), always + "/start ");
  EXPECT_EQ(topics("poses"), always + "/scene /start /tf ");
  EXPECT_EQ(topics("two.hokuyo"), always + "/start /two/hokuyo ");
  EXPECT_EQ(topics("hokuyo,poses"), always + "/s1r/hokuyo /scene /start /tf /two/hokuyo ");
  EXPECT_EQ(topics("all"), always +
                               "/s1r/hokuyo /s1r/odometry /s1r/pose /s1r/properties "
                               "/scene /start /tf "
                               "/two/hokuyo /two/odometry /two/pose /two/properties ");
}

TEST(Record, SensorDataAreWhatTheSensorsSay) {
  const TemporaryFolder folder;
  const std::string file = RecordLockstep(folder.path(), 1.0, SomeCommands, {"all", {}});
  Replay replay(file);
  std::vector<RecordedMessage> messages = ReadMessages(file);
  int scans = 0;
  int poses = 0;
  for (const RecordedMessage& message : messages) {
    if (message.topic != "/two/hokuyo" && message.topic != "/s1r/pose") continue;
    const auto tick =
        static_cast<std::uint64_t>(std::llround(static_cast<double>(message.log_time) * 60e-9));
    while (replay.simulation().tick() <= tick) replay.Step();
    const Json data = Json::Parse(message.data);
    if (message.topic == "/two/hokuyo") {
      ++scans;
      const Json sensor = Json::Parse(replay.simulation().FindComponent("two.hokuyo")->LocalData());
      EXPECT_EQ(*data.Find("ranges"), *sensor.Find("range_list"));
      EXPECT_EQ(data.Find("frame_id")->AsString(), "two");
      // The last beam is the last point's direction.
      EXPECT_NEAR(data.Find("end_angle")->AsDouble() - data.Find("start_angle")->AsDouble(),
                  681 * 0.39589 * 3.14159265358979 / 180, 1e-9);
    } else {
      ++poses;
      const Json sensor = Json::Parse(replay.simulation().FindComponent("s1r.pose")->LocalData());
      const Json& pose = *data.Find("pose");
      EXPECT_EQ(*pose.Find("position")->Find("x"), *sensor.Find("x"));
      const double z = pose.Find("orientation")->Find("z")->AsDouble();
      const double w = pose.Find("orientation")->Find("w")->AsDouble();
      EXPECT_NEAR(std::remainder(2.0 * std::atan2(z, w) - sensor.Find("yaw")->AsDouble(),
                                 2.0 * 3.14159265358979),
                  0.0, 1e-9);
    }
  }
  EXPECT_EQ(scans, 10);
  EXPECT_EQ(poses, 60);
}

TEST(Record, AnUnknownSensorIsNamedWithTheNearestAndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/run.mcap";
  sim::Simulation simulation(scene::ParseScenario("{}", "test.json"));
  try {
    const Recorder recorder(simulation, file, {"poses,hokuio", {}});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'hokuyo'"), std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Record, AFileThatCannotBeWrittenIsNamed) {
  sim::Simulation simulation(scene::ParseScenario("{}", "test.json"));
  for (const char* file : {"/proc/no/such/file", "/dev/full"}) {
    try {
      const Recorder recorder(simulation, file, {});
      ADD_FAILURE() << file;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace ccmorse::servers
