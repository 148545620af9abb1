// Templates and solutions as students build them: by their Makefiles, in a copy of the course's
// folder, with the libraries of this build.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "tests/support/process.h"

namespace {

namespace fs = std::filesystem;
using ccmorse::testing::Finished;
using ccmorse::testing::RunToEnd;

struct Pack {
  const char* folder;
  const char* program;
};

void PrintTo(const Pack& pack, std::ostream* out) { *out << pack.folder; }

class TaskMakefile : public testing::TestWithParam<Pack> {
 protected:
  TaskMakefile() {
    for (const char* course : {"common", "par", "syrotek"}) {
      fs::copy(std::string(CCMORSE_SOURCE_DIR "/courses/") + course, root_.path() + "/" + course,
               fs::copy_options::recursive);
    }
    for (const char* variable : {"MORSE", "CCMORSE_DIR", "CCMORSE_LIBDIR", "CPPFLAGS", "CXXFLAGS",
                                 "LDFLAGS", "CXX", "MAKEFLAGS", "MFLAGS"}) {
      unsetenv(variable);
    }
  }

  Finished Make(const std::string& folder, const std::string& arguments) const {
    const std::string sanitizer = CCMORSE_SANITIZE;
    const std::string flags = sanitizer.empty() ? "" : " -fsanitize=" + sanitizer;
    return RunToEnd(
        {"sh", "-c",
         "cd '" + folder + "' && " + (flags.empty() ? "" : "LDFLAGS='" + flags + "' ") +
             "make CCMORSE_DIR='" CCMORSE_SOURCE_DIR "' CCMORSE_LIBDIR='" CCMORSE_BINARY_DIR
             "/lib' CXXFLAGS='-O0 -Wall -Wextra -Werror" +
             flags + "' " + arguments},
        std::chrono::seconds(100));
  }

  const ccmorse::testing::TemporaryFolder root_;
};

using T01 = TaskMakefile;
using T02 = TaskMakefile;

// The program that was built says which platform it is for.
void ExpectPlatform(const std::string& program, const std::string& words) {
  const Finished help = RunToEnd({program, "--help"});
  EXPECT_EQ(help.status, 0) << help.output;
  EXPECT_NE(help.output.find(words), std::string::npos) << help.output;
}

}  // namespace

TEST_P(T02, BuildsForTheSimulatorAndTheRealRobot) {
  const std::string folder = root_.path() + "/" + GetParam().folder;
  const std::string program = folder + "/" + GetParam().program;
  for (const char* file : {"obj-morse", "obj-syrotek"}) fs::remove_all(folder + "/" + file);
  fs::remove(program);
  fs::remove(program + "-syrotek");
  const Finished morse = Make(folder, "");
  ASSERT_EQ(morse.status, 0) << morse.output;
  const Finished syrotek = Make(folder, "MORSE='NO '");
  ASSERT_EQ(syrotek.status, 0) << syrotek.output;
  ExpectPlatform(program, "morse server hostname [localhost]");
  ExpectPlatform(program + "-syrotek", "syrotek server hostname [syrotek.felk.cvut.cz]");
  const Finished symbols = RunToEnd({"nm", "-C", program + "-syrotek"});
  EXPECT_EQ(symbols.status, 0);
  EXPECT_NE(symbols.output.find("PlayerClient"), std::string::npos);
  EXPECT_EQ(symbols.output.find("WindowProxy"), std::string::npos);
  // Nobody listens on port 1: one line that says so, and no crash.
  const std::string options = GetParam().program == std::string("planner")
                                  ? " --map '" CCMORSE_SOURCE_DIR
                                    "/courses/par/planning/maps/arena.txt'"
                                  : "";
  const Finished nobody =
      RunToEnd({"sh", "-c", program + "-syrotek --host 127.0.0.1 --port 1" + options});
  EXPECT_EQ(nobody.status, 1) << nobody.output;
  EXPECT_NE(nobody.output.find("ERROR: "), std::string::npos) << nobody.output;
  EXPECT_EQ(Make(folder, "clean").status, 0);
  EXPECT_FALSE(fs::exists(program));
}

// T15: two solutions of each of the course's tasks; and of each follow-up task one.
const auto kTemplates = testing::Values(
    Pack{"par/intro/template", "intro"}, Pack{"par/planning/template", "planner"},
    Pack{"par/exploration/template", "explorer"},
    Pack{"syrotek/wall_following/template", "wall_following"}, Pack{"syrotek/pid/template", "pid"},
    Pack{"syrotek/dead_reckoning/template", "dead_reckoning"},
    Pack{"syrotek/trajectory/template", "trajectory"},
    Pack{"syrotek/two_robots/template", "two_robots"});
const auto kSolutions = testing::Values(
    Pack{"par/intro/solutions/wall_following", "intro"},
    Pack{"par/intro/solutions/braitenberg", "intro"}, Pack{"par/intro/solutions/thesis", "intro"},
    Pack{"par/planning/solutions/dijkstra", "planner"},
    Pack{"par/planning/solutions/theta_star", "planner"},
    Pack{"par/exploration/solutions/nearest_frontier", "explorer"},
    Pack{"par/exploration/solutions/information_gain", "explorer"},
    Pack{"syrotek/wall_following/solutions/pd", "wall_following"},
    Pack{"syrotek/pid/solutions/tuned", "pid"},
    Pack{"syrotek/dead_reckoning/solutions/calibrated", "dead_reckoning"},
    Pack{"syrotek/trajectory/solutions/kanayama", "trajectory"},
    Pack{"syrotek/two_robots/solutions/keep_right", "two_robots"});

INSTANTIATE_TEST_SUITE_P(Templates, T02, kTemplates);
INSTANTIATE_TEST_SUITE_P(Solutions, T02, kSolutions);

// The template alone, somewhere else: with the settings copied along it needs nothing but CCMorse.
TEST_P(T01, TemplateMayStandAlone) {
  const std::string folder = root_.path() + "/mine";
  fs::copy(root_.path() + "/" + GetParam().folder, folder);
  for (const char* file : {"task.mk", "ccmorse.mk"}) {
    fs::copy(root_.path() + "/common/" + file, folder + "/" + file);
  }
  const Finished made = Make(folder, "");
  ASSERT_EQ(made.status, 0) << made.output;
  ExpectPlatform(folder + "/" + GetParam().program, "morse server hostname [localhost]");
}

INSTANTIATE_TEST_SUITE_P(Templates, T01, kTemplates);

// Where students' own copies look for the settings since before there was courses/common.
TEST(CourseSettings, AreStillFoundInEachCourse) {
  for (const char* course : {"par", "syrotek"}) {
    for (const char* file : {"task.mk", "ccmorse.mk"}) {
      const std::string courses = CCMORSE_SOURCE_DIR "/courses/";
      EXPECT_EQ(ccmorse::ReadFile(courses + course + "/" + file),
                ccmorse::ReadFile(courses + "common/" + file));
    }
  }
}

// T03: the templates leave room for students' own classes: what a task needs stands in the README,
// and the file that is theirs names the tasks one by one.
TEST(T03, EveryTaskTellsWhatToWriteAndAllowsMore) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> tasks = {
      {"par/intro", {"behaviour.cc"}},
      {"par/planning", {"planner.cc"}},
      {"par/exploration", {"control.cc", "map_grid.cc", "exploration.cc"}},
      {"syrotek/wall_following", {"behaviour.cc"}},
      {"syrotek/pid", {"pid.cc"}},
      {"syrotek/dead_reckoning", {"reckoning.cc"}},
      {"syrotek/trajectory", {"follow.cc"}},
      {"syrotek/two_robots", {"behaviour.cc"}}};
  for (const auto& [task, files] : tasks) {
    const std::string folder = CCMORSE_SOURCE_DIR "/courses/" + task;
    const std::string readme = ccmorse::ReadFile(folder + "/README.md");
    EXPECT_NE(readme.find("**the task**"), std::string::npos) << task;
    EXPECT_NE(readme.find("should look like"), std::string::npos) << task;
    for (const std::string& file : files) {
      EXPECT_NE(readme.find(file), std::string::npos) << task;
      EXPECT_NE(ccmorse::ReadFile(folder + "/template/" + file).find("TASK"), std::string::npos)
          << task << ", " << file;
    }
  }
  EXPECT_NE(ccmorse::ReadFile(CCMORSE_SOURCE_DIR "/courses/par/intro/README.md")
                .find("Students work in pairs, and may add classes and files"),
            std::string::npos);
}
