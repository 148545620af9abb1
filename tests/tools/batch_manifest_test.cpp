// A batch's manifest: what it may say, and that every mistake is one line that says where and what.

#include "tools/batch_manifest.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "tests/support/process.h"

namespace ccmorse::tools {
namespace {

using ccmorse::testing::TemporaryFolder;

std::vector<BatchJob> Parse(const std::string& text) { return ParseManifest(text, "m.json"); }

std::string ErrorOf(const std::string& text) {
  try {
    Parse(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

// The message of a manifest whose second line is `line`.
std::string ErrorInLine2(const std::string& line) { return ErrorOf("{\n" + line + "\n}"); }

std::string ErrorOfFile(const std::string& file) {
  try {
    LoadManifest(file);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(BatchManifest, AJobHasAllThatItsLineSays) {
  const auto jobs = Parse(R"({"seconds": 20, "jobs": [
    {"name": "one", "scenario": "a/b.json", "seed": 7, "program": "../x", "args": ["--n", ""],
     "seconds": 3.5, "timeout": 9},
    {"scenario": "docks"}]})");
  ASSERT_EQ(jobs.size(), 2U);
  EXPECT_EQ(jobs[0].index, 0);
  EXPECT_EQ(jobs[0].name, "one");
  EXPECT_EQ(jobs[0].scenario, "a/b.json");
  EXPECT_EQ(jobs[0].seed, 7);
  EXPECT_EQ(jobs[0].program, "../x");
  EXPECT_EQ(jobs[0].args, (std::vector<std::string>{"--n", ""}));
  EXPECT_EQ(jobs[0].seconds, 3.5);
  EXPECT_EQ(jobs[0].timeout, 9.0);
  EXPECT_EQ(jobs[1].index, 1);
  EXPECT_EQ(jobs[1].name, "docks");
  EXPECT_EQ(jobs[1].seed, std::nullopt);
  EXPECT_EQ(jobs[1].program, "");
  EXPECT_EQ(jobs[1].seconds, 20.0);
  EXPECT_EQ(jobs[1].timeout, 600.0);
}

TEST(BatchManifest, TheProductVariesProgramsFastestAndFollowsTheJobs) {
  const auto jobs = Parse(R"({"seconds": 1, "timeout": 5,
    "scenarios": ["a", "d/b.json"], "seeds": {"from": 9, "to": 10},
    "programs": ["./go", {"program": "python3", "args": ["x.py"], "name": "x"}],
    "jobs": [{"scenario": "first"}]})");
  std::vector<std::string> names;
  for (const BatchJob& job : jobs) names.push_back(job.name);
  EXPECT_EQ(names, (std::vector<std::string>{"first", "a-9-go", "a-9-x", "a-10-go", "a-10-x",
                                             "b-9-go", "b-9-x", "b-10-go", "b-10-x"}));
  EXPECT_EQ(jobs[2].args, std::vector<std::string>{"x.py"});
  EXPECT_EQ(jobs[8].scenario, "d/b.json");
  EXPECT_EQ(jobs[8].seed, 10);
  EXPECT_EQ(jobs[8].timeout, 5.0);
  for (std::size_t i = 0; i < jobs.size(); ++i) EXPECT_EQ(jobs[i].index, static_cast<int>(i));
}

TEST(BatchManifest, SeedsMayBeAListAndTheLargestThereAre) {
  EXPECT_EQ(Parse(R"({"seconds": 1, "scenarios": ["a"], "seeds": [3, 1]})")[1].name, "a-1");
  const auto last = Parse(
      R"({"seconds": 1, "scenarios": ["a"],
          "seeds": {"from": 9223372036854775806, "to": 9223372036854775807}})");
  ASSERT_EQ(last.size(), 2U);
  EXPECT_EQ(last[1].seed, 9223372036854775807);
}

TEST(BatchManifest, WithAProgramTheTimeMayBeLeftToIt) {
  EXPECT_EQ(Parse(R"({"jobs": [{"scenario": "a", "program": "p"}]})")[0].seconds, 0.0);
  EXPECT_EQ(ErrorInLine2(R"("jobs": [{"scenario": "a"}])"),
            "m.json:2: jobs[0] has neither 'seconds' nor a 'program', so it would never end");
  EXPECT_EQ(ErrorInLine2(R"("scenarios": ["a"])"),
            "m.json:2: scenarios[0] has neither 'seconds' nor a 'program', so it would never end");
}

TEST(BatchManifest, UnknownKeysNameTheNearest) {
  EXPECT_EQ(ErrorInLine2(R"("job": [])"), "m.json:2: unknown key 'job'; did you mean 'jobs'?");
  EXPECT_EQ(ErrorInLine2(R"("jobs": [{"scenario": "a", "sed": 1, "seconds": 1}])"),
            "m.json:2: unknown key 'sed' in jobs[0]; did you mean 'seed'?");
  EXPECT_EQ(ErrorInLine2(R"("jobs": [{"scenari": "a"}])"),
            "m.json:2: jobs[0] lacks 'scenario'; is 'scenari' meant?");
  EXPECT_EQ(ErrorInLine2(R"("seconds": 1, "scenarios": ["a"], "seeds": {"from": 1, "too": 2})"),
            "m.json:2: seeds lacks 'to'; is 'too' meant?");
  EXPECT_EQ(ErrorInLine2(R"("scenarios": ["a"], "programs": [{"program": "p", "arg": []}])"),
            "m.json:2: unknown key 'arg' in programs[0]; did you mean 'args'?");
}

TEST(BatchManifest, WrongValues) {
  EXPECT_EQ(ErrorInLine2(R"("jobs": {})"), "m.json:2: jobs must be a list, not an object");
  EXPECT_EQ(ErrorInLine2(R"("jobs": [3])"),
            "m.json:2: jobs[0] must be an object {...}, not a number");
  EXPECT_EQ(ErrorInLine2(R"("seconds": 0)"),
            "m.json:2: seconds is 0, must be more than 0 and at most 1000000000");
  EXPECT_EQ(ErrorInLine2(R"("timeout": "1 h")"),
            "m.json:2: timeout must be a number, not a string");
  EXPECT_EQ(ErrorInLine2(R"("jobs": [{"scenario": "a", "seed": -1}])"),
            "m.json:2: jobs[0].seed is -1, must be 0..9223372036854775807");
  EXPECT_EQ(ErrorInLine2(R"("jobs": [{"scenario": "a", "program": "p", "args": [1]}])"),
            "m.json:2: jobs[0].args[0] must be a string, not a number");
  EXPECT_EQ(ErrorInLine2(R"("jobs": [{"scenario": "a", "args": ["x"], "seconds": 1}])"),
            "m.json:2: jobs[0].args need a 'program'");
  EXPECT_EQ(ErrorInLine2(R"("jobs": [{"scenario": "", "seconds": 1}])"),
            "m.json:2: jobs[0].scenario is empty");
  EXPECT_EQ(ErrorInLine2(R"("jobs": [{"scenario": "a\u0000b", "seconds": 1}])"),
            "m.json:2: jobs[0].scenario has a NUL character");
  EXPECT_EQ(
      ErrorInLine2(R"("scenarios": ["a"], "seeds": 5)"),
      "m.json:2: seeds must be a list of seeds or {\"from\": ..., \"to\": ...}, not a number");
  EXPECT_EQ(ErrorInLine2(R"("scenarios": ["a"], "seeds": {"from": 5, "to": 4})"),
            "m.json:2: seeds.to is 4, must be 5..9223372036854775807");
  EXPECT_EQ(ErrorInLine2(R"("scenarios": ["a"], "programs": [1])"),
            "m.json:2: programs[0] must be a path or {\"program\": ...}, not a number");
  EXPECT_EQ(ErrorInLine2(R"("seeds": [1])"), "m.json:2: seeds need 'scenarios'");
  EXPECT_EQ(ErrorInLine2(R"("scenarios": [], "seconds": 1)"),
            "m.json:2: scenarios are an empty list");
  EXPECT_EQ(ErrorOf("{}"), "m.json:1: the file has no jobs: it needs 'jobs' or 'scenarios'");
  EXPECT_EQ(ErrorOf("{\n\"jobs\": [\n}"), "m.json:3: Expecting value (column 1)");
}

TEST(BatchManifest, NamesAreHarmlessAsFoldersAndUnique) {
  for (const char* name : {"", ".hidden", "..", "-x", "a/b", "a b", "a\\u0000", "\\u00e4"}) {
    const std::string message = ErrorInLine2(
        fmt::format(R"("jobs": [{{"scenario": "a", "seconds": 1, "name": "{}"}}])", name));
    EXPECT_TRUE(message.starts_with("m.json:2: jobs[0].name is ")) << message;
  }
  EXPECT_EQ(
      ErrorOf("{\"seconds\": 1, \"jobs\": [\n{\"scenario\": \"a\"},\n{\"scenario\": \"a\"}]}"),
      "m.json:3: two jobs are called 'a', the first on line 2; give one another 'name'");
  EXPECT_EQ(ErrorInLine2(R"("seconds": 1, "scenarios": ["a"], "seeds": [1, 1])"),
            "m.json:2: two jobs are called 'a-1', the first on line 2; give one another 'name'");
  EXPECT_EQ(Parse(R"({"seconds": 1, "scenarios": ["x/.my world.json"]})")[0].name, "_.my_world");
}

TEST(BatchManifest, MillionsOfJobsAreRefusedBeforeTheyTakeMemory) {
  EXPECT_EQ(ErrorInLine2(R"("seconds": 1, "scenarios": ["a"],
                            "seeds": {"from": 0, "to": 9223372036854775807})"),
            "m.json:3: seeds are more than 100000");
  EXPECT_EQ(ErrorInLine2(R"("seconds": 1, "scenarios": ["a", "b"],
                            "seeds": {"from": 1, "to": 100000})"),
            "m.json:2: scenarios make more than 100000 jobs");
}

class BatchManifestFiles : public ::testing::Test {
 protected:
  std::string Write(const std::string& name, const std::string& text, bool program = false) {
    const std::filesystem::path path = std::filesystem::path(folder_.path()) / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
    if (program) ::chmod(path.c_str(), 0755);
    return path.string();
  }

  TemporaryFolder folder_;
};

TEST_F(BatchManifestFiles, RelativePathsStartAtTheManifestsFolder) {
  Write("scenes/mine.json", R"({"seed": 5})");
  Write("bin/go", "#!/bin/sh\n", true);
  const auto jobs = LoadManifest(Write("m/m.json", R"({"seconds": 1, "jobs": [
    {"scenario": "../scenes/mine.json", "program": "../bin/go"},
    {"scenario": "docks", "seed": 3, "program": "sh"}]})"));
  EXPECT_EQ(jobs[0].scenario_file, folder_.path() + "/scenes/mine.json");
  EXPECT_EQ(jobs[0].program_file, folder_.path() + "/bin/go");
  EXPECT_EQ(jobs[0].seed, 5) << "the scenario's own";
  EXPECT_EQ(std::filesystem::path(jobs[1].scenario_file).filename(), "docks.json");
  EXPECT_TRUE(std::filesystem::path(jobs[1].program_file).is_absolute());
  EXPECT_EQ(jobs[1].seed, 3);
}

TEST_F(BatchManifestFiles, WhatIsMissingIsSaidBeforeAnyJobRuns) {
  const std::string file =
      Write("m.json", "{\"seconds\": 1, \"jobs\": [\n{\"scenario\": \"syrotk\"}]}");
  EXPECT_TRUE(ErrorOfFile(file).starts_with(file + ":2: no scenario 'syrotk'"))
      << ErrorOfFile(file);
  Write("m.json", "{\"jobs\": [{\"scenario\": \"docks\",\n\"program\": \"./nothing\"}]}");
  EXPECT_EQ(ErrorOfFile(file), file +
                                   ":2: there is no program './nothing' that may be run, looked "
                                   "in " +
                                   folder_.path());
  Write("m.json", "{\"jobs\": [{\"scenario\": \"docks\",\n\"program\": \"no_such_command\"}]}");
  EXPECT_EQ(ErrorOfFile(file), file +
                                   ":2: there is no program 'no_such_command' that may be run, "
                                   "looked in " +
                                   folder_.path() + " and $PATH");
  const std::string bad = Write("bad.json", "{\n\"robtos\": []}");
  Write("m.json", R"({"seconds": 1, "scenarios": ["docks", "bad.json"]})");
  EXPECT_TRUE(ErrorOfFile(file).starts_with(bad + ":2: unknown key 'robtos'")) << ErrorOfFile(file);
}

}  // namespace
}  // namespace ccmorse::tools
