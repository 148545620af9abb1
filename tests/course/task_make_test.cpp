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
             "make -j2 CCMORSE_DIR='" CCMORSE_SOURCE_DIR "' CCMORSE_LIBDIR='" CCMORSE_BINARY_DIR
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

// The template alone, somewhere else: with the settings copied along it needs nothing but CCMorse,
// and makes both programs. CMake builds all of them with the project's warnings, too.
TEST_P(T02, TemplateMayStandAloneAndBuildsForTheSimulatorAndTheRealRobot) {
  const std::string folder = root_.path() + "/mine";
  fs::copy(root_.path() + "/" + GetParam().folder, folder);
  for (const char* file : {"task.mk", "ccmorse.mk"}) {
    fs::copy(root_.path() + "/common/" + file, folder + "/" + file);
  }
  const std::string program = folder + "/" + GetParam().program;
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

// The same with CMake, which makes both programs at once.
TEST_P(T02, TemplateBuildsWithCmakeToo) {
  const std::string folder = root_.path() + "/mine";
  fs::copy(root_.path() + "/" + GetParam().folder, folder);
  const std::string sanitizer = CCMORSE_SANITIZE;
  const std::string flags = sanitizer.empty() ? "" : " -fsanitize=" + sanitizer;
  const Finished made = RunToEnd({"sh", "-c",
                                  "cd '" + folder +
                                      "' && CCMORSE_DIR='" CCMORSE_SOURCE_DIR
                                      "' cmake -B build -D CCMORSE_LIBDIR='" CCMORSE_BINARY_DIR
                                      "/lib' -D CMAKE_CXX_FLAGS='-O0" +
                                      flags + "' && cmake --build build -j2"},
                                 std::chrono::seconds(100));
  ASSERT_EQ(made.status, 0) << made.output;
  const std::string program = folder + "/build/" + GetParam().program;
  ExpectPlatform(program, "morse server hostname [localhost]");
  ExpectPlatform(program + "-syrotek", "syrotek server hostname [syrotek.felk.cvut.cz]");
}

// In the course's folder, and by CCMORSE_DIR from anywhere, without any settings copied.
TEST_P(T01, TemplateFindsTheSettings) {
  const std::string folder = root_.path() + "/" + GetParam().folder;
  const Finished beside = Make(folder, "-n");
  EXPECT_EQ(beside.status, 0) << beside.output;
  const std::string alone = root_.path() + "/mine";
  fs::copy(folder, alone);
  const Finished anywhere = Make(alone, "-n");
  EXPECT_EQ(anywhere.status, 0) << anywhere.output;
}

class T15 : public TaskMakefile {};

// Its empty functions would be taken from the template, in silence.
TEST_P(T15, SolutionAloneSaysWhatIsMissing) {
  const std::string folder = root_.path() + "/par/elsewhere/solutions/alone";
  fs::create_directories(fs::path(folder).parent_path());
  fs::copy(root_.path() + "/" + GetParam().folder, folder);
  const std::string makefile = ccmorse::ReadFile(folder + "/Makefile");
  if (makefile.find("\nSOURCES") == std::string::npos) return;  // it needs nothing else
  const Finished made = Make(folder, "");
  EXPECT_NE(made.status, 0);
  EXPECT_NE(made.output.find("which is not there"), std::string::npos) << made.output;
}

TEST_P(T15, SolutionBuilds) {
  const std::string folder = root_.path() + "/" + GetParam().folder;
  for (const char* left : {"/obj-morse", "/obj-syrotek"}) fs::remove_all(folder + left);
  fs::remove(folder + "/" + GetParam().program);
  const Finished made = Make(folder, "");
  ASSERT_EQ(made.status, 0) << made.output;
  ExpectPlatform(folder + "/" + GetParam().program, "morse server hostname [localhost]");
  const Finished real = Make(folder, "-n MORSE=NO");
  EXPECT_EQ(real.status, 0) << real.output;
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
INSTANTIATE_TEST_SUITE_P(Templates, T01, kTemplates);
INSTANTIATE_TEST_SUITE_P(Solutions, T15, kSolutions);

// A teacher's zip, unpacked where there is ccmorse and nothing of the course: `make` works in the
// template and, where they came along, in the solutions.
class G11 : public TaskMakefile {};

TEST_P(G11, ATasksZipHasWhatMakeNeedsAndSolutionsOnlyIfWanted) {
  const std::string task = fs::path(root_.path() + "/" + GetParam().folder).parent_path();
  const std::string name = fs::path(task).filename();
  const auto ccmorse = [&](const std::string& words) {
    return RunToEnd({"sh", "-c",
                     "cd '" + root_.path() + "' && HOME='" + root_.path() + "' '" +
                         ccmorse::testing::BuiltProgram("ccmorse") + "' " + words});
  };
  const Finished all = ccmorse("export '" + task + "' -o all.zip");
  ASSERT_EQ(all.status, 0) << all.output;
  const Finished some = ccmorse("export '" + task + "' -o some.zip --without solutions/");
  ASSERT_EQ(some.status, 0) << some.output;
  const Finished wrong = ccmorse("export '" + task + "' -o none.zip --without solution");
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.output.find("did you mean 'solutions'"), std::string::npos) << wrong.output;
  EXPECT_FALSE(fs::exists(root_.path() + "/none.zip"));
  for (const char* course : {"common", "par", "syrotek"}) {
    fs::remove_all(root_.path() + "/" + course);
  }
  // The folder's name must not matter either.
  const std::string there = root_.path() + "/there/a/b";
  fs::create_directories(there);
  ASSERT_EQ(ccmorse("import all.zip colleagues --to '" + there + "/all'").status, 0);
  ASSERT_EQ(ccmorse("import some.zip students --to '" + there + "/some'").status, 0);
  EXPECT_TRUE(fs::exists(there + "/all/solutions"));
  EXPECT_FALSE(fs::exists(there + "/some/solutions"));
  for (const char* file : {"task.mk", "ccmorse.mk", "scenario.json", "rubric.json"}) {
    EXPECT_TRUE(fs::is_regular_file(there + "/some/" + file)) << file;
  }
  const Finished made = Make(there + "/some/template", "");
  EXPECT_EQ(made.status, 0) << made.output;
  EXPECT_TRUE(fs::exists(there + "/some/template/" + GetParam().program));
  for (const auto& solution : fs::directory_iterator(there + "/all/solutions")) {
    const Finished planned = Make(solution.path(), "-n");
    EXPECT_EQ(planned.status, 0) << planned.output;
  }
}

INSTANTIATE_TEST_SUITE_P(Tasks, G11,
                         testing::Values(Pack{"par/intro/template", "intro"},
                                         Pack{"syrotek/pid/template", "pid"}));

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
