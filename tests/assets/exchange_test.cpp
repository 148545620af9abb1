// glTF, OBJ, STL and COLLADA: files that the test writes, read as the formats' specifications say.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>

#include "assets/readers.h"
#include "base/base64.h"
#include "base/error.h"

namespace ccmorse::assets {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Bytes ToBytes(const std::string& text) { return {text.begin(), text.end()}; }

Bytes FindNothing(const std::string& path) { throw Error("cannot read " + path); }

void Put(std::string& out, std::uint32_t value, int size = 4) {
  for (int i = 0; i < size; ++i) out.push_back(static_cast<char>(value >> (8 * i)));
}
void Put(std::string& out, float value) { Put(out, std::bit_cast<std::uint32_t>(value)); }

template <typename Call>
std::string ErrorOf(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

void ExpectBox(const Extent& extent, const Vec3& low, const Vec3& high) {
  EXPECT_NEAR(extent.low.x, low.x, 1e-6);
  EXPECT_NEAR(extent.low.y, low.y, 1e-6);
  EXPECT_NEAR(extent.low.z, low.z, 1e-6);
  EXPECT_NEAR(extent.high.x, high.x, 1e-6);
  EXPECT_NEAR(extent.high.y, high.y, 1e-6);
  EXPECT_NEAR(extent.high.z, high.z, 1e-6);
}

// A right triangle of 1 m by 2 m that stands upright in glTF's frame (x right, y up).
std::string TriangleBuffer() {
  std::string buffer;
  for (const float v : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 2.0F, 0.0F}) Put(buffer, v);
  for (const std::uint32_t i : {0U, 1U, 2U}) Put(buffer, i, 2);
  return buffer;
}

std::string TriangleJson(const std::string& buffer, const std::string& node) {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [)" +
         node + R"(],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
    "materials": [{"name": "blue", "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 1, 0.5]}}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
      {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
      {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
    "buffers": [{"byteLength": 42)" +
         buffer + "}]}";
}

TEST(Assets_Gltf, BufferWithinTheFileStandsUpright) {
  const std::string json = TriangleJson(
      R"(, "uri": "data:application/octet-stream;base64,)" + ToBase64(TriangleBuffer()) + "\"",
      R"({"name": "sail", "mesh": 0, "translation": [10, 20, 30]})");
  const AssetScene scene = ReadGltf(ToBytes(json), "a.gltf", FindNothing, {});
  ASSERT_EQ(scene.objects.size(), 1U);
  EXPECT_EQ(scene.objects[0].name, "sail");
  ASSERT_EQ(scene.objects[0].triangles.size(), 1U);
  // y is up there, z here; what is nearer to the viewer there has a lower y here.
  ExpectBox(ExtentOf(scene), {10, -30, 20}, {11, -30, 22});
  ASSERT_EQ(scene.materials.size(), 1U);
  EXPECT_EQ(scene.materials[0].color.b, 255);
  EXPECT_EQ(scene.materials[0].alpha, 0.5);
  EXPECT_THAT(scene.objects[0].material_of, ElementsAre(0));
}

TEST(Assets_Gltf, BufferBesideTheFile) {
  const std::string json = TriangleJson(R"(, "uri": "a.bin")", R"({"mesh": 0})");
  std::string asked;
  const FindFile find = [&asked](const std::string& path) {
    asked = path;
    return ToBytes(TriangleBuffer());
  };
  EXPECT_EQ(ReadGltf(ToBytes(json), "a.gltf", find, {}).objects[0].triangles.size(), 1U);
  EXPECT_EQ(asked, "a.bin");
}

TEST(Assets_Gltf, BinaryFileWithNestedAndMirroredNodes) {
  std::string json = TriangleJson("", R"({"children": [1], "scale": [-1, 1, 1]},
    {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]})");
  while (json.size() % 4 != 0) json.push_back(' ');
  const std::string buffer = TriangleBuffer();
  std::string glb = "glTF";
  Put(glb, 2U);
  Put(glb, static_cast<std::uint32_t>(28 + json.size() + buffer.size()));
  Put(glb, static_cast<std::uint32_t>(json.size()));
  glb += "JSON" + json;
  Put(glb, static_cast<std::uint32_t>(buffer.size()));
  glb += std::string("BIN\0", 4) + buffer;
  const AssetScene scene = ReadGltf(ToBytes(glb), "a.glb", FindNothing, {});
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.objects[1].parent, 0);
  // (1, 0) and (0, 2) turned a quarter: (0, 1) and (-2, 0); mirrored in x: (0, 1) and (2, 0).
  ExpectBox(ExtentOf(scene), {0, 0, 0}, {2, 0, 1});
  // Mirrored it still faces the viewer, who looks along +y here.
  const AssetObject& sail = scene.objects[1];
  const auto& [a, b, c] = sail.triangles.at(0);
  const auto at = [&](int i) { return sail.vertices[static_cast<std::size_t>(i)]; };
  EXPECT_LT(Cross(at(b) - at(a), at(c) - at(a)).y, 0.0);
}

TEST(Assets_Gltf, WhatIsBrokenIsNamed) {
  const auto error = [](const std::string& json) {
    return ErrorOf([&] { ReadGltf(ToBytes(json), "a.gltf", FindNothing, {.objects = 100}); });
  };
  EXPECT_THAT(error("{"), HasSubstr("a.gltf:1: "));
  EXPECT_THAT(error("{}"), HasSubstr("unknown version"));
  const std::string data =
      R"(, "uri": "data:;base64,)" + ToBase64(TriangleBuffer().substr(0, 30)) + "\"";
  EXPECT_THAT(error(TriangleJson(data, R"({"mesh": 0})")), HasSubstr("reaches beyond its buffer"));
  EXPECT_THAT(error(TriangleJson("", R"({"mesh": 7})")),
              HasSubstr("meshes[7], which is not there"));
  EXPECT_THAT(error(TriangleJson("", R"({"children": [0]})")), HasSubstr("in a circle"));
  EXPECT_THAT(error(TriangleJson(R"(, "uri": "a.bin")", R"({"mesh": 0})")),
              HasSubstr("cannot read a.bin"));
  EXPECT_THAT(error(R"({"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_draco"]})"),
              HasSubstr("extensions"));
}

TEST(Assets_Obj, ObjectsFacesAndMaterials) {
  const std::string obj =
      "# two things\nmtllib m.mtl\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 3\n"
      "o Floor\nusemtl green\nf 1/1/1 2/2/1 3/3/1 4/4/1\n"
      "o Wall\nf -5 -4 \\\n -1\n";
  const FindFile find = [](const std::string& path) {
    EXPECT_EQ(path, "m.mtl");
    return ToBytes("newmtl green\nKd 0 1 0\nd 0.25\nmap_Kd -s 1 1 1 grass.png\n");
  };
  const AssetScene scene = ReadObj(obj, "a.obj", find, {});
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.objects[0].name, "Floor");
  EXPECT_EQ(scene.objects[0].faces, 1);
  EXPECT_EQ(scene.objects[0].triangles.size(), 2U);
  EXPECT_EQ(scene.objects[1].triangles.size(), 1U);
  ExpectBox(ExtentOf(scene.objects[0]), {0, 0, 0}, {2, 1, 0});
  ExpectBox(ExtentOf(scene.objects[1]), {0, 0, 0}, {2, 0, 3});
  ASSERT_EQ(scene.materials.size(), 1U);
  EXPECT_EQ(scene.materials[0].color.g, 255);
  EXPECT_EQ(scene.materials[0].alpha, 0.25);
  ASSERT_EQ(scene.images.size(), 1U);
  EXPECT_EQ(scene.images[0].path, "grass.png");
  EXPECT_THAT(scene.objects[0].material_of, ElementsAre(0, 0));
}

TEST(Assets_Obj, APolygonThatIsNotConvexKeepsItsArea) {
  // An L of three unit squares.
  const std::string obj = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n";
  const AssetScene scene = ReadObj(obj, "a.obj", FindNothing, {});
  double area = 0.0;
  for (const auto& [a, b, c] : scene.objects.at(0).triangles) {
    const auto at = [&](int i) { return scene.objects[0].vertices[static_cast<std::size_t>(i)]; };
    const Vec3 normal = Cross(at(b) - at(a), at(c) - at(a));
    EXPECT_GT(normal.z, 0.0);
    area += normal.z / 2.0;
  }
  EXPECT_NEAR(area, 3.0, 1e-12);
}

TEST(Assets_Obj, WhatIsBrokenIsNamedByLine) {
  const auto error = [](const std::string& obj) {
    return ErrorOf([&] { ReadObj(obj, "a.obj", FindNothing, {}); });
  };
  EXPECT_THAT(error("v 1 2\n"), HasSubstr("a.obj:1: 'v' must be followed by three numbers"));
  EXPECT_THAT(error("v 0 0 0\nf 1 2 3\n"),
              HasSubstr("a.obj:2: a face has vertex 2, and there are"));
  EXPECT_THAT(error("v 0 0 0\nf 1 1\n"), HasSubstr("three corners"));
  EXPECT_THAT(error("v 0 nan 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), HasSubstr("nowhere"));
  // Materials are no reason to fail.
  EXPECT_THAT(ReadObj("mtllib gone.mtl\n", "a.obj", FindNothing, {}).notes,
              ElementsAre(HasSubstr("cannot read gone.mtl")));
}

std::string BinaryStl() {
  std::string stl = "solid but binary";
  stl.resize(80);
  Put(stl, 2U);
  for (const float z : {0.0F, 1.0F}) {
    for (const float v : {0.0F, 0.0F, 1.0F, 0.0F, 0.0F, z, 1.0F, 0.0F, z, 0.0F, 1.0F, z}) {
      Put(stl, v);
    }
    Put(stl, 0U, 2);
  }
  return stl;
}

TEST(Assets_Stl, BinaryEvenWhereItBeginsWithSolid) {
  const AssetScene scene = ReadStl(ToBytes(BinaryStl()), "a.stl", {});
  ASSERT_EQ(scene.objects.size(), 1U);
  EXPECT_EQ(scene.objects[0].triangles.size(), 2U);
  EXPECT_EQ(scene.objects[0].vertices.size(), 6U);
  ExpectBox(ExtentOf(scene), {0, 0, 0}, {1, 1, 1});
}

TEST(Assets_Stl, Text) {
  const std::string stl =
      "solid roof\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 2\n   vertex 1e0 0 2\n"
      "   vertex 0 +1 2\n  endloop\n endfacet\n facet normal 0 0 1\n outer loop vertex 1 0 2 "
      "vertex 1 1 2 vertex 0 1 2 endloop endfacet\nendsolid roof\n";
  const AssetScene scene = ReadStl(ToBytes(stl), "a.stl", {});
  EXPECT_EQ(scene.objects.at(0).triangles.size(), 2U);
  EXPECT_EQ(scene.objects[0].vertices.size(), 4U);  // shared
  ExpectBox(ExtentOf(scene), {0, 0, 2}, {1, 1, 2});
}

TEST(Assets_Stl, WhatIsBrokenIsNamed) {
  const auto error = [](const std::string& stl) {
    return ErrorOf([&] { ReadStl(ToBytes(stl), "a.stl", {}); });
  };
  EXPECT_THAT(error("nothing"), HasSubstr("a.stl: is no STL"));
  EXPECT_THAT(error("solid a facet vertex 1 2 three"), HasSubstr("three numbers"));
  EXPECT_THAT(error("solid a vertex 1 2 3"), HasSubstr("cut short"));
  std::string cut = BinaryStl();
  cut[0] = 'S';
  cut.pop_back();
  EXPECT_THAT(error(cut), HasSubstr("is no STL"));
}

std::string Collada(const std::string& up, const std::string& node) {
  return R"(<?xml version="1.0"?><COLLADA version="1.4.1"><asset><unit meter="0.5"/><up_axis>)" +
         up +
         R"(</up_axis></asset>
    <library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert><diffuse>
      <color>1 0 0 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
    <library_materials><material id="m" name="red"><instance_effect url="#e"/></material></library_materials>
    <library_geometries><geometry id="g"><mesh>
      <source id="p"><float_array id="pa" count="12">0 0 0  2 0 0  2 4 0  0 4 0</float_array>
        <technique_common><accessor source="#pa" count="4" stride="3"/></technique_common></source>
      <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
      <polylist count="1" material="s"><input semantic="VERTEX" source="#v" offset="0"/>
        <input semantic="NORMAL" source="#n" offset="1"/><vcount>4</vcount><p>0 0 1 0 2 0 3 0</p></polylist>
    </mesh></geometry></library_geometries>
    <library_visual_scenes><visual_scene id="s">)" +
         node + R"(</visual_scene></library_visual_scenes>
    <scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

const char* const kPlate = R"(<node name="plate"><translate>0 0 10</translate>
  <rotate>0 0 1 90</rotate><instance_geometry url="#g"><bind_material><technique_common>
  <instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node>)";

TEST(Assets_Collada, UnitUpAxisNodesAndColour) {
  const AssetScene scene = ReadCollada(ToBytes(Collada("Z_UP", kPlate)), "a.dae", {});
  ASSERT_EQ(scene.objects.size(), 1U);
  EXPECT_EQ(scene.objects[0].name, "plate");
  EXPECT_EQ(scene.objects[0].triangles.size(), 2U);
  // 2 x 4 units of 0.5 m, turned a quarter.
  ExpectBox(ExtentOf(scene), {-2, 0, 5}, {0, 1, 5});
  ASSERT_EQ(scene.materials.size(), 1U);
  EXPECT_EQ(scene.materials[0].color.r, 255);
  EXPECT_EQ(scene.materials[0].color.g, 0);
  EXPECT_THAT(scene.objects[0].material_of, ElementsAre(0, 0));
  // With y up what was z points at the viewer, to our -y.
  ExpectBox(ExtentOf(ReadCollada(ToBytes(Collada("Y_UP", kPlate)), "a.dae", {})), {-2, -5, 0},
            {0, -5, 1});
}

TEST(Assets_Collada, WhatIsBrokenIsNamed) {
  const auto error = [](const std::string& dae) {
    return ErrorOf([&] { ReadCollada(ToBytes(dae), "a.dae", {}); });
  };
  EXPECT_THAT(error("<COLLADA><asset>"), HasSubstr("a.dae: offset"));
  EXPECT_THAT(error("<html/>"), HasSubstr("no COLLADA"));
  std::string bad = Collada("Z_UP", kPlate);
  bad.replace(bad.find("0 0 1 0 2 0 3 0"), 15, "0 0 1 0 2 0 9 0");
  EXPECT_THAT(error(bad), HasSubstr("has vertex 9, and there are 4"));
  EXPECT_THAT(error(Collada("Z_UP", R"(<node id="n"><instance_node url="#n"/></node>)")),
              testing::AnyOf("none", HasSubstr("circle")));
  EXPECT_THAT(error(Collada("Z_UP", "<node><translate>1 2</translate></node>")),
              HasSubstr("<translate> has 2 numbers"));
}

}  // namespace
}  // namespace ccmorse::assets
