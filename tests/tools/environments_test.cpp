#include "tools/environments.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "base/error.h"
#include "tests/support/process.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

TEST(Environments, RemembersWhatCreateMade) {
  const TemporaryFolder home;
  Environments environments(home.path());
  EXPECT_TRUE(environments.List().empty());
  environments.Set({"Made", "/x/Made", true});
  environments.Set({"taken", "/x/taken", false});
  EXPECT_TRUE(environments.Find("made")->created);
  EXPECT_FALSE(environments.Find("taken")->created);
  environments.Set({"Made", "/elsewhere", false});
  EXPECT_FALSE(environments.Find("Made")->created);
  EXPECT_TRUE(environments.Forget("MADE"));
  EXPECT_FALSE(environments.Forget("MADE"));
  EXPECT_EQ(environments.List().size(), 1U);
}

// MORSE, or the user's editor, may point the name at another folder; that one was not created.
TEST(Environments, AFolderThatOthersPutThereWasNotCreated) {
  const TemporaryFolder home;
  Environments environments(home.path());
  environments.Set({"made", "/x/made", true});
  std::ofstream(environments.config_file()) << "[sites]\nmade = /home/u/precious\n";
  EXPECT_FALSE(environments.Find("made")->created);
}

TEST(Environments, ManyAtATimeLoseNothing) {
  const TemporaryFolder home;
  constexpr int kThreads = 8;
  constexpr int kEach = 20;
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&home, t] {
      Environments environments(home.path());
      for (int i = 0; i < kEach; ++i) {
        const std::string name = "e" + std::to_string(t) + "_" + std::to_string(i);
        environments.Set({name, "/x/" + name, false});
        // Readers see a whole file at any time.
        EXPECT_TRUE(environments.Find(name));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(Environments(home.path()).List().size(), static_cast<std::size_t>(kThreads * kEach));
}

TEST(Environments, ALinkedConfigFileStaysALinkAndKeepsItsPermissions) {
  const TemporaryFolder home;
  fs::create_directories(home.path() + "/.morse");
  fs::create_directories(home.path() + "/dotfiles");
  const fs::path real = home.path() + "/dotfiles/morse";
  std::ofstream(real) << "[sites]\na = /a\n";
  fs::permissions(real, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(real, home.path() + "/.morse/config");
  Environments environments(home.path());
  environments.Set({"b", "/b", false});
  EXPECT_TRUE(fs::is_symlink(home.path() + "/.morse/config"));
  EXPECT_EQ(ReadFile(real.string()), "[sites]\na = /a\nb = /b\n");
  EXPECT_EQ(fs::status(real).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(Environments, WhereNothingCanBeWrittenTheFolderIsNamed) {
  const TemporaryFolder home;
  std::ofstream(home.path() + "/file") << "x";
  Environments environments(home.path() + "/file");
  EXPECT_TRUE(environments.List().empty());
  try {
    environments.Set({"a", "/a", false});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(home.path() + "/file/.morse"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("HOME"), std::string::npos);
  }
}

TEST(Environments, TheTrashKeepsBothOfOneName) {
  const TemporaryFolder home;
  ::unsetenv("XDG_DATA_HOME");
  std::vector<fs::path> places;
  for (const char* const content : {"first", "second"}) {
    const fs::path folder = home.path() + "/my env";
    fs::create_directory(folder);
    std::ofstream(folder / "file") << content;
    places.push_back(MoveToTrash(folder, home.path()));
    EXPECT_FALSE(fs::exists(folder));
    EXPECT_EQ(ReadFile((places.back() / "file").string()), content);
  }
  EXPECT_NE(places[0], places[1]);
  const std::string note = ReadFile(home.path() + "/.local/share/Trash/info/my env.trashinfo");
  EXPECT_NE(note.find("Path=" + home.path() + "/my%20env\n"), std::string::npos) << note;
}

}  // namespace
}  // namespace ccmorse::tools
