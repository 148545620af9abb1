// `ccmorse batch` with real simulators and programs: the same results whatever the order, the
// number at a time and the interruptions, and no program that can break it.

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "base/error.h"
#include "base/json.h"
#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

const std::string kIntro = BuiltProgram("intro");

std::vector<Json> LinesOf(const std::string& text) {
  std::vector<Json> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(Json::Parse(line));
  return lines;
}

// A folder with a manifest, and what `ccmorse batch` makes of it.
class Batch {
 public:
  explicit Batch(const std::string& manifest) { Write("m.json", manifest); }

  void Write(const std::string& name, const std::string& text) {
    const std::string path = folder_.path() + "/" + name;
    std::ofstream(path) << text;
    ::chmod(path.c_str(), 0755);
  }
  std::vector<std::string> Command(std::vector<std::string> options = {}) const {
    std::vector<std::string> command = {kCcmorse, "batch", folder_.path() + "/m.json", "--out",
                                        out()};
    command.insert(command.end(), options.begin(), options.end());
    return command;
  }
  Finished Run(const std::vector<std::string>& options = {}) const {
    return RunToEnd(Command(options));
  }
  std::string out() const { return folder_.path() + "/r.jsonl"; }
  std::string Results() const { return ReadFile(out()); }
  std::vector<Json> Lines() const { return LinesOf(Results()); }
  std::string folder() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

std::string Text(const Json& line, const std::string& key) { return line.Find(key)->AsString(); }

// Jobs that last and jobs that do not, with and without programs, good and bad.
std::vector<std::string> MixedJobs() {
  std::vector<std::string> jobs;
  for (const int seconds : {8, 1, 3, 5}) {
    for (const char* scenario : {"syrotek", "course_map"}) {
      std::ostringstream job;
      job << R"({"scenario": ")" << scenario << R"(", "seed": )" << seconds << R"(, "seconds": )"
          << seconds << R"(, "program": ")" << kIntro << R"("})";
      jobs.push_back(job.str());
    }
  }
  jobs.insert(jobs.begin() + 4, R"({"name": "fails", "scenario": "syrotek", "program": "sh",
                                    "args": ["-c", "echo said; exit 3"]})");
  // One whose program leaves before the time is over, so that the simulator has to be ended.
  jobs.push_back(R"({"name": "leaves", "scenario": "syrotek", "seconds": 500, "program": ")" +
                 kIntro + R"(", "args": ["--seconds", "3"]})");
  jobs.push_back(R"({"name": "alone", "scenario": "docks", "seconds": 5})");
  return jobs;
}

std::string ManifestOf(const std::vector<std::string>& jobs) {
  std::string text = "{\"jobs\": [";
  for (const std::string& job : jobs) text += (text.back() == '[' ? "" : ",\n") + job;
  return text + "]}";
}

TEST(Batch, ResultsDoNotDependOnHowManyRunAtATime) {
  const std::string manifest = ManifestOf(MixedJobs());
  const Batch one(manifest);
  ASSERT_EQ(one.Run({"-j", "1"}).status, 0);
  const auto lines = one.Lines();
  ASSERT_EQ(lines.size(), 11U);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].Find("job")->AsInt(), static_cast<int>(i));
    EXPECT_EQ(Text(lines[i], "status"), Text(lines[i], "name") == "fails" ? "failed" : "ok")
        << lines[i].Dump();
  }
  EXPECT_EQ(lines[0].Find("simulated_s")->AsDouble(), 8.0);
  EXPECT_GT(lines[0].Find("robots")->Find("s1r")->Find("distance")->AsDouble(), 0.5);
  EXPECT_EQ(lines[0].Find("exit_status")->AsInt(), 0);
  EXPECT_NE(Text(lines[0], "hash"), Text(lines[2], "hash"));
  EXPECT_NEAR(lines[9].Find("simulated_s")->AsDouble(), 3.0, 0.2);
  EXPECT_EQ(lines[10].Find("robots")->AsObject().size(), 13U);
  for (const char* at_once : {"2", "8"}) {
    const Batch more(manifest);
    ASSERT_EQ(more.Run({"-j", at_once}).status, 0);
    EXPECT_EQ(more.Results(), one.Results()) << at_once;
  }
}

TEST(Batch, ResultsDoNotDependOnTheOrderOfTheManifest) {
  std::vector<std::string> jobs = MixedJobs();
  const Batch straight(ManifestOf(jobs));
  ASSERT_EQ(straight.Run().status, 0);
  std::reverse(jobs.begin(), jobs.end());
  std::swap(jobs[1], jobs[5]);
  const Batch shuffled(ManifestOf(jobs));
  ASSERT_EQ(shuffled.Run().status, 0);
  std::map<std::string, Json> by_name;
  for (Json line : straight.Lines()) {
    line.Set("job", 0);
    by_name[Text(line, "name")] = line;
  }
  for (Json line : shuffled.Lines()) {
    line.Set("job", 0);
    EXPECT_EQ(line, by_name[Text(line, "name")]);
  }
}

// How many results there are before the batch is killed differs from run to run; that the file ends
// up the same does not.
TEST(Batch, AKilledBatchGoesOnWhereItStopped) {
  const std::string manifest = ManifestOf(MixedJobs());
  const Batch straight(manifest);
  ASSERT_EQ(straight.Run().status, 0);
  const Batch killed(manifest);
  {
    Process batch(killed.Command({"-j", "2"}));
    // A line of failure is the first thing that is said, when about half is done.
    ASSERT_TRUE(batch.WaitForLine("failed: fails")) << batch.output();
    batch.Signal(SIGKILL);
    EXPECT_EQ(batch.Wait(), 128 + SIGKILL);
  }
  const std::string before = killed.Results();
  EXPECT_NE(before, "");
  std::filesystem::resize_file(killed.out(), before.size() - 20);  // and its last line is torn
  const Finished again = killed.Run({"-j", "2"});
  EXPECT_EQ(again.status, 0);
  if (std::count(before.begin(), before.end(), '\n') > 1) {
    EXPECT_NE(again.output.find("jobs were done before"), std::string::npos) << again.output;
  }
  EXPECT_EQ(killed.Results(), straight.Results());
  // A third start has nothing to do.
  const auto written = std::filesystem::last_write_time(killed.out());
  EXPECT_EQ(killed.Run().status, 0);
  EXPECT_EQ(std::filesystem::last_write_time(killed.out()), written);
}

// Waits until no process has `text` among its arguments: killed ones need a moment to go.
bool NobodyHas(const std::string& text) {
  for (int i = 0; i < 500; ++i) {
    bool found = false;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      std::ifstream file(entry.path() / "cmdline", std::ios::binary);
      std::ostringstream line;
      line << file.rdbuf();
      found = found || (line.str().find(text) != std::string::npos &&
                        entry.path().filename() != std::to_string(::getpid()));
    }
    if (!found) return true;
    ::usleep(10000);
  }
  return false;
}

// One job that is over at once, and one that is not over for very long; its length tells its
// `sleep` from others.
std::string QuickAndEndless() {
  return R"({"jobs": [
    {"name": "quick", "scenario": "syrotek", "program": "sh", "args": ["-c", "exit 1"]},
    {"name": "endless", "scenario": "syrotek", "timeout": 1000, "program": "sh",
     "args": ["-c", "sleep 99)" +
         std::to_string(::getpid()) + R"( & echo x > {folder}/started; wait"]}]})";
}

void WaitForFile(const std::string& path) {
  for (int i = 0; i < 3000 && !std::filesystem::exists(path); ++i) ::usleep(10000);
  ASSERT_TRUE(std::filesystem::exists(path)) << path;
}

// The simulator's own time limit for clients is short; a job has one of its own.
TEST(Batch, AProgramMayThinkAsLongAsItsJobMayTake) {
  const Batch batch(QuickAndEndless());
  const Process process(batch.Command({"-j", "2"}));
  WaitForFile(batch.folder() + "/r.jobs/endless/started");
  bool found = false;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "cmdline", std::ios::binary);
    std::ostringstream read;
    read << file.rdbuf();
    const std::string line = read.str();
    if (line.find(batch.folder() + "/r.jobs/endless/.report.json") == std::string::npos) continue;
    found = true;
    EXPECT_NE(line.find(std::string("--client-timeout\0"
                                    "0\0",
                                    19)),
              std::string::npos);
  }
  EXPECT_TRUE(found);
}

TEST(Batch, CtrlCEndsTheProcessesAndKeepsTheResults) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Batch batch(QuickAndEndless());
    Process process(batch.Command({"-j", "2"}));
    ASSERT_TRUE(process.WaitForLine("failed: quick")) << process.output();
    WaitForFile(batch.folder() + "/r.jobs/endless/started");
    process.Signal(signal);
    EXPECT_EQ(process.Wait(), 128 + signal);
    EXPECT_NE(process.output().find("goes on from here"), std::string::npos) << process.output();
    EXPECT_TRUE(NobodyHas(batch.folder()));
    EXPECT_TRUE(NobodyHas("99" + std::to_string(::getpid())));
    ASSERT_EQ(batch.Lines().size(), 1U);
    EXPECT_EQ(Text(batch.Lines()[0], "name"), "quick");
  }
}

TEST(Batch, NothingOutlivesAKilledBatch) {
  const Batch batch(QuickAndEndless());
  Process process(batch.Command({"-j", "2"}));
  WaitForFile(batch.folder() + "/r.jobs/endless/started");
  process.Signal(SIGKILL);
  EXPECT_TRUE(NobodyHas(batch.folder()));
  EXPECT_TRUE(NobodyHas("99" + std::to_string(::getpid()))) << "the program's own child";
}

TEST(Batch, WhatAProgramDoesWrongIsItsResult) {
  Batch batch(R"({"seconds": 5, "jobs": [
    {"name": "crashes", "scenario": "syrotek", "program": "./p", "args": ["kill -SEGV $$"]},
    {"name": "fails", "scenario": "syrotek", "program": "./p", "args": ["echo a >&2; exit 7"]},
    {"name": "hangs", "scenario": "syrotek", "program": "./p", "args": ["sleep 999"],
     "timeout": 1},
    {"name": "hangs_deaf", "scenario": "syrotek", "program": "./p",
     "args": ["trap '' TERM INT; while :; do sleep 99; done"], "timeout": 1},
    {"name": "leaves_others", "scenario": "syrotek", "program": "./p",
     "args": ["sleep 999 & exit 0"]},
    {"name": "no_utf8", "scenario": "syrotek", "program": "./p",
     "args": ["printf '\\377\\000z' >&2; exit 1"]},
    {"name": "not_a_program", "scenario": "syrotek", "program": "./no_interpreter"},
    {"name": "good", "scenario": "syrotek", "program": "./p", "args": ["true"]}]})");
  batch.Write("p", "#!/bin/sh\neval \"$1\"\n");
  batch.Write("no_interpreter", "#!/no/such/thing\n");
  const Finished run = batch.Run({"-j", "8"});
  EXPECT_EQ(run.status, 0) << run.output;
  const auto lines = batch.Lines();
  ASSERT_EQ(lines.size(), 8U);
  EXPECT_EQ(Text(lines[0], "status"), "failed");
  EXPECT_EQ(Text(lines[0], "error"), "the program: killed by SIGSEGV (Segmentation fault)");
  EXPECT_TRUE(lines[0].Find("exit_status")->IsNull());
  EXPECT_EQ(Text(lines[1], "error"), "the program: exit status 7");
  EXPECT_EQ(lines[1].Find("exit_status")->AsInt(), 7);
  EXPECT_EQ(Text(lines[1], "stderr"), "a\n");
  EXPECT_EQ(Text(lines[1], "log"), "r.jobs/fails/log.txt");
  EXPECT_EQ(ReadFile(batch.folder() + "/r.jobs/fails/log.txt"), "a\n");
  EXPECT_NE(run.output.find("failed: fails: the program: exit status 7 (r.jobs/fails/log.txt)"),
            std::string::npos)
      << run.output;
  for (const std::size_t i : {2U, 3U}) {
    EXPECT_EQ(Text(lines[i], "status"), "timeout");
    EXPECT_EQ(Text(lines[i], "error"), "not over after 1 s");
    EXPECT_EQ(lines[i].Find("hash"), nullptr);
  }
  EXPECT_EQ(Text(lines[4], "status"), "ok") << lines[4].Dump();
  EXPECT_EQ(Text(lines[5], "status"), "failed");
  EXPECT_EQ(Text(lines[6], "status"), "failed");
  EXPECT_NE(Text(lines[6], "error").find("no_interpreter"), std::string::npos);
  EXPECT_EQ(Text(lines[7], "status"), "ok") << lines[7].Dump();
  EXPECT_TRUE(NobodyHas(batch.folder()));
  EXPECT_NE(run.output.find("8 jobs: 2 ok, 4 failed, 2 timed out"), std::string::npos)
      << run.output;
}

TEST(Batch, AGigabyteOfOutputIsNoGigabyteOfLog) {
  Batch batch(R"({"seconds": 5, "jobs": [{"name": "loud", "scenario": "syrotek", "program": "sh",
    "args": ["-c", "echo first; head -c 1000000000 /dev/zero; echo last; exit 1"]}]})");
  EXPECT_EQ(batch.Run({"--log-kib", "64"}).status, 0);
  const std::string log = ReadFile(batch.folder() + "/r.jobs/loud/log.txt");
  EXPECT_LT(log.size(), 66000U);
  EXPECT_TRUE(log.starts_with("first\n"));
  EXPECT_TRUE(log.ends_with("last\n"));
  EXPECT_NE(log.find(" bytes left out ...]"), std::string::npos);
}

TEST(Batch, AProgramIsToldWhereAndWhatItIs) {
  Batch batch(R"({"jobs": [{"name": "told", "scenario": "syrotek", "seed": 42, "program": "./p",
    "args": ["{host}:{port} {seed} {name} {folder} {other}"]}]})");
  batch.Write("p",
              "#!/bin/sh\n"
              "[ \"$1\" = \"$CCMORSE_HOST:$CCMORSE_PORT $CCMORSE_SEED $CCMORSE_JOB "
              "$CCMORSE_JOB_FOLDER {other}\" ] || exit 2\n"
              "[ \"$CCMORSE_SEED $CCMORSE_JOB\" = '42 told' ] || exit 3\n"
              "[ -x ./p ] || exit 4\n"
              "echo kept > \"$CCMORSE_JOB_FOLDER/mine\"\n");
  EXPECT_EQ(batch.Run().status, 0);
  EXPECT_EQ(Text(batch.Lines()[0], "status"), "ok") << batch.Results();
  EXPECT_EQ(ReadFile(batch.folder() + "/r.jobs/told/mine"), "kept\n");
}

TEST(Batch, AProgramWithTheUsualAddressBuiltInIsSentToItsOwnSimulator) {
  ::setenv("CCMORSE_PORT", "1", 1);
  const Finished lost = RunToEnd({kIntro, "--port", "4000"});
  ::setenv("CCMORSE_PORT", "x", 1);
  const Finished wrong = RunToEnd({kIntro});
  ::unsetenv("CCMORSE_PORT");
  EXPECT_NE(lost.output.find("localhost:1"), std::string::npos) << lost.output;
  EXPECT_NE(wrong.output.find("CCMORSE_PORT is 'x', must be 1..65535"), std::string::npos)
      << wrong.output;
}

TEST(Batch, RetryDoesAgainWhatFailed) {
  Batch batch(R"({"jobs": [
    {"name": "later", "scenario": "syrotek", "program": "./p"},
    {"name": "good", "scenario": "docks", "seconds": 1}]})");
  batch.Write("p", "#!/bin/sh\nexit 1\n");
  EXPECT_EQ(batch.Run().status, 0);
  batch.Write("p", "#!/bin/sh\nexit 0\n");
  EXPECT_EQ(batch.Run().status, 0);
  EXPECT_EQ(Text(batch.Lines()[0], "status"), "failed");
  const Finished again = batch.Run({"--retry"});
  EXPECT_NE(again.output.find("1 of 2 jobs were done before"), std::string::npos) << again.output;
  EXPECT_EQ(Text(batch.Lines()[0], "status"), "ok");
}

TEST(Batch, TimesAreInTheResultsOnlyWhenAskedFor) {
  const Batch batch(R"({"seconds": 1, "scenarios": ["docks"]})");
  EXPECT_EQ(batch.Run({"--timing"}).status, 0);
  const Json line = batch.Lines()[0];
  EXPECT_GT(line.Find("timing")->Find("wall_s")->AsDouble(), 0.0);
  const Batch without(R"({"seconds": 1, "scenarios": ["docks"]})");
  EXPECT_EQ(without.Run().status, 0);
  EXPECT_EQ(without.Lines()[0].Find("timing"), nullptr);
}

TEST(Batch, AMistakeInTheManifestIsOneLineThatSaysWhere) {
  const Batch batch("{\"seconds\": 1,\n\"scenarois\": [\"docks\"]}");
  const Finished run = batch.Run();
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.output, "ccmorse: " + batch.folder() +
                            "/m.json:2: unknown key 'scenarois'; did you mean 'scenarios'?\n");
  EXPECT_FALSE(std::filesystem::exists(batch.out()));
}

TEST(Batch, ResultsOfAnotherManifestAreLeftAlone) {
  Batch batch(R"({"seconds": 1, "scenarios": ["docks"]})");
  EXPECT_EQ(batch.Run().status, 0);
  const std::string before = batch.Results();
  batch.Write("m.json", R"({"seconds": 2, "scenarios": ["docks"]})");
  const Finished run = batch.Run();
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.output.find("r.jsonl:1: the seconds of job 'docks' was 1.0 and is 2.0 in "),
            std::string::npos)
      << run.output;
  EXPECT_EQ(batch.Results(), before);
}

TEST(Batch, TasksOfAnArrayWriteTheSameTogether) {
  const std::string manifest = ManifestOf(MixedJobs());
  const Batch straight(manifest);
  ASSERT_EQ(straight.Run().status, 0);
  const Batch parted(manifest);
  EXPECT_EQ(parted.Run({"--task", "2/3"}).status, 0);
  EXPECT_EQ(parted.Run({"--task", "3/3"}).status, 0);
  const Finished early = parted.Run({"--collect"});
  EXPECT_EQ(early.status, 1);
  EXPECT_NE(early.output.find("4 still to do"), std::string::npos) << early.output;
  EXPECT_EQ(parted.Run({"--task", "1/3"}).status, 0);
  EXPECT_EQ(parted.Run({"--collect"}).status, 0);
  EXPECT_EQ(parted.Results(), straight.Results());
  for (const char* task : {"0/3", "4/3", "1", "1/", "/2", "1/2x", "a/b"}) {
    EXPECT_EQ(parted.Run({"--task", task}).status, 1) << task;
  }
}

}  // namespace
}  // namespace ccmorse::testing
