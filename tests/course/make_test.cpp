// The course's Makefile and its switch between the two platforms (thesis 3.4), tried on a copy of
// the folder, so that nothing is built among the sources.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/course/match.h"

namespace {

namespace fs = std::filesystem;

struct Result {
  int status;
  std::string output;  // standard output and error
};

std::string ReadFile(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

class CourseMakefile : public testing::Test {
 protected:
  CourseMakefile() {
    std::string name = testing::TempDir() + "ccmorse_course_XXXXXX";
    if (mkdtemp(name.data()) == nullptr) std::abort();
    root_ = name;
    for (const char* file :
         {"Makefile", "robot.cc", "robot.h", "robot_main.cc", "robot_types.h", "avoidance.h"}) {
      fs::create_directories(root_ / "par/intro/solutions/thesis");
      fs::copy(kSource / "courses/par/intro/solutions/thesis" / file,
               root_ / "par/intro/solutions/thesis" / file);
    }
    fs::create_directories(root_ / "common");
    fs::copy(kSource / "courses/common/ccmorse.mk", root_ / "common/ccmorse.mk");
    // What the tests' own environment holds must not decide.
    for (const char* variable : {"MORSE", "CCMORSE_DIR", "CCMORSE_LIBDIR", "CPPFLAGS", "CXXFLAGS",
                                 "LDFLAGS", "CXX", "MAKEFLAGS", "MFLAGS", "PKG_CONFIG_PATH"}) {
      unsetenv(variable);
    }
    setenv("PKG_CONFIG_LIBDIR", "/nonexistent", 1);
  }
  ~CourseMakefile() override { fs::remove_all(root_); }

  Result Run(const std::string& command) const {
    const std::string line =
        "cd '" + (root_ / "par/intro/solutions/thesis").string() + "' && { " + command + "; } 2>&1";
    FILE* pipe = popen(line.c_str(), "r");
    if (pipe == nullptr) return {-1, "cannot run " + line};
    Result result{0, ""};
    char buffer[4096];
    for (std::size_t n = 0; (n = fread(buffer, 1, sizeof(buffer), pipe)) > 0;) {
      result.output.append(buffer, n);
    }
    const int status = pclose(pipe);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return result;
  }

  // make with the library of this build.
  Result Make(const std::string& arguments) const {
    return Run("make CCMORSE_DIR='" + kSource.string() + "' CCMORSE_LIBDIR='" +
               (kBinary / "lib").string() + "' " + arguments);
  }

  // make -n with a distinct word in each of the course's variables.
  Result Marked(const std::string& arguments) const {
    return Make(
        "-n CCMORSE_CPPFLAGS=-DCCMORSE_C BOOST_CPPFLAGS=-DBOOST_C IMRH_CPPFLAGS=-DIMRH_C "
        "PLAH_CPPFLAGS=-DPLAH_C CCMORSE_LDFLAGS=-lccmorse_l BOOST_LDFLAGS=-lboost_l "
        "IMRH_LDFLAGS=-limrh_l PLAH_LDFLAGS=-lplah_l " +
        arguments);
  }

  // A build under a sanitizer has libraries that only link with it.
  static std::string BuildFlags() {
    const std::string sanitizer = CCMORSE_SANITIZE;
    if (sanitizer.empty()) return "CXXFLAGS='-O0 -Wall -Wextra -Werror'";
    // make appends to LDFLAGS from the environment, but not to those on its command line.
    setenv("LDFLAGS", ("-fsanitize=" + sanitizer).c_str(), 1);
    return "CXXFLAGS='-O0 -Wall -Wextra -Werror -fsanitize=" + sanitizer + "'";
  }

  void ReplaceInMakefile(const std::string& from, const std::string& to) const {
    std::string text = ReadFile(root_ / "par/intro/solutions/thesis/Makefile");
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, from.size(), to);
    std::ofstream(root_ / "par/intro/solutions/thesis/Makefile") << text;
  }

  static bool Has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  const fs::path kSource = CCMORSE_SOURCE_DIR;
  const fs::path kBinary = CCMORSE_BINARY_DIR;
  fs::path root_;
};

using B01 = CourseMakefile;
using B02 = CourseMakefile;
using B03 = CourseMakefile;
using B04 = CourseMakefile;
using B05 = CourseMakefile;
using B06 = CourseMakefile;
using B09 = CourseMakefile;
using Q02 = CourseMakefile;
using Q03 = CourseMakefile;
using X04 = CourseMakefile;
using X45 = CourseMakefile;

}  // namespace

TEST_F(B01, YesIsTheSimulatorAndAnythingElseTheRealRobot) {
  EXPECT_TRUE(Has(Make("-n").output, "-o intro\n"));
  EXPECT_TRUE(Has(Make("-n MORSE=YES").output, "-o intro\n"));
  for (const char* other : {"NO", "yes", "", "SYROTEK"}) {
    EXPECT_TRUE(Has(Make(std::string("-n MORSE=") + other).output, "-o intro-syrotek\n")) << other;
  }
}

TEST_F(B01, BothPlatformsBuildSideBySide) {
  const std::string flags = BuildFlags();
  const Result morse = Make(flags);
  ASSERT_EQ(morse.status, 0) << morse.output;
  const Result syrotek = Make(flags + " MORSE=NO");
  ASSERT_EQ(syrotek.status, 0) << syrotek.output;

  // Each program says which platform it is for, also after the other one was built.
  const Result help = Run("./intro --help");
  EXPECT_EQ(help.status, 0);
  EXPECT_TRUE(Has(help.output, "morse server hostname [localhost]")) << help.output;
  EXPECT_TRUE(Has(help.output, "--seconds NUMBER"));
  const Result syrotek_help = Run("./intro-syrotek --help");
  EXPECT_EQ(syrotek_help.status, 0);
  EXPECT_TRUE(Has(syrotek_help.output, "syrotek server hostname [syrotek.felk.cvut.cz]"))
      << syrotek_help.output;

  // Nothing is left to do for either, and a changed header makes both again.
  EXPECT_TRUE(Has(Make(flags).output, "Nothing to be done"));
  EXPECT_TRUE(Has(Make(flags + " MORSE=NO").output, "Nothing to be done"));
  const Result touched = Run("touch -d '+1 minute' avoidance.h");
  ASSERT_EQ(touched.status, 0);
  EXPECT_TRUE(Has(Make("-n").output, "-c robot.cc"));
  EXPECT_TRUE(Has(Make("-n MORSE=NO").output, "-c robot.cc"));

  // Wrong use ends with status 2 and one line that helps.
  const Result wrong = Run("./intro --prot 4000");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(wrong.output, "unknown option --prot; did you mean --port? (--help lists all)\n");
  EXPECT_EQ(Run("./intro --seconds -1").status, 2);
  // Port 1 of this machine: nobody answers there.
  const Result nobody = Run("./intro --host 127.0.0.1 --port 1");
  EXPECT_EQ(nobody.status, 1);
  EXPECT_TRUE(Has(nobody.output, "ERROR: Morse error: ")) << nobody.output;

  EXPECT_EQ(Make("clean").status, 0);
  EXPECT_FALSE(fs::exists(root_ / "par/intro/solutions/thesis/intro"));
  EXPECT_FALSE(fs::exists(root_ / "par/intro/solutions/thesis/obj-syrotek"));
}

TEST_F(B02, SimulatorCompilesWithItsFlags) {
  const Result result = Marked("MORSE=YES");
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_TRUE(Has(result.output, "-D _MORSE -DCCMORSE_C -DBOOST_C -DIMRH_C")) << result.output;
  EXPECT_FALSE(Has(result.output, "PLAH"));
}

TEST_F(B03, SimulatorLinksWithItsFlags) {
  const Result result = Marked("MORSE=YES");
  EXPECT_TRUE(Has(result.output, "-lccmorse_l -lboost_l -limrh_l")) << result.output;
  EXPECT_FALSE(Has(result.output, "-lplah_l"));
}

TEST_F(B04, RealRobotCompilesAndLinksWithItsFlagsAndObjects) {
  std::ofstream(root_ / "par/intro/solutions/thesis/plah.cc") << "\n";
  const Result result = Marked("MORSE=NO OBJSPLAH=plah.o");
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_TRUE(Has(result.output, "-DPLAH_C -DBOOST_C -DIMRH_C")) << result.output;
  EXPECT_TRUE(Has(result.output, "-lplah_l -lboost_l -limrh_l")) << result.output;
  EXPECT_FALSE(Has(result.output, "_MORSE"));
  EXPECT_FALSE(Has(result.output, "-DCCMORSE_C"));
  EXPECT_FALSE(Has(result.output, "-lccmorse_l"));
  EXPECT_TRUE(course::CountMatches(
                  result.output,
                  "obj-syrotek/robot_main\\.o obj-syrotek/plah\\.o [^\n]*-o intro-syrotek") > 0)
      << result.output;
}

TEST_F(B05, SymbolDecidesWhichLinesAreCompiled) {
  const std::string include = " -I'" + (kSource / "include").string() + "' ";
  const Result morse = Run("g++ -E -P -D _MORSE" + include + "robot.cc");
  const Result real = Run("g++ -E -P" + include + "robot.cc");
  ASSERT_EQ(morse.status, 0) << morse.output;
  ASSERT_EQ(real.status, 0) << real.output;
  EXPECT_TRUE(Has(morse.output, "\"morse server hostname\""));
  EXPECT_TRUE(Has(morse.output, "WindowProxy::GetInstance(client, 172, 186)"));
  EXPECT_FALSE(Has(morse.output, "\"syrotek server hostname\""));
  EXPECT_TRUE(Has(real.output, "\"syrotek server hostname\""));
  EXPECT_FALSE(Has(real.output, "\"morse server hostname\""));
}

TEST_F(B06, RealRobotsProgramKnowsNoWindowAndNoPen) {
  const std::string include = " -I'" + (kSource / "include").string() + "' ";
  const Result text = Run("g++ -E -P" + include + "robot.cc robot_main.cc");
  ASSERT_EQ(text.status, 0) << text.output;
  EXPECT_FALSE(Has(text.output, "WindowProxy"));
  EXPECT_FALSE(Has(text.output, "MorsePen"));
  const Result symbols = Run("g++ -O0 -c" + include + "robot.cc -o r.o && nm -C r.o");
  ASSERT_EQ(symbols.status, 0) << symbols.output;
  EXPECT_TRUE(Has(symbols.output, "CCMorse::LaserProxy::LaserProxy"));
  EXPECT_FALSE(Has(symbols.output, "WindowProxy"));
  EXPECT_FALSE(Has(symbols.output, "MorsePen"));
}

TEST_F(B09, TemplateHasTheListingsFilesAndClass) {
  for (const char* file : {"Makefile", "README.md", "robot.h", "robot.cc", "robot_types.h"}) {
    EXPECT_TRUE(fs::exists(kSource / "courses/par/intro/solutions/thesis" / file)) << file;
  }
  EXPECT_TRUE(Has(ReadFile(kSource / "courses/par/intro/solutions/thesis/robot.h"),
                  "class CRobot : public imr::concurrent::CThread"));
}

TEST_F(Q02, SymbolIsUnderscoreMorse) {
  const std::string text = ReadFile(kSource / "courses/par/intro/solutions/thesis/Makefile");
  EXPECT_TRUE(Has(text, "CPPFLAGS += -D _MORSE\n"));
  EXPECT_FALSE(Has(text, "-D MORSE"));
  // The words that the test under the name of B02 looks for are those of the Makefile.
  EXPECT_TRUE(Has(text, "CPPFLAGS += $(CCMORSE_CPPFLAGS) $(BOOST_CPPFLAGS) $(IMRH_CPPFLAGS)\n"));
  EXPECT_TRUE(Has(text, "OBJS += $(OBJSPLAH)\n"));
}

TEST_F(Q03, BlanksAroundTheValueDoNotMatter) {
  ReplaceInMakefile("MORSE = YES\n", "MORSE = YES  \t \n");
  EXPECT_TRUE(Has(Make("-n").output, "-o intro\n"));
  EXPECT_TRUE(Has(Make("-n MORSE=' YES '").output, "-o intro\n"));
  EXPECT_TRUE(Has(Make("-n MORSE='NO '").output, "-o intro-syrotek\n"));
}

TEST_F(CourseMakefile, PlatformsKeepTheirObjectsApart) {
  EXPECT_TRUE(Has(Make("-n MORSE=YES").output, "-o obj-morse/robot.o"));
  EXPECT_TRUE(Has(Make("-n MORSE=NO").output, "-o obj-syrotek/robot.o"));
}

TEST_F(CourseMakefile, FindsTheSourceTreeThatItIsPartOf) {
  // The tree is two levels above ccmorse.mk.
  const std::string tree = fs::weakly_canonical(root_ / "common/../..").string();
  const Result result = Run("make -n");
  EXPECT_TRUE(Has(result.output, "-I" + tree + "/include")) << result.output;
  EXPECT_TRUE(Has(result.output, "-L" + tree + "/build/release/lib -Wl,-rpath," + tree +
                                     "/build/release/lib -lCCMorse"))
      << result.output;
  EXPECT_TRUE(Has(result.output, "-limrh -pthread"));
}

TEST_F(CourseMakefile, FindsAnInstalledLibraryByPkgConfig) {
  fs::create_directories(root_ / "pc");
  std::ofstream(root_ / "pc/ccmorse.pc")
      << "prefix=/opt/ccmorse\nlibdir=${prefix}/lib64\nincludedir=${prefix}/include\n"
         "Name: ccmorse\nDescription: test\nVersion: 0\n";
  setenv("PKG_CONFIG_LIBDIR", (root_ / "pc").c_str(), 1);
  const Result result = Run("make -n");
  EXPECT_TRUE(Has(result.output, "-I/opt/ccmorse/include")) << result.output;
  EXPECT_TRUE(Has(result.output, "-L/opt/ccmorse/lib64 -Wl,-rpath,/opt/ccmorse/lib64 -lCCMorse"));
  // CCMORSE_DIR comes before it, and may be an installation, too.
  fs::create_directories(root_ / "prefix/lib");
  std::ofstream(root_ / "prefix/lib/libCCMorse.so") << "";
  const std::string prefix = (root_ / "prefix").string();
  const Result chosen = Run("make -n CCMORSE_DIR='" + prefix + "'");
  EXPECT_TRUE(Has(chosen.output, "-I" + prefix + "/include")) << chosen.output;
  EXPECT_TRUE(Has(chosen.output, "-L" + prefix + "/lib -Wl")) << chosen.output;
}

TEST_F(CourseMakefile, FolderMayStandAloneWithACopyOfItsSettings) {
  fs::copy(root_ / "common/ccmorse.mk", root_ / "par/intro/solutions/thesis/ccmorse.mk");
  fs::remove(root_ / "common/ccmorse.mk");
  const Result result = Make("-n");
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_TRUE(Has(result.output, "-o intro\n"));
}

TEST_F(X45, RobotSourceMapsTheThesissParts) {
  const std::string text = ReadFile(kSource / "courses/par/intro/solutions/thesis/robot.cc");
  for (const char* part :
       {"l.16-40", "l.42-71", "l.73-91", "l.93-109", "l.111-283", "l.114-132", "l.140-143",
        "l.146-181", "l.161-178", "l.183-201", "l.203-229", "l.231-264", "l.272-278"}) {
    EXPECT_TRUE(Has(text, part)) << part;
  }
}

TEST_F(X04, RobotHeaderHasTheListingsMembers) {
  const std::string text = ReadFile(kSource / "courses/par/intro/solutions/thesis/robot.h");
  for (const char* member : {"imr::CConfig& cfg;", "CCMorse::PlayerClient\\* client;", "bool quit;",
                             "bool alive;", "SPosition pos;", "CCMorse::LaserProxy\\* laser;",
                             "CCMorse::Position2dProxy\\* position2d;", "Mutex mtx;"}) {
    EXPECT_TRUE(course::CountMatches(text, "\n  " + std::string(member)) == 1) << member;
  }
}
