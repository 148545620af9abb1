// All files of Debian's morse-simulator-data load (issue "A drop-in for MORSE", Done when), and
// hold what Blender 3.4 and a second reader of physics found in them: compare_blender.py.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "assets/load.h"
#include "base/error.h"
#include "base/json.h"

namespace ccmorse::assets {
namespace {

namespace fs = std::filesystem;

const char* const kFolder = "/usr/share/morse/data";

const Json& Expected() {
  static const Json json =
      Json::Parse(ReadFile(CCMORSE_SOURCE_DIR "/tests/assets/morse_data_expected.json"));
  return json;
}

std::vector<std::string> Names() {
  std::vector<std::string> names;
  for (const Json::Member& member : Expected().AsObject()) names.push_back(member.first);
  return names;
}

class MorseI_DataFile : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!fs::is_directory(kFolder)) {
      GTEST_SKIP() << "Debian's package morse-simulator-data is not installed";
    }
    ::setenv("CCMORSE_CACHE", "off", 1);
  }
};

double At(const Json& list, std::size_t i) { return list.AsArray()[i].AsDouble(); }

TEST_P(MorseI_DataFile, HoldsWhatBlenderFinds) {
  const AssetScene scene = LoadAsset(std::string(kFolder) + "/" + GetParam());
  std::map<std::string, const AssetObject*> by_name;
  for (const AssetObject& object : scene.objects) {
    if (!object.instance) by_name.emplace(object.name, &object);
  }
  const Json::Array& expected = Expected().Find(GetParam())->AsArray();
  ASSERT_EQ(by_name.size(), expected.size());
  static const std::vector<std::string> kBounds = {
      "BOX", "SPHERE", "CYLINDER", "CONE", "TRIANGLE_MESH", "CONVEX_HULL", "", "CAPSULE"};
  for (const Json& entry : expected) {
    const Json::Array& fact = entry.AsArray();
    const std::string& name = fact[0].AsString();
    SCOPED_TRACE(name);
    ASSERT_TRUE(by_name.contains(name));
    const AssetObject& object = *by_name[name];
    // What 3.4 calls LIGHT was a lamp.
    EXPECT_EQ(object.type == "LAMP" ? "LIGHT" : object.type, fact[1].AsString());
    EXPECT_EQ(static_cast<std::int64_t>(object.vertices.size()), fact[2].AsInt());
    EXPECT_EQ(object.faces, fact[3].AsInt());
    if (!fact[4].AsArray().empty()) {
      const Extent extent = ExtentOf(object);
      const double size = std::max({1.0, std::fabs(At(fact[4], 0)), std::fabs(At(fact[5], 0)),
                                    std::fabs(At(fact[4], 1)), std::fabs(At(fact[5], 1))});
      const double near = 2e-4 * size;  // facts are rounded to 1e-4 m; Blender places in floats
      EXPECT_NEAR(extent.low.x, At(fact[4], 0), near);
      EXPECT_NEAR(extent.low.y, At(fact[4], 1), near);
      EXPECT_NEAR(extent.low.z, At(fact[4], 2), near);
      EXPECT_NEAR(extent.high.x, At(fact[5], 0), near);
      EXPECT_NEAR(extent.high.y, At(fact[5], 1), near);
      EXPECT_NEAR(extent.high.z, At(fact[5], 2), near);
    }
    EXPECT_EQ(object.physics.type, fact[6].AsString());
    EXPECT_NEAR(object.physics.mass, fact[7].AsDouble(), 1e-4);
    EXPECT_NEAR(object.physics.radius, fact[8].AsDouble(), 1e-4);
    const std::int64_t bounds = fact[9].AsInt();
    EXPECT_EQ(object.physics.bounds, bounds < 0 ? "" : kBounds[static_cast<std::size_t>(bounds)]);
    std::vector<std::string> properties;
    for (const AssetProperty& property : object.properties) properties.push_back(property.name);
    std::vector<std::string> wanted;
    for (const Json& property : fact[10].AsArray()) wanted.push_back(property.AsString());
    EXPECT_EQ(properties, wanted);
  }
}

INSTANTIATE_TEST_SUITE_P(All, MorseI_DataFile, testing::ValuesIn(Names()), [](const auto& which) {
  std::string name = which.param.substr(0, which.param.rfind('.'));
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
});

TEST(MorseI_Data, AllFiftyFilesAreCompared) {
  EXPECT_EQ(Names().size(), 50U);
  if (!fs::is_directory(kFolder)) {
    GTEST_SKIP() << "Debian's package morse-simulator-data is not installed";
  }
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kFolder)) {
    files += entry.path().extension() == ".blend" ? 1U : 0U;
  }
  EXPECT_EQ(files, 50U);
}

TEST(MorseI_Data, ColladaOfTheAtrvLoads) {
  const std::string path = std::string(kFolder) + "/robots/atrv.dae";
  if (!fs::exists(path)) GTEST_SKIP() << "there is no " << path;
  ::setenv("CCMORSE_CACHE", "off", 1);
  const AssetScene scene = LoadAsset(path);
  const Extent extent = ExtentOf(scene);
  ASSERT_FALSE(extent.empty());
  // About the size of the robot (specs: morse.md H.1).
  EXPECT_NEAR(extent.high.x - extent.low.x, 1.14, 0.3);
  EXPECT_NEAR(extent.high.z - extent.low.z, 0.75, 0.3);
}

}  // namespace
}  // namespace ccmorse::assets
