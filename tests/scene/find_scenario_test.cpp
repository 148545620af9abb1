// Where scenarios and worlds are found by name.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.h"
#include "scene/scenario.h"
#include "scene/world_folders.h"

namespace ccmorse::scene {
namespace {

namespace fs = std::filesystem;

std::string FindError(const std::string& name) {
  try {
    FindScenario(name);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// A folder of worlds that $CCMORSE_WORLDS names as long as the object lives.
class OwnWorlds {
 public:
  OwnWorlds() : root_(fs::path(testing::TempDir()) / ("worlds_" + std::to_string(getpid()))) {
    fs::create_directories(root_);
    setenv("CCMORSE_WORLDS", root_.c_str(), 1);
  }
  ~OwnWorlds() {
    unsetenv("CCMORSE_WORLDS");
    fs::remove_all(root_);
  }
  void Write(const std::string& name, const std::string& text) {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << text;
  }
  std::string Path(const std::string& name) const { return (root_ / name).string(); }

 private:
  fs::path root_;
};

TEST(C09, EveryScenarioOfTheWorldsFolderLoads) {
  int count = 0;
  for (const auto& entry :
       fs::directory_iterator(std::string(CCMORSE_SOURCE_DIR) + "/worlds/syrotek")) {
    if (entry.path().extension() != ".json") continue;
    const Scenario scenario = LoadScenario(entry.path().string());
    EXPECT_EQ(scenario.name, entry.path().stem().string());
    EXPECT_EQ(scenario.world.name, "syrotek");
    EXPECT_GE(scenario.robots.size(), 1U);
    ++count;
  }
  EXPECT_GE(count, 4);
}

TEST(FindScenario, ByNameByFolderAndByPath) {
  const std::string worlds = std::string(CCMORSE_SOURCE_DIR) + "/worlds/";
  EXPECT_EQ(FindScenario("syrotek"), worlds + "syrotek/syrotek.json");
  EXPECT_EQ(FindScenario("syrotek/syrotek"), worlds + "syrotek/syrotek.json");
  EXPECT_EQ(FindScenario("docks"), worlds + "syrotek/docks.json");
  EXPECT_EQ(FindScenario("syrotek/docks"), worlds + "syrotek/docks.json");
  EXPECT_EQ(FindScenario(worlds + "syrotek/docks.json"), worlds + "syrotek/docks.json");
}

TEST(FindScenario, ListsEachOnceAndFindsAllOfThem) {
  const std::vector<std::string> names = ListScenarios();
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  for (const char* name : {"course_map", "docks", "syrotek", "two_robots"}) {
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
  for (const std::string& name : names) EXPECT_NO_THROW(LoadScenario(FindScenario(name))) << name;
}

TEST(FindScenario, UnknownNameSaysWhatThereIsAndWhereItLooked) {
  const std::string message = FindError("sirotek");
  EXPECT_NE(message.find("no scenario 'sirotek'"), std::string::npos) << message;
  EXPECT_NE(message.find("did you mean 'syrotek'?"), std::string::npos) << message;
  EXPECT_NE(message.find("two_robots"), std::string::npos) << message;
  EXPECT_NE(message.find(std::string(CCMORSE_SOURCE_DIR) + "/worlds"), std::string::npos);
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(FindScenario, OwnFolderComesFirst) {
  OwnWorlds own;
  own.Write("syrotek/docks.json", R"({"robots": []})");
  own.Write("lab/lab.json", "{}");
  own.Write("lab/two.json", "{}");
  own.Write("lab/course_map.json", "{}");
  EXPECT_EQ(FindScenario("docks"), own.Path("syrotek/docks.json"));
  EXPECT_EQ(FindScenario("lab"), own.Path("lab/lab.json"));
  EXPECT_EQ(FindScenario("two"), own.Path("lab/two.json"));
  // A name that two folders have must be written in full.
  EXPECT_EQ(FindScenario("lab/course_map"), own.Path("lab/course_map.json"));
  EXPECT_NE(FindError("course_map").find("lab/course_map"), std::string::npos);
}

TEST(G07, AWorldOfYourOwnNeedsNoSyrotek) {
  OwnWorlds own;
  own.Write("lab/models/arena.json",
            R"({"name": "lab", "size": [8, 6],
                "boxes": [{"id": 7, "kind": "table", "x": 4, "y": 3, "size": [1, 0.5],
                           "height": 0.7, "color": "brown"}]})");
  own.Write("lab/lab.json", R"({"world": "lab"})");
  own.Write("lab/by_file.json", R"({"world": {"file": "models/arena.json"}})");
  const std::vector<std::string> worlds = ListWorlds();
  EXPECT_EQ(std::count(worlds.begin(), worlds.end(), "lab"), 1);
  for (const char* name : {"lab", "lab/by_file"}) {
    const World world = LoadScenario(FindScenario(name)).world;
    EXPECT_EQ(world.name, "lab");
    EXPECT_DOUBLE_EQ(world.size_x, 8.0);
    ASSERT_EQ(world.boxes.size(), 1U);
    EXPECT_EQ(world.boxes[0].kind, "table");
    EXPECT_TRUE(world.boxes[0].raised);
  }
}

TEST(G07, AMistakeInAWorldFileNamesThatFile) {
  OwnWorlds own;
  own.Write("lab/models/arena.json", "{\"name\": \"lab\",\n \"size\": [8, -6]}");
  own.Write("lab/lab.json", R"({"world": {"file": "models/arena.json"}})");
  try {
    LoadScenario(FindScenario("lab"));
    FAIL() << "must throw";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              own.Path("lab/models/arena.json") +
                  ":2: size[1] is -6, must be more than 0 and at most 1000");
  }
}

TEST(LoadScenario, MissingFileSaysSo) {
  try {
    LoadScenario("no/such.json");
    FAIL() << "must throw";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no/such.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace ccmorse::scene
