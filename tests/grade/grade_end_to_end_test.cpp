// `ccmorse grade` as people use it: submissions are built and run in the sandbox, and judged.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

namespace fs = std::filesystem;

const std::string kHere = std::string(CCMORSE_SOURCE_DIR) + "/tests/grade";
const std::string kCourses = std::string(CCMORSE_SOURCE_DIR) + "/courses/par/";

constexpr int kNotPassed = 3;

struct Graded {
  int status = -1;
  Json json;
  std::string output;
  double score() const { return json.Find("score")->AsDouble(); }
  std::string failure() const {
    const Json::Array& runs = json.Find("runs")->AsArray();
    return runs.empty() ? json.Find("build_failure")->AsString()
                        : runs[0].Find("failure")->AsString();
  }
  std::string note() const {
    const Json::Array& runs = json.Find("runs")->AsArray();
    return runs.empty() ? "" : runs[0].Find("note")->AsString();
  }
  // Reasons of all criteria.
  std::string reasons() const {
    std::string all;
    for (const Json& each : json.Find("criteria")->AsArray()) {
      all += each.Find("reason")->AsString() + "\n";
    }
    return all;
  }
};

Graded Grade(const std::string& task, const std::string& submission,
             const std::vector<std::string>& options = {}) {
  const TemporaryFolder folder;
  const std::string json = folder.path() + "/grade.json";
  std::vector<std::string> command = {
      BuiltProgram("ccmorse"), "grade", task, submission, "--quiet", "--json", json};
  command.insert(command.end(), options.begin(), options.end());
  const Finished finished = RunToEnd(command, std::chrono::seconds(110));
  Graded graded;
  graded.status = finished.status;
  graded.output = finished.output;
  if (fs::exists(json)) graded.json = Json::Parse(ReadFile(json));
  return graded;
}

// Grades a class of the task for tests, a world each.
std::vector<std::string> ClassCommand(const std::string& students, const std::string& out) {
  return {BuiltProgram("ccmorse"),
          "grade",
          kHere + "/task",
          "--class",
          students,
          "--out",
          out,
          "--seeds",
          "1"};
}

// Submissions link the library of this build, which under a sanitizer needs its run time first and
// more memory than any limit; and a machine may forbid namespaces.
class GradeTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::string(CCMORSE_SANITIZE).empty()) GTEST_SKIP() << "submissions are built as users do";
    const Finished tried = RunToEnd({"/usr/bin/env", "bwrap", "--unshare-all", "--ro-bind", "/",
                                     "/", "--proc", "/proc", "/bin/true"});
    if (tried.status != 0) GTEST_SKIP() << "no sandbox can be made here: " << tried.output;
  }
  static Graded OneOfTheTask(const std::string& submission) {
    const Graded graded = Grade(kHere + "/task", kHere + "/" + submission, {"--seeds", "1"});
    EXPECT_TRUE(graded.json.IsObject()) << graded.output;
    return graded;
  }
};

TEST_F(GradeTest, AGoodSubmissionPasses) {
  const Graded graded = OneOfTheTask("good");
  EXPECT_EQ(graded.status, 0) << graded.output;
  EXPECT_EQ(graded.score(), 100.0) << graded.json.Dump();
  EXPECT_TRUE(graded.json.Find("sandbox")->AsBool());
}

struct Hostile {
  const char* name;
  const char* reason;
  const char* note = "";
};

void PrintTo(const Hostile& hostile, std::ostream* out) { *out << hostile.name; }

class HostileTest : public GradeTest, public ::testing::WithParamInterface<Hostile> {};

TEST_P(HostileTest, CountsNothingAndTheReasonIsGiven) {
  const Hostile& hostile = GetParam();
  const Graded graded = OneOfTheTask(std::string("hostile/") + hostile.name);
  EXPECT_EQ(graded.status, kNotPassed) << graded.output;
  EXPECT_EQ(graded.score(), 0.0);
  EXPECT_NE(graded.failure().find(hostile.reason), std::string::npos) << graded.failure();
  EXPECT_NE(graded.note().find(hostile.note), std::string::npos) << graded.note();
  EXPECT_EQ(graded.note().find("FOUND"), std::string::npos) << graded.note();
}

INSTANTIATE_TEST_SUITE_P(
    All, HostileTest,
    ::testing::Values(
        Hostile{"bad_build", "make: exit status 2"}, Hostile{"crash", "crashed: killed by SIGSEGV"},
        Hostile{"exit_at_once", "never asked for the robot's data"},
        Hostile{"flood", "flooded the simulator"}, Hostile{"fork_bomb", "more than 16 processes"},
        Hostile{"hang", "not over after 8 s"}, Hostile{"hidden_world", "get_scene_objects"},
        Hostile{"memory", "more than 200 MB of memory"},
        // 7: they came to their end, and what they tried did not work.
        Hostile{"others_canvas", "never asked", "exit status 7"},
        Hostile{"output", "printed more than 1 MB"},
        Hostile{"spin", "more than 2 s of processor time"},
        Hostile{"teleport", "set_object_position"},
        Hostile{"watcher_killer", "never asked", "exit status 7"}),
    [](const auto& each) { return std::string(each.param.name); });

// Programs that break no rule, and do not what the task asks for: a template with some files of
// tests/grade/fools/NAME over it.
struct Fool {
  const char* name;
  const char* task;
  double least;  // points, by which it is seen to have run
  double most;
  const char* note = "";
};

void PrintTo(const Fool& fool, std::ostream* out) { *out << fool.name; }

class FoolTest : public GradeTest, public ::testing::WithParamInterface<Fool> {};

TEST_P(FoolTest, DoesNotPass) {
  const Fool& fool = GetParam();
  const TemporaryFolder folder;
  const std::string task = std::string(CCMORSE_SOURCE_DIR) + "/courses/" + fool.task;
  const std::string submission = folder.path() + "/" + fool.name;
  fs::copy(task + "/template", submission, fs::copy_options::recursive);
  fs::copy(kHere + "/fools/" + fool.name, submission,
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  const Graded graded = Grade(task, submission, {"--seeds", "2"});
  EXPECT_EQ(graded.status, kNotPassed) << graded.output;
  EXPECT_EQ(graded.failure(), "");
  EXPECT_GE(graded.score(), fool.least) << graded.output;
  EXPECT_LE(graded.score(), fool.most) << graded.output;
  EXPECT_NE(graded.note().find(fool.note), std::string::npos) << graded.json.Dump();
}

INSTANTIATE_TEST_SUITE_P(
    All, FoolTest,
    ::testing::Values(Fool{"intro_circle", "par/intro", 5, 15},
                      Fool{"exploration_free_map", "par/exploration", 0, 15},
                      // 7: what knows the robot's place is not there.
                      Fool{"dead_reckoning_true_pose", "syrotek/dead_reckoning", 5, 40,
                           "exit status 7"},
                      Fool{"two_robots_one_stays", "syrotek/two_robots", 0, 15},
                      Fool{"wall_following_shuttle", "syrotek/wall_following", 25, 35}),
    [](const auto& each) { return std::string(each.param.name); });

TEST_F(GradeTest, RecordsAreKeptAndJudgedAlone) {
  const TemporaryFolder folder;
  const Graded graded = Grade(kHere + "/task", kHere + "/good",
                              {"--seeds", "2", "--first-seed", "4", "--keep-records", folder.path(),
                               "--report", folder.path() + "/report.html"});
  ASSERT_EQ(graded.status, 0) << graded.output;
  EXPECT_EQ(graded.json.Find("runs")->AsArray().size(), 2U);
  EXPECT_EQ(
      RunToEnd({BuiltProgram("ccmorse"), "replay", folder.path() + "/world-4.mcap", "--verify"})
          .status,
      0);
  const Finished again = RunToEnd({BuiltProgram("ccmorse"), "grade", kHere + "/task", "--record",
                                   folder.path() + "/world-5.mcap", "--json", "-"});
  ASSERT_EQ(again.status, 0) << again.output;
  const Json json = Json::Parse(again.output);
  EXPECT_EQ(json.Find("score")->AsDouble(), 100.0);
  EXPECT_EQ(*json.Find("runs")->AsArray()[0].Find("hash"),
            *graded.json.Find("runs")->AsArray()[1].Find("hash"));
  const std::string page = ReadFile(folder.path() + "/report.html");
  EXPECT_NE(page.find("ccmorse replay " + folder.path() + "/world-4.mcap"), std::string::npos);
  // Nothing is fetched from elsewhere.
  EXPECT_EQ(page.find("http"), std::string::npos);
  EXPECT_EQ(page.find("src="), std::string::npos);
}

TEST_F(GradeTest, WithoutAMakefileCmakeBuildsIt) {
  const TemporaryFolder folder;
  const std::string task = std::string(CCMORSE_SOURCE_DIR) + "/courses/par/planning";
  const std::string mine = folder.path() + "/mine";
  fs::create_directories(mine + "/build");
  for (const char* part : {"template", "solutions/dijkstra"}) {
    for (const auto& entry : fs::directory_iterator(task + "/" + part)) {
      const std::string type = entry.path().extension();
      if (type != ".cc" && type != ".h") continue;
      fs::copy(entry.path(), mine, fs::copy_options::overwrite_existing);
    }
  }
  std::ofstream(mine + "/CMakeLists.txt")
      << "cmake_minimum_required(VERSION 3.18)\nproject(planner LANGUAGES CXX)\n"
         "find_package(CCMorse REQUIRED)\n"
         "ccmorse_add_program(planner planner.cc dilation.cc planner_base.cc planner_main.cc)\n";
  std::ofstream(mine + "/build/CMakeCache.txt") << "of another machine, and left out\n";
  const Graded graded = Grade("planning", mine, {"--seeds", "1"});
  EXPECT_EQ(graded.status, 0) << graded.output;
  EXPECT_GE(graded.score(), 85.0) << graded.output;
}

TEST_F(GradeTest, WhoHandsInAnewIsGradedAnew) {
  const TemporaryFolder folder;
  const std::string students = folder.path() + "/students";
  fs::create_directories(students);
  for (const char* name : {"anna", "bert"}) {
    fs::copy(kHere + "/good", students + "/" + name, fs::copy_options::recursive);
  }
  const std::vector<std::string> command = ClassCommand(students, folder.path() + "/out");
  ASSERT_EQ(RunToEnd(command).status, 0);
  fs::copy(kHere + "/hostile/crash", students + "/bert",
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  const Finished again = RunToEnd(command);
  ASSERT_EQ(again.status, 0) << again.output;
  EXPECT_NE(again.output.find("1 of 2 submissions were graded before, 1 "), std::string::npos)
      << again.output;
  const std::string csv = ReadFile(folder.path() + "/out/class.csv");
  EXPECT_NE(csv.find("1,\"anna\",100.00,yes"), std::string::npos) << csv;
  EXPECT_NE(csv.find("2,\"bert\",0.00,no"), std::string::npos) << csv;
}

TEST_F(GradeTest, TheSameSubmissionGetsTheSameResult) {
  const Graded first = OneOfTheTask("good");
  for (int i = 1; i < 10; ++i) EXPECT_EQ(OneOfTheTask("good").json.Dump(), first.json.Dump());
}

// Everything that lies in the tasks' folders, so that a new task cannot be forgotten.
struct Submission {
  std::string task;    // its folder
  std::string folder;  // of the template, or a solution
  bool is_template;
};

void PrintTo(const Submission& submission, std::ostream* out) { *out << submission.folder; }

std::vector<Submission> AllSubmissions() {
  std::vector<Submission> all;
  for (const auto& course : fs::directory_iterator(std::string(CCMORSE_SOURCE_DIR) + "/courses")) {
    if (!course.is_directory()) continue;
    for (const auto& task : fs::directory_iterator(course)) {
      if (!fs::exists(task.path() / "rubric.json")) continue;
      all.push_back({task.path(), task.path() / "template", true});
      for (const auto& each : fs::directory_iterator(task.path() / "solutions")) {
        all.push_back({task.path(), each.path(), false});
      }
    }
  }
  std::sort(all.begin(), all.end(),
            [](const Submission& a, const Submission& b) { return a.folder < b.folder; });
  return all;
}

TEST(Tasks, AreAllThere) { EXPECT_GE(AllSubmissions().size(), 20U); }

class TaskTest : public GradeTest, public ::testing::WithParamInterface<Submission> {
 protected:
  static Graded OneWorld() {
    // Exploration's seed 3 is the course's own world.
    const bool third = fs::path(GetParam().task).filename() == "exploration";
    Graded graded = Grade(GetParam().task, GetParam().folder,
                          {"--seeds", "1", "--first-seed", third ? "3" : "1"});
    EXPECT_TRUE(graded.json.IsObject()) << graded.output;
    return graded;
  }
};

TEST_P(TaskTest, SolutionsPassAndTemplatesLearnWhatToDo) {
  const Graded graded = OneWorld();
  if (GetParam().is_template) {
    EXPECT_EQ(graded.status, kNotPassed) << graded.output;
    EXPECT_LT(graded.score(), 15.0) << graded.output;
    EXPECT_EQ(graded.failure(), "");
    for (const Json& each : graded.json.Find("criteria")->AsArray()) {
      if (each.Find("points")->AsDouble() >= each.Find("weight")->AsDouble()) continue;
      EXPECT_GT(each.Find("reason")->AsString().size(), 20U) << each.Dump();
    }
  } else if (fs::path(GetParam().folder).filename() == "thesis") {
    // Reacts to what is ahead and remembers nothing: its README says that it does not come far.
    EXPECT_EQ(graded.failure(), "");
    EXPECT_GT(graded.score(), 0.0) << graded.output;
  } else {
    EXPECT_EQ(graded.status, 0) << graded.output;
    EXPECT_GE(graded.score(), 85.0) << graded.output;
  }
}

INSTANTIATE_TEST_SUITE_P(All, TaskTest, ::testing::ValuesIn(AllSubmissions()),
                         [](const auto& each) {
                           return fs::path(each.param.task).filename().string() + "_" +
                                  fs::path(each.param.folder).filename().string();
                         });

TEST_F(GradeTest, PlanningInTheArenaIsGradedToo) {
  const Graded graded = Grade("planning", kCourses + "planning/solutions/dijkstra",
                              {"--first-seed", "2", "--seeds", "1"});
  EXPECT_EQ(graded.status, 0) << graded.output;
  EXPECT_GE(graded.score(), 85.0) << graded.output;
}

TEST_F(GradeTest, PlanningsEmptyTemplateFailsWithAReason) {
  const Graded empty = Grade("planning", kCourses + "planning/template", {"--seeds", "1"});
  EXPECT_EQ(empty.status, kNotPassed) << empty.output;
  EXPECT_EQ(empty.score(), 0.0);
  EXPECT_NE(empty.reasons().find("handed in no \"path\""), std::string::npos) << empty.reasons();
  EXPECT_NE(empty.note().find("There is no path"), std::string::npos) << empty.note();
}

TEST_F(GradeTest, AClassIsGradedResumedAndNoneStopsIt) {
  const TemporaryFolder folder;
  const std::string students = folder.path() + "/students";
  fs::create_directories(students);
  fs::copy(kHere + "/good", students + "/anna", fs::copy_options::recursive);
  fs::copy(kHere + "/hostile/crash", students + "/bert", fs::copy_options::recursive);
  fs::create_directories(students + "/empty");
  const std::vector<std::string> command = ClassCommand(students, folder.path() + "/out");
  const Finished first = RunToEnd(command);
  ASSERT_EQ(first.status, 0) << first.output;
  const std::string csv = ReadFile(folder.path() + "/out/class.csv");
  EXPECT_EQ(csv.find("place,submission,score,passed"), 0U) << csv;
  EXPECT_NE(csv.find("1,\"anna\",100.00,yes"), std::string::npos) << csv;
  EXPECT_NE(csv.find("2,\"bert\",0.00,no"), std::string::npos) << csv;
  EXPECT_NE(csv.find("SIGSEGV"), std::string::npos) << csv;
  EXPECT_NE(csv.find("no Makefile"), std::string::npos) << csv;
  EXPECT_NE(ReadFile(folder.path() + "/out/class.html").find("anna/report.html"),
            std::string::npos);
  EXPECT_TRUE(fs::exists(folder.path() + "/out/anna/report.html"));

  // As after an interruption: one result is missing, and only that one is made again.
  std::istringstream lines(ReadFile(folder.path() + "/out/results.jsonl"));
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("\"bert\"") == std::string::npos) kept += line + "\n";
  }
  std::ofstream(folder.path() + "/out/results.jsonl") << kept;
  fs::remove_all(folder.path() + "/out/anna");
  const Finished second = RunToEnd(command);
  ASSERT_EQ(second.status, 0) << second.output;
  EXPECT_NE(second.output.find("2 of 3 submissions were graded before"), std::string::npos)
      << second.output;
  EXPECT_EQ(ReadFile(folder.path() + "/out/class.csv"), csv);
  EXPECT_FALSE(fs::exists(folder.path() + "/out/anna"));
}

TEST_F(GradeTest, WithoutASandboxItSaysSo) {
  const Graded graded = Grade(kHere + "/task", kHere + "/good", {"--seeds", "1", "--no-sandbox"});
  EXPECT_EQ(graded.status, 0) << graded.output;
  EXPECT_FALSE(graded.json.Find("sandbox")->AsBool());
  EXPECT_NE(graded.output.find("without sandbox"), std::string::npos) << graded.output;
}

TEST(Grade, RefusesWhereNoSandboxCanBeMade) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() + "/bwrap")
      << "#!/bin/sh\necho 'bwrap: No permissions' >&2\nexit 1\n";
  fs::permissions(folder.path() + "/bwrap", fs::perms::owner_all);
  for (const auto& [path, expected] :
       {std::pair(folder.path(), std::string("No permissions")),
        std::pair(folder.path() + "/nothing", std::string("not installed"))}) {
    const Finished refused = RunToEnd({"/usr/bin/env", "PATH=" + path, BuiltProgram("ccmorse"),
                                       "grade", kHere + "/task", kHere + "/good"});
    EXPECT_EQ(refused.status, 1) << refused.output;
    EXPECT_NE(refused.output.find(expected), std::string::npos) << refused.output;
    EXPECT_NE(refused.output.find("--no-sandbox"), std::string::npos) << refused.output;
  }
}

TEST(Grade, NamesTheTasksThereAre) {
  const Finished finished =
      RunToEnd({BuiltProgram("ccmorse"), "grade", "planing", kHere + "/good"});
  EXPECT_EQ(finished.status, 1);
  EXPECT_NE(finished.output.find("did you mean 'planning'"), std::string::npos) << finished.output;
}

}  // namespace
}  // namespace ccmorse::testing
