// The cache of files of shapes: the second load is quick, and nothing stale or broken is believed.

#include "assets/cache.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "assets/load.h"
#include "tests/assets/blend_writer.h"

namespace ccmorse::assets {
namespace {

namespace fs = std::filesystem;

class AssetCache : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("ccmorse_cache_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
    ::unsetenv("CCMORSE_CACHE");
    file_ = (folder_ / "sample.blend").string();
    Write(file_, test::SampleBlend());
  }
  void TearDown() override { fs::remove_all(folder_); }

  static void Write(const std::string& path, const std::vector<std::uint8_t>& bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  static void WriteText(const std::string& path, const std::string& text) {
    Write(path, {text.begin(), text.end()});
  }
  static bool FromCache(const std::string& file) {
    LoadReport report;
    LoadAsset(file, {}, &report);
    return report.from_cache;
  }

  fs::path folder_;
  std::string file_;
};

TEST_F(AssetCache, SecondLoadGivesTheSame) {
  LoadReport first;
  LoadReport second;
  const AssetScene read = LoadAsset(file_, {}, &first);
  const AssetScene kept = LoadAsset(file_, {}, &second);
  EXPECT_FALSE(first.from_cache);
  EXPECT_TRUE(second.from_cache);
  ASSERT_EQ(kept.objects.size(), read.objects.size());
  EXPECT_EQ(kept.format, read.format);
  EXPECT_EQ(kept.gravity.z, read.gravity.z);
  EXPECT_EQ(kept.camera, read.camera);
  EXPECT_EQ(kept.materials.size(), read.materials.size());
  for (std::size_t i = 0; i < read.objects.size(); ++i) {
    const AssetObject& a = read.objects[i];
    const AssetObject& b = kept.objects[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.parent, b.parent);
    EXPECT_EQ(a.shown, b.shown);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.material_of, b.material_of);
    EXPECT_EQ(a.physics.type, b.physics.type);
    EXPECT_EQ(a.physics.mass, b.physics.mass);
    EXPECT_EQ(a.physics.bounds, b.physics.bounds);
    EXPECT_EQ(a.light.has_value(), b.light.has_value());
    EXPECT_EQ(a.camera.has_value(), b.camera.has_value());
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    for (std::size_t k = 0; k < a.vertices.size(); ++k) {
      EXPECT_EQ(a.vertices[k].x, b.vertices[k].x);
      EXPECT_EQ(a.vertices[k].y, b.vertices[k].y);
      EXPECT_EQ(a.vertices[k].z, b.vertices[k].z);
    }
    ASSERT_EQ(a.properties.size(), b.properties.size());
    for (std::size_t k = 0; k < a.properties.size(); ++k) {
      EXPECT_EQ(a.properties[k].name, b.properties[k].name);
      EXPECT_EQ(a.properties[k].value, b.properties[k].value);
    }
  }
}

TEST_F(AssetCache, AChangedFileIsReadAnew) {
  EXPECT_FALSE(FromCache(file_));
  Write(file_, test::SampleBlend({.wide = false}));
  EXPECT_FALSE(FromCache(file_));
  EXPECT_TRUE(FromCache(file_));
  fs::last_write_time(file_, fs::last_write_time(file_) + std::chrono::seconds(2));
  EXPECT_FALSE(FromCache(file_));
}

TEST_F(AssetCache, AChangedFileThatTheFileNamesIsReadAnew) {
  const std::string obj = (folder_ / "tile.obj").string();
  WriteText(folder_ / "tile.mtl", "newmtl red\nKd 1 0 0\n");
  WriteText(obj, "mtllib tile.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
  EXPECT_FALSE(FromCache(obj));
  EXPECT_TRUE(FromCache(obj));
  WriteText(folder_ / "tile.mtl", "newmtl red\nKd 0.5 0 0 \n");
  EXPECT_FALSE(FromCache(obj));
  EXPECT_EQ(LoadAsset(obj).materials[0].color.r, 128);
}

TEST_F(AssetCache, ABrokenCacheIsIgnoredAndRebuilt) {
  EXPECT_FALSE(FromCache(file_));
  const std::string cache = CacheFile(file_);
  std::string whole;
  {
    std::ifstream in(cache, std::ios::binary);
    whole.assign(std::istreambuf_iterator<char>(in), {});
  }
  ASSERT_GT(whole.size(), 100U);
  for (std::size_t i = 0; i < whole.size(); i += 13) {
    std::string broken = whole;
    broken[i] = static_cast<char>(broken[i] ^ 0x55);
    WriteText(cache, broken);
    EXPECT_FALSE(ReadCache(cache, file_).has_value()) << "byte " << i;
    WriteText(cache, whole.substr(0, i));
    EXPECT_FALSE(ReadCache(cache, file_).has_value()) << i << " bytes";
  }
  EXPECT_FALSE(FromCache(file_));
  EXPECT_TRUE(FromCache(file_));
}

TEST_F(AssetCache, TurnedOffNothingIsWritten) {
  ::setenv("CCMORSE_CACHE", "off", 1);
  EXPECT_FALSE(FromCache(file_));
  EXPECT_FALSE(FromCache(file_));
  EXPECT_FALSE(fs::exists(folder_ / "cache"));
}

TEST_F(AssetCache, WithoutAPlaceFilesAreReadAllTheSame) {
  WriteText(folder_ / "no_folder", "a file where the folder is to be");
  ::setenv("XDG_CACHE_HOME", (folder_ / "no_folder").c_str(), 1);
  EXPECT_FALSE(FromCache(file_));
  EXPECT_FALSE(FromCache(file_));
}

TEST_F(AssetCache, NothingIsLeftBesideTheCache) {
  EXPECT_FALSE(FromCache(file_));
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "cache")) {
    files += entry.is_regular_file() ? 1U : 0U;
  }
  EXPECT_EQ(files, 1U);
}

}  // namespace
}  // namespace ccmorse::assets
