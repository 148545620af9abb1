// Player's packages under Player's names (issue: old Makefiles and CMakeLists work unchanged): an
// installed tree builds the programs of examples/player with make and with cmake, moved elsewhere.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;

struct Result {
  int status;
  std::string output;
};

Result Shell(const std::string& command) {
  FILE* pipe = popen(("{ " + command + "; } 2>&1").c_str(), "r");
  if (pipe == nullptr) return {-1, "cannot run " + command};
  Result result{0, ""};
  char buffer[4096];
  for (std::size_t n = 0; (n = fread(buffer, 1, sizeof(buffer), pipe)) > 0;) {
    result.output.append(buffer, n);
  }
  const int status = pclose(pipe);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

std::string Quoted(const fs::path& path) { return "'" + path.string() + "'"; }

class PlayerPackages : public testing::Test {
 protected:
  PlayerPackages() {
    std::string name = testing::TempDir() + "ccmorse_player_XXXXXX";
    if (mkdtemp(name.data()) == nullptr) std::abort();
    root_ = name;
    for (const char* variable : {"CPPFLAGS", "CXXFLAGS", "LDFLAGS", "CXX", "MAKEFLAGS", "MFLAGS"}) {
      unsetenv(variable);
    }
    // As `cmake --install` puts them, without the programs, which the tests do not need.
    const fs::path binary = CCMORSE_BINARY_DIR;
    const fs::path lib = root_ / "moved" / CCMORSE_LIBDIR;
    fs::create_directories(lib / "pkgconfig");
    fs::create_directories(root_ / "moved/include");
    fs::copy(fs::path(CCMORSE_SOURCE_DIR) / "include", root_ / "moved/include",
             fs::copy_options::recursive);
    for (const auto& entry : fs::directory_iterator(binary / "lib")) {
      if (entry.path().filename().string().starts_with("libCCMorse.so")) {
        fs::copy(entry.path(), lib / entry.path().filename(), fs::copy_options::copy_symlinks);
      }
    }
    const Result installed = Shell("cmake --install " + Quoted(binary / "packaging/player") +
                                   " --prefix " + Quoted(root_ / "moved"));
    EXPECT_EQ(installed.status, 0) << installed.output;
    fs::copy(fs::path(CCMORSE_SOURCE_DIR) / "examples/player", root_ / "player");
    setenv("PKG_CONFIG_LIBDIR", (lib / "pkgconfig").c_str(), 1);
    sanitize_ = std::string(CCMORSE_SANITIZE);
    if (!sanitize_.empty()) sanitize_ = "-fsanitize=" + sanitize_;
  }
  ~PlayerPackages() override { fs::remove_all(root_); }

  fs::path root_;
  std::string sanitize_;
};

TEST_F(PlayerPackages, PkgConfigKnowsAllOfPlayersNames) {
  for (const char* name :
       {"playerc++", "playerc", "playercore", "playercommon", "playererror", "playerinterface"}) {
    const Result flags = Shell("pkg-config --cflags --libs " + std::string(name));
    EXPECT_EQ(flags.status, 0) << flags.output;
    EXPECT_NE(flags.output.find("/moved/"), std::string::npos) << flags.output;
    EXPECT_NE(flags.output.find("-lCCMorse"), std::string::npos) << flags.output;
  }
}

TEST_F(PlayerPackages, AMakefileBuildsItsProgramsByPkgConfig) {
  const Result made =
      Shell("make -C " + Quoted(root_ / "player") + " hello CXXFLAGS+='-O0 " + sanitize_ +
            " $(shell pkg-config --cflags playerc++)' LDFLAGS='" + sanitize_ + "'");
  ASSERT_EQ(made.status, 0) << made.output;
  EXPECT_EQ(made.output.find("warning"), std::string::npos) << made.output;
  // It runs: port 1 of this machine has no server.
  const Result ran = Shell(Quoted(root_ / "player/hello") + " 127.0.0.1 1");
  EXPECT_EQ(ran.status, 1);
  EXPECT_NE(ran.output.find("cannot connect to 127.0.0.1:1"), std::string::npos) << ran.output;
}

TEST_F(PlayerPackages, AnInstalledProgramSimulatesWithinItselfOnceTheLibraryIsThere) {
  const fs::path lib = root_ / "moved" / CCMORSE_LIBDIR;
  const fs::path worlds = root_ / "moved/share/ccmorse/worlds/moved_here";
  fs::create_directories(worlds);
  std::ofstream(worlds / "moved_here.json") << R"({"world": "syrotek"})";
  const Result made =
      Shell("make -C " + Quoted(root_ / "player") + " hello CXXFLAGS+='-O0 " + sanitize_ +
            " $(shell pkg-config --cflags playerc++)' LDFLAGS='" + sanitize_ + "'");
  ASSERT_EQ(made.status, 0) << made.output;
  const std::string run = "LD_LIBRARY_PATH=" + Quoted(lib) + " " + Quoted(root_ / "player/hello") +
                          " 'sim:moved_here?pace=lockstep' 0";
  const Result without = Shell(run);
  EXPECT_EQ(without.status, 1);
  EXPECT_NE(without.output.find("needs libccmorse-sim.so."), std::string::npos) << without.output;
  for (const auto& entry : fs::directory_iterator(fs::path(CCMORSE_BINARY_DIR) / "lib")) {
    if (entry.path().filename().string().starts_with("libccmorse-sim.so")) {
      fs::copy(entry.path(), lib / entry.path().filename(), fs::copy_options::copy_symlinks);
    }
  }
  const Result with = Shell(run);
  EXPECT_EQ(with.status, 0) << with.output;
  EXPECT_NE(with.output.find("682 beams"), std::string::npos) << with.output;
}

TEST_F(PlayerPackages, CMakeFindsPlayerAndBuildsEveryExample) {
  const Result built =
      Shell("cmake -S " + Quoted(root_ / "player") + " -B " + Quoted(root_ / "build") +
            " -DCMAKE_PREFIX_PATH=" + Quoted(root_ / "moved") + " -DCMAKE_CXX_FLAGS='-O0 -Wall " +
            sanitize_ + "' && cmake --build " + Quoted(root_ / "build"));
  ASSERT_EQ(built.status, 0) << built.output;
  EXPECT_EQ(built.output.find("warning:"), std::string::npos) << built.output;
  EXPECT_EQ(Shell(Quoted(root_ / "build/goto_snd")).status, 2);
}

}  // namespace
