// Records of real processes, and what others read in them.

#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>

#include "base/error.h"
#include "base/json.h"
#include "tests/support/line_client.h"
#include "tests/support/process.h"
#include "tests/support/record_file.h"

namespace ccmorse::testing {
namespace {

// Lets the introduction program drive for `seconds` and returns what the simulator printed.
std::string RecordIntro(const std::string& record, double seconds,
                        std::vector<std::string> options = {}) {
  std::vector<std::string> arguments = {
      "syrotek", "--pace", "lockstep", "--for", std::to_string(seconds), "--record", record};
  arguments.insert(arguments.end(), options.begin(), options.end());
  Simulator simulator(arguments);
  const Finished intro =
      RunToEnd({BuiltProgram("intro"), "--port", std::to_string(simulator.port())});
  EXPECT_EQ(intro.status, 0) << intro.output;
  EXPECT_EQ(simulator.process().Wait(), 0) << simulator.process().output();
  return simulator.process().output();
}

std::string HashIn(const std::string& output) {
  const std::string key = "state hash   ";
  const std::size_t at = output.find(key);
  return at == std::string::npos ? "" : output.substr(at + key.size(), 16);
}

Finished Replay(const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {kCcmorse, "replay", "--headless"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return RunToEnd(command);
}

TEST(Record, TheIntroductionProgramsRunIsVerified) {
  const TemporaryFolder folder;
  const std::string record = folder.path() + "/run.mcap";
  const std::string output = RecordIntro(record, 60);
  EXPECT_NE(output.find("record       " + record), std::string::npos) << output;
  const Finished verify = Replay({record, "--verify"});
  EXPECT_EQ(verify.status, 0);
  EXPECT_EQ(verify.output, "equal: 3600 ticks (60.000 s), hash " + HashIn(output) + "\n");
}

TEST(Record, EqualRunsGiveEqualFiles) {
  const TemporaryFolder folder;
  RecordIntro(folder.path() + "/1.mcap", 10, {"--record-data", "all"});
  RecordIntro(folder.path() + "/2.mcap", 10, {"--record-data", "all"});
  EXPECT_EQ(ReadBytes(folder.path() + "/1.mcap"), ReadBytes(folder.path() + "/2.mcap"));
}

TEST(Record, HashesArePrintedAndKept) {
  const TemporaryFolder folder;
  const std::string record = folder.path() + "/run.mcap";
  const std::string output = RecordIntro(record, 5, {"--hash-every", "100"});
  EXPECT_NE(output.find("tick       100  time        1.667 s  hash "), std::string::npos) << output;
  EXPECT_NE(output.find("tick       300  time        5.000 s  hash " + HashIn(output)),
            std::string::npos)
      << output;
  int kept = 0;
  for (const RecordedMessage& message : ReadMessages(record)) {
    if (message.topic != "/hash") continue;
    ++kept;
    const std::string hash = Json::Parse(message.data).Find("hash")->AsString();
    EXPECT_NE(output.find("hash " + hash), std::string::npos);
  }
  EXPECT_EQ(kept, 3);
}

TEST(Replay, PlaysAnyStretchAtAnySpeed) {
  const TemporaryFolder folder;
  const std::string record = folder.path() + "/run.mcap";
  const std::string hash = HashIn(RecordIntro(record, 10));
  const Finished all = Replay({record, "--speed", "max"});
  EXPECT_EQ(all.status, 0);
  EXPECT_EQ(HashIn(all.output), hash);
  const Finished end = Replay({record, "--from", "9.5", "--speed", "1000"});
  EXPECT_EQ(HashIn(end.output), hash);
  EXPECT_NE(end.output.find("     9.500 / 10.000 s  s1r ("), std::string::npos) << end.output;
  const Finished middle = Replay({record, "--from", "4", "--to", "6", "--speed", "max"});
  EXPECT_EQ(middle.status, 0);
  EXPECT_NE(middle.output.find("     6.000 / 10.000 s"), std::string::npos) << middle.output;
  EXPECT_EQ(HashIn(middle.output), HashIn(Replay({record, "--to", "6", "--speed", "max"}).output));
  EXPECT_NE(HashIn(middle.output), hash);
  const Finished behind = Replay({record, "--from", "11"});
  EXPECT_EQ(behind.status, 1);
  EXPECT_NE(behind.output.find("after the record's end at 10.000 s"), std::string::npos);
}

TEST(Replay, AChangedCommandIsToldWithTickAndComponent) {
  const TemporaryFolder folder;
  const std::string record = folder.path() + "/run.mcap";
  RecordIntro(record, 5);
  std::vector<RecordedMessage> messages = ReadMessages(record);
  for (RecordedMessage& message : messages) {
    if (message.topic != "/input" || message.log_time < 2'000'000'000) continue;
    Json input = Json::Parse(message.data);
    if (input.Find("service")->AsString() != "set_speed") continue;
    input.Set("arguments", "[0.01, 0.0]");
    message.data = input.Dump();
    break;
  }
  WriteMessages(record, messages);
  const Finished verify = Replay({record, "--verify"});
  EXPECT_EQ(verify.status, 1);
  EXPECT_EQ(verify.output.find("differs in tick 120 (2.000 s): s1r, its pose or speed (driven by "
                               "s1r.motion): recorded "),
            0U)
      << verify.output;
  const Finished play = Replay({record, "--speed", "max"});
  EXPECT_EQ(play.status, 1);
  EXPECT_NE(play.output.find("differs in tick 120"), std::string::npos) << play.output;
}

TEST(Replay, ARecordOfAnotherVersionThatDiffersSaysSo) {
  const TemporaryFolder folder;
  const std::string record = folder.path() + "/run.mcap";
  RecordIntro(record, 1);
  std::vector<RecordedMessage> messages = ReadMessages(record);
  Json start = Json::Parse(messages.at(0).data);
  start.Set("ccmorse", "0.0.9");
  messages[0].data = start.Dump();
  WriteMessages(record, messages);
  EXPECT_EQ(Replay({record, "--verify"}).status, 0);
  Json end = Json::Parse(messages.back().data);
  end.Set("hash", "0123456789abcdef");
  messages.back().data = end.Dump();
  WriteMessages(record, messages);
  const Finished verify = Replay({record, "--verify"});
  EXPECT_EQ(verify.status, 1);
  EXPECT_NE(verify.output.find("The record is of ccmorse 0.0.9"), std::string::npos)
      << verify.output;
}

TEST(Replay, ADamagedRecordIsRefusedInOneLine) {
  const TemporaryFolder folder;
  const std::string record = folder.path() + "/run.mcap";
  RecordIntro(record, 1);
  std::string bytes = ReadBytes(record);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  WriteBytes(record, bytes);
  for (const std::vector<std::string>& words : {std::vector<std::string>{record, "--verify"},
                                                {record, "--speed", "max"},
                                                {folder.path() + "/none.mcap"},
                                                {std::string(CCMORSE_SOURCE_DIR) + "/README.md"}}) {
    const Finished run = Replay(words);
    EXPECT_EQ(run.status, 2) << run.output;
    EXPECT_NE(run.output.find(words[0]), std::string::npos) << run.output;
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
  }
}

TEST(Record, ARunThatIsKilledLeavesARecordThatCanBeVerified) {
  const TemporaryFolder folder;
  const std::string record = folder.path() + "/run.mcap";
  Simulator simulator({"two_robots", "--pace", "lockstep", "--record", record});
  LineClient client(simulator.port());
  for (int i = 0; i < 50; ++i) {
    client.Ask("1 s1r.motion set_speed [0.1, 0.3]");
    client.Ask("2 ccmorse read");
  }
  simulator.process().Signal(SIGKILL);
  simulator.process().Wait();
  const Finished verify = Replay({record, "--verify"});
  EXPECT_EQ(verify.status, 3);
  EXPECT_NE(verify.output.find("The record is not whole"), std::string::npos) << verify.output;
  EXPECT_NE(verify.output.find("\nequal as far as it goes: "), std::string::npos) << verify.output;
  // At most the last second is lost.
  const std::size_t at = verify.output.find("goes: ") + 6;
  EXPECT_GE(std::stoi(verify.output.substr(at)), 49 * 6 - 60 - 1);
}

TEST(Record, WhereItCannotBeWrittenIsSaidBeforeTheRun) {
  const std::vector<std::string> run = {kCcmorse, "run",           "syrotek", "--pace",
                                        "max",    "--for",         "1",       "--port",
                                        "0",      "--stream-port", "0"};
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--record", "/proc/no/such/file"},
        {"--record", "/tmp/x.mcap", "--record-data", "hokuio"},
        {"--hash-every", "0"},
        {"--record-data", "all"}}) {
    std::vector<std::string> command = run;
    command.insert(command.end(), words.begin(), words.end());
    const Finished finished = RunToEnd(command);
    EXPECT_NE(finished.status, 0) << words[0];
    EXPECT_NE(finished.output.find(words.back() == "hokuio" ? "hokuyo"
                                   : words[0] == "--record" ? words[1]
                                                            : words[0]),
              std::string::npos)
        << finished.output;
    EXPECT_EQ(finished.output.find("SCENE INITIALIZED"), std::string::npos);
  }
}

// The independent reader: npm's @mcap/core, as Foxglove uses it (tests/records/package.json).
TEST(Record, OfAMinuteOpensWithMcapCoreAndHoldsWhatIsDocumented) {
  const std::string reader = std::string(CCMORSE_SOURCE_DIR) + "/tests/records/";
  ASSERT_TRUE(std::filesystem::exists(reader + "node_modules/@mcap/core"))
      << "run `npm ci` in tests/records, as ./check does";
  const TemporaryFolder folder;
  const std::string record = folder.path() + "/run.mcap";
  const std::string hash = HashIn(RecordIntro(record, 60, {"--record-data", "all"}));
  const Finished read =
      RunToEnd({"/usr/bin/env", "node", reader + "read_record.mjs", record, hash});
  EXPECT_EQ(read.status, 0) << read.output;
  EXPECT_NE(read.output.find("everything is there"), std::string::npos) << read.output;
}

}  // namespace
}  // namespace ccmorse::testing
