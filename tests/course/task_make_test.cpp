// Templates and solutions as students build them: by their Makefiles, in a copy of the course's
// folder, with the libraries of this build.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <string>

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
    fs::copy(std::string(CCMORSE_SOURCE_DIR) + "/courses/par", root_.path() + "/par",
             fs::copy_options::recursive);
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
  const std::string folder = root_.path() + "/par/" + GetParam().folder;
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

INSTANTIATE_TEST_SUITE_P(Planning, T02,
                         testing::Values(Pack{"planning/template", "planner"},
                                         Pack{"planning/solutions/dijkstra", "planner"},
                                         Pack{"planning/solutions/theta_star", "planner"}));

INSTANTIATE_TEST_SUITE_P(Exploration, T02,
                         testing::Values(Pack{"exploration/template", "explorer"},
                                         Pack{"exploration/solutions/nearest_frontier", "explorer"},
                                         Pack{"exploration/solutions/information_gain",
                                              "explorer"}));

// The template alone, somewhere else: with the settings copied along it needs nothing but CCMorse.
TEST_P(T01, TemplateMayStandAlone) {
  const std::string folder = root_.path() + "/mine";
  fs::copy(root_.path() + "/par/" + GetParam().folder, folder);
  for (const char* file : {"task.mk", "ccmorse.mk"}) {
    fs::copy(root_.path() + "/par/" + file, folder + "/" + file);
  }
  const Finished made = Make(folder, "");
  ASSERT_EQ(made.status, 0) << made.output;
  ExpectPlatform(folder + "/" + GetParam().program, "morse server hostname [localhost]");
}

INSTANTIATE_TEST_SUITE_P(Planning, T01, testing::Values(Pack{"planning/template", "planner"}));
INSTANTIATE_TEST_SUITE_P(Exploration, T01,
                         testing::Values(Pack{"exploration/template", "explorer"}));
