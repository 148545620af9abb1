// .blend files (specs: morse.md I), written by the test itself: every width of pointers, order of
// bytes and form of meshes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "assets/readers.h"
#include "base/error.h"
#include "tests/assets/blend_writer.h"

namespace ccmorse::assets {
namespace {

using test::SampleBlend;
using test::SampleOptions;

AssetScene Read(const SampleOptions& options = {}) {
  return ReadBlend(SampleBlend(options), "sample.blend", {});
}

const AssetObject& Named(const AssetScene& scene, const std::string& name) {
  for (const AssetObject& object : scene.objects) {
    if (object.name == name) return object;
  }
  throw Error("there is no object " + name);
}

std::string ErrorOf(const std::vector<std::uint8_t>& bytes, const AssetLimits& limits = {}) {
  try {
    ReadBlend(bytes, "sample.blend", limits);
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

struct Form {
  const char* name;
  SampleOptions options;
};

class MorseI_BlendForms : public testing::TestWithParam<Form> {};

TEST_P(MorseI_BlendForms, ReadTheSame) {
  const AssetScene scene = Read(GetParam().options);
  ASSERT_EQ(scene.objects.size(), 5U);
  const AssetObject& crate = Named(scene, "Crate");
  EXPECT_EQ(crate.parent, 0);
  EXPECT_EQ(crate.vertices.size(), 8U);
  EXPECT_EQ(crate.faces, 6);
  EXPECT_EQ(crate.triangles.size(), 12U);
  // Turned a quarter with its parent: 2 m long along y.
  const Extent extent = ExtentOf(crate);
  EXPECT_NEAR(extent.low.x, 0.5, 1e-6);
  EXPECT_NEAR(extent.low.y, 1.0, 1e-6);
  EXPECT_NEAR(extent.low.z, 3.0, 1e-6);
  EXPECT_NEAR(extent.high.x, 1.5, 1e-6);
  EXPECT_NEAR(extent.high.y, 3.0, 1e-6);
  EXPECT_NEAR(extent.high.z, 4.0, 1e-6);
  // Every triangle faces outwards.
  const Vec3 centre{1.0, 2.0, 3.5};
  for (const auto& [a, b, c] : crate.triangles) {
    const Vec3& p = crate.vertices[static_cast<std::size_t>(a)];
    const Vec3& q = crate.vertices[static_cast<std::size_t>(b)];
    const Vec3& r = crate.vertices[static_cast<std::size_t>(c)];
    EXPECT_GT(Dot(Cross(q - p, r - p), p - centre), 0.0);
  }
  EXPECT_EQ(crate.physics.type, "RIGID_BODY");
  EXPECT_TRUE(crate.physics.actor);
  EXPECT_FALSE(crate.physics.ghost);
  EXPECT_EQ(crate.physics.bounds, "CONVEX_HULL");
  EXPECT_EQ(crate.physics.mass, 5.0);
  EXPECT_EQ(crate.physics.linear_damping, 0.25);
  EXPECT_EQ(crate.physics.angular_damping, 0.5);
  EXPECT_EQ(crate.physics.radius, 1.5);
  EXPECT_EQ(crate.physics.margin, 0.0625);
  EXPECT_EQ(scene.gravity.z, -9.5);
}

INSTANTIATE_TEST_SUITE_P(
    All, MorseI_BlendForms,
    testing::Values(Form{"wide_little", {}}, Form{"narrow_little", {.wide = false}},
                    Form{"wide_big", {.big = true}},
                    Form{"narrow_big", {.wide = false, .big = true}},
                    Form{"faces", {.faces = true, .version = 260}},
                    Form{"narrow_big_faces", {.wide = false, .big = true, .faces = true}},
                    Form{"gzip", {.packed = true}}),
    [](const auto& which) { return which.param.name; });

TEST(MorseI_Blend, GamePropertiesOfEveryType) {
  const AssetScene scene = Read();
  const std::vector<AssetProperty>& properties = Named(scene, "Crate").properties;
  ASSERT_EQ(properties.size(), 4U);
  EXPECT_EQ(properties[0].name, "Object");
  EXPECT_EQ(properties[0].value, Json(true));
  EXPECT_EQ(properties[1].name, "Label");
  EXPECT_EQ(properties[1].value, Json("box"));
  EXPECT_EQ(properties[2].value, Json(7));
  EXPECT_EQ(properties[3].value, Json(2.5));
}

TEST(MorseI_Blend, MaterialOfAMesh) {
  const AssetScene scene = Read();
  ASSERT_EQ(scene.materials.size(), 1U);
  EXPECT_EQ(scene.materials[0].name, "Red");
  EXPECT_EQ(scene.materials[0].color.r, 255);
  EXPECT_EQ(scene.materials[0].color.g, 51);
  EXPECT_EQ(scene.materials[0].friction, 0.75);
  EXPECT_THAT(Named(scene, "Crate").material_of, testing::Each(0));
}

TEST(MorseI_Blend, OnlyTheScenesLayersAreShown) {
  const AssetScene scene = Read();
  EXPECT_TRUE(Named(scene, "Crate").shown);
  EXPECT_FALSE(Named(scene, "Far").shown);
  EXPECT_LT(ExtentOf(scene).high.x, 2.0);
}

TEST(MorseI_Blend, LampAndCamera) {
  const AssetScene scene = Read();
  ASSERT_TRUE(Named(scene, "Sun").light.has_value());
  EXPECT_EQ(Named(scene, "Sun").light->kind, "SUN");
  EXPECT_EQ(Named(scene, "Sun").light->energy, 0.75);
  ASSERT_GE(scene.camera, 0);
  const AssetObject& eye = scene.objects[static_cast<std::size_t>(scene.camera)];
  EXPECT_EQ(eye.name, "Eye");
  ASSERT_TRUE(eye.camera.has_value());
  EXPECT_NEAR(eye.camera->fov, 2.0 * std::atan(1.0), 1e-9);  // 32 mm behind 16 mm
  // Turned by a quarter about x, by quaternion: it looks along +y.
  EXPECT_NEAR(eye.matrix.z.y, -1.0, 1e-6);
}

TEST(MorseI_Blend, ObjectsThatAreTheirOwnAncestorsAreRefused) {
  EXPECT_THAT(ErrorOf(SampleBlend({.cycle = true})),
              testing::MatchesRegex("sample.blend: offset [0-9]+: object '(Base|Crate)' is its own "
                                    "ancestor"));
}

TEST(MorseI_Blend, AFaceWithoutItsVertexIsRefused) {
  EXPECT_THAT(ErrorOf(SampleBlend({.bad_vertex = true})),
              testing::MatchesRegex("sample.blend: offset [0-9]+: a face has vertex 8, and there "
                                    "are 8"));
  EXPECT_THAT(ErrorOf(SampleBlend({.faces = true, .bad_vertex = true})),
              testing::HasSubstr("a face has vertex 8, and there are 8"));
}

TEST(MorseI_Blend, EveryTruncationIsRefusedWithFileAndOffset) {
  const std::vector<std::uint8_t> whole = SampleBlend();
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    const std::vector<std::uint8_t> cut(whole.begin(),
                                        whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THAT(ErrorOf(cut), testing::MatchesRegex("sample.blend: offset [0-9]+: .*"))
        << "of " << size << " bytes";
  }
  std::vector<std::uint8_t> packed = SampleBlend({.packed = true});
  packed.resize(packed.size() / 2);
  EXPECT_THAT(ErrorOf(packed), testing::HasSubstr("packed by gzip, and cut short"));
}

TEST(MorseI_Blend, EveryByteChangedIsReadOrRefused) {
  const std::vector<std::uint8_t> whole = SampleBlend({.wide = false});
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (const std::uint8_t value : {std::uint8_t{0x00}, std::uint8_t{0x7F}, std::uint8_t{0xFF}}) {
      std::vector<std::uint8_t> bytes = whole;
      bytes[i] = value;
      try {
        const AssetScene scene = ReadBlend(std::move(bytes), "sample.blend", {.triangles = 1000});
        for (const AssetObject& object : scene.objects) {
          ASSERT_LT(object.parent, static_cast<int>(scene.objects.size()));
          for (const auto& triangle : object.triangles) {
            for (const int corner : triangle) {
              ASSERT_LT(static_cast<std::size_t>(corner), object.vertices.size());
            }
          }
        }
      } catch (const Error& error) {
        ASSERT_THAT(error.what(), testing::StartsWith("sample.blend: "));
      }
    }
  }
}

TEST(MorseI_Blend, LimitsHold) {
  EXPECT_THAT(ErrorOf(SampleBlend(), {.triangles = 11}),
              testing::HasSubstr("more than 11 triangles"));
  EXPECT_THAT(ErrorOf(SampleBlend(), {.objects = 4}), testing::HasSubstr("more than 4 objects"));
  EXPECT_THAT(ErrorOf(SampleBlend({.packed = true}), {.bytes = 1000}),
              testing::HasSubstr("unpacks to more than 1000 bytes"));
}

TEST(MorseI_Blend, OtherVersionsAreTriedWithANote) {
  EXPECT_THAT(Read().notes, testing::IsEmpty());
  EXPECT_EQ(Read().format, "Blender 2.74");
  EXPECT_THAT(Read({.version = 250}).notes, testing::ElementsAre(testing::HasSubstr("2.50")));
}

}  // namespace
}  // namespace ccmorse::assets
