// Worlds and meshes of a scenario that come from files of shapes.

#include "scene/asset_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "scene/mesh.h"
#include "scene/player/import.h"
#include "scene/scenario.h"

namespace ccmorse::scene {
namespace {

namespace fs = std::filesystem;

// A ground of 20 x 10 m around the origin, and a red wall of 4 x 2 m on it.
const char* const kHall =
    "mtllib hall.mtl\n"
    "v -10 -5 0\nv 10 -5 0\nv 10 5 0\nv -10 5 0\n"
    "v 2 3 0\nv 6 3 0\nv 6 3 2\nv 2 3 2\n"
    "o Ground\nf 1 2 3 4\n"
    "o Wall-1\nusemtl red\nf 5 6 7 8\n";

class AssetWorld : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("ccmorse_asset_world_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "shapes");
    ::setenv("CCMORSE_CACHE", "off", 1);
    ::unsetenv("MORSE_RESOURCE_PATH");
    Write("shapes/hall.obj", kHall);
    Write("shapes/hall.mtl", "newmtl red\nKd 1 0 0\n");
  }
  void TearDown() override {
    ::unsetenv("MORSE_RESOURCE_PATH");
    fs::remove_all(folder_);
  }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  Scenario Parse(const std::string& text) const {
    return ParseScenario(text, (folder_ / "scenario.json").string());
  }
  std::string ErrorOf(const std::string& text) const {
    try {
      Parse(text);
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  }

  fs::path folder_;
};

TEST_F(AssetWorld, FileIsTheWorldAroundItsOrigin) {
  const Scenario scenario = Parse(R"({"world": {"file": "shapes/hall.obj"},
    "robots": [{"pose": {"x": -8, "y": -4, "yaw": 0}}]})");
  const World& world = scenario.world;
  EXPECT_EQ(world.name, "hall");
  EXPECT_EQ(world.low.x, -10.0);
  EXPECT_EQ(world.low.y, -5.0);
  EXPECT_EQ(world.size_x, 20.0);
  EXPECT_EQ(world.size_y, 10.0);
  EXPECT_FALSE(world.has_floor);  // it has a ground of its own
  ASSERT_EQ(world.meshes.size(), 2U);
  EXPECT_EQ(world.meshes[0].name, "Ground");
  EXPECT_EQ(world.meshes[1].name, "Wall_1");
  EXPECT_EQ(world.meshes[1].color.r, 255);
  EXPECT_EQ(world.meshes[1].color.g, 0);
}

TEST_F(AssetWorld, RobotsStandOnTheFloorOfTheFileAndNotInItsWalls) {
  EXPECT_THAT(ErrorOf(R"({"world": {"file": "shapes/hall.obj"},
                "robots": [{"pose": {"x": -10.5, "y": 0, "yaw": 0}}]})"),
              testing::HasSubstr("does not stand on the floor"));
  EXPECT_THAT(ErrorOf(R"({"world": {"file": "shapes/hall.obj"},
                "robots": [{"pose": {"x": 4, "y": 3, "yaw": 0}}]})"),
              testing::HasSubstr("overlaps mesh 2 (Wall_1)"));
}

TEST_F(AssetWorld, ScenarioWrittenInFullReadsTheSameWithoutTheFile) {
  const Scenario scenario = Parse(R"({"world": {"file": "shapes/hall.obj"}, "robots": []})");
  const std::string text = ToJson(scenario).Dump();
  const Scenario again = ParseScenario(text, "elsewhere.json");
  EXPECT_EQ(ToJson(again).Dump(), text);
  EXPECT_FALSE(again.world.has_floor);
  EXPECT_EQ(again.world.low.x, -10.0);
}

TEST_F(AssetWorld, MeshOfAFileIsPlacedScaledAndKeepsItsColours) {
  const Scenario scenario = Parse(R"({"world": {"name": "w", "size": [40, 40], "low": [-20, -20],
    "meshes": [{"id": 9, "file": "shapes/hall.obj", "scale": 0.5, "position": [1, 2, 3],
                "rotation": [0, 0, 1.5707963267948966], "solid": false}]}, "robots": []})");
  const Mesh& mesh = scenario.world.meshes.at(0);
  EXPECT_EQ(mesh.id, 9);
  EXPECT_FALSE(mesh.solid);
  ASSERT_EQ(mesh.triangles.size(), 4U);
  EXPECT_EQ(ColorOf(mesh, 3).r, 255);
  EXPECT_EQ(ColorOf(mesh, 3).g, 0);
  EXPECT_EQ(ColorOf(mesh, 0).g, 204);
  const Vec3 corner = PlacedVertices(mesh)[0];  // (-10, -5, 0), halved and turned
  EXPECT_NEAR(corner.x, 1.0 + 2.5, 1e-9);
  EXPECT_NEAR(corner.y, 2.0 - 5.0, 1e-9);
  EXPECT_NEAR(corner.z, 3.0, 1e-9);
  const std::string text = ToJson(scenario).Dump();
  EXPECT_EQ(ToJson(ParseScenario(text, "elsewhere.json")).Dump(), text);
}

TEST_F(AssetWorld, FilesAreLookedForInMorsesResourcePath) {
  const std::string text = R"({"world": {"file": "hall.obj"}, "robots": []})";
  EXPECT_THAT(ErrorOf(text), testing::AllOf(testing::HasSubstr("scenario.json:1: "),
                                            testing::HasSubstr("there is no file 'hall.obj'"),
                                            testing::HasSubstr("/usr/share/morse/data")));
  ::setenv("MORSE_RESOURCE_PATH", ("/nowhere:" + (folder_ / "shapes").string()).c_str(), 1);
  EXPECT_EQ(Parse(text).world.meshes.size(), 2U);
}

TEST_F(AssetWorld, AFileAloneIsAScenarioWithoutRobots) {
  const Scenario scenario = ImportScenario((folder_ / "shapes/hall.obj").string()).scenario;
  EXPECT_EQ(scenario.name, "hall");
  EXPECT_TRUE(scenario.robots.empty());
  EXPECT_EQ(scenario.world.meshes.size(), 2U);
}

TEST_F(AssetWorld, WhatHasNoSurfaceIsRefused) {
  Write("shapes/empty.obj", "v 0 0 0\n");
  EXPECT_THAT(ErrorOf(R"({"world": {"file": "shapes/empty.obj"}})"),
              testing::HasSubstr("shows nothing that has a surface"));
  EXPECT_THAT(ErrorOf(R"({"world": {"name": "w", "size": [4, 4],
                "meshes": [{"id": 1, "file": "shapes/empty.obj"}]}})"),
              testing::HasSubstr("nothing that has a surface"));
}

TEST_F(AssetWorld, WallsWithoutGroundGetAFloor) {
  Write("shapes/wall.obj", "v 0 0 0\nv 4 0 0\nv 4 0 2\nv 0 3 0\nv 0 3 2\nf 1 2 3\nf 1 4 5\n");
  const World world = Parse(R"({"world": {"file": "shapes/wall.obj"}, "robots": []})").world;
  EXPECT_TRUE(world.has_floor);
  EXPECT_EQ(world.low.x, -0.5);
  EXPECT_EQ(world.size_x, 5.0);
}

TEST(MorseI_World, PhysicsFlagsSayWhatStopsAndWhatIsSeen) {
  assets::AssetScene asset;
  const auto add = [&asset](const std::string& type, bool ghost, bool hidden) {
    assets::AssetObject& object = asset.objects.emplace_back();
    object.name = type;
    object.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    object.triangles = {{0, 1, 2}};
    object.material_of = {-1};
    object.physics.type = type;
    object.physics.ghost = ghost;
    object.hidden = hidden;
  };
  add("STATIC", false, false);
  add("RIGID_BODY", true, false);
  add("NO_COLLISION", false, false);
  add("NO_COLLISION", false, true);  // nothing at all
  add("STATIC", false, true);        // a wall of glass
  add("SENSOR", false, false);
  const std::vector<Mesh> meshes = MeshesOf(asset, 11);
  ASSERT_EQ(meshes.size(), 5U);
  const auto flags = [&meshes](std::size_t i) {
    return std::array{meshes[i].solid, meshes[i].visible, meshes[i].drawn};
  };
  EXPECT_EQ(meshes[0].id, 11);
  EXPECT_EQ(flags(0), (std::array{true, true, true}));
  EXPECT_EQ(flags(1), (std::array{false, true, true}));
  EXPECT_EQ(flags(2), (std::array{false, false, true}));
  EXPECT_EQ(flags(3), (std::array{true, true, false}));
  EXPECT_EQ(flags(4), (std::array{false, false, true}));
}

}  // namespace
}  // namespace ccmorse::scene
