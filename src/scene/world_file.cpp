#include "scene/world_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "assets/load.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/trig.h"
#include "scene/asset_world.h"

namespace ccmorse::scene {
namespace {

constexpr double kLargestSize = 1000.0;  // m; a floor of a kilometre is a mistake in the unit
const Range kCoordinate{-kLargestSize, kLargestSize};
const Range kSize{0.0, kLargestSize, true};

// What the boxes of one kind have in common; also what a box says of itself.
struct Look {
  double height = 0.0;  // 0: not given
  Color color;
  bool has_color = false;
  bool dynamic = false;
  bool raised = true;
  bool solid = true;
  bool visible = true;
};

Look ReadLook(ObjectReader& reader, const Look& fallback) {
  Look look = fallback;
  look.height = reader.Number("height", fallback.height, kSize);
  if (reader.Has("color")) {
    look.color = reader.Require("color").ReadColor();
    look.has_color = true;
  }
  look.dynamic = reader.Bool("dynamic", fallback.dynamic);
  look.raised = reader.Bool("raised", fallback.raised);
  look.solid = reader.Bool("solid", fallback.solid);
  look.visible = reader.Bool("visible", fallback.visible);
  if (!look.dynamic && !look.raised) {
    const char* const key = reader.Has("raised") ? "raised" : "dynamic";
    reader.Require(key).FailHere("leaves a box down that is not dynamic; make it dynamic");
  }
  return look;
}

std::map<std::string, Look> ReadKinds(const Field& field) {
  std::map<std::string, Look> kinds;
  ObjectReader reader(field);
  for (const auto& member : field.value().AsObject()) {
    ObjectReader kind(reader.Require(member.first));
    kinds[member.first] = ReadLook(kind, {});
    kind.Finish();
  }
  return kinds;
}

Box ReadBox(const Field& field, const std::map<std::string, Look>& kinds) {
  ObjectReader reader(field);
  Box box;
  box.id = static_cast<int>(reader.Require("id").Integer(1, 1000000));
  const Field kind = reader.Require("kind");
  box.kind = kind.Identifier();
  Look look;
  if (!kinds.empty()) {
    const auto found = kinds.find(box.kind);
    if (found == kinds.end()) {
      std::vector<std::string> names;
      for (const auto& entry : kinds) names.push_back(Printable(entry.first));
      kind.FailHere(fmt::format("is {}, must be one of {}{}", Quoted(box.kind), Listed(names),
                                DidYouMean(box.kind, names)));
    }
    look = found->second;
  }
  look = ReadLook(reader, look);
  if (look.height == 0.0) static_cast<void>(reader.Require("height"));
  if (!look.has_color) static_cast<void>(reader.Require("color"));
  box.height = look.height;
  box.color = look.color;
  box.dynamic = look.dynamic;
  box.raised = look.raised;
  box.solid = look.solid;
  box.visible = look.visible;
  box.pose.x = reader.Require("x").Number(kCoordinate);
  box.pose.y = reader.Require("y").Number(kCoordinate);
  box.pose.yaw = reader.Angle("yaw", 0.0);
  const Field size = reader.Require("size");
  const std::vector<Field> sides = size.Items();
  if (sides.size() != 2) size.FailHere(fmt::format("has {} numbers, must be [x, y]", sides.size()));
  box.size_x = sides[0].Number(kSize);
  box.size_y = sides[1].Number(kSize);
  reader.Finish();
  return box;
}

std::vector<Box> ReadBoxes(const Field& field, const std::map<std::string, Look>& kinds) {
  std::vector<Box> boxes;
  std::map<int, int> line_of_id;
  for (const Field& item : field.Items()) {
    Box box = ReadBox(item, kinds);
    const auto [other, is_new] = line_of_id.emplace(box.id, item.line());
    if (!is_new) {
      item.FailHere(fmt::format("has id {}, as has the box on line {}; ids must be unique", box.id,
                                other->second));
    }
    boxes.push_back(std::move(box));
  }
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.id < b.id; });
  return boxes;
}

std::array<int, 3> ReadTriangle(const Field& field, const std::vector<Vec3>& vertices) {
  const std::vector<Field> items = field.Items();
  if (items.size() != 3) {
    field.FailHere(fmt::format("has {} numbers, must be the indexes of 3 vertices", items.size()));
  }
  const auto last = static_cast<std::int64_t>(vertices.size()) - 1;
  std::array<int, 3> triangle{};
  for (std::size_t i = 0; i < 3; ++i) triangle[i] = static_cast<int>(items[i].Integer(0, last));
  const auto corner = [&](std::size_t i) {
    return vertices[static_cast<std::size_t>(triangle[i])];
  };
  const Vec3 normal = Cross(corner(1) - corner(0), corner(2) - corner(0));
  if (!(Dot(normal, normal) > 0.0)) {
    field.FailHere(fmt::format("joins vertices {}, {} and {}, which lie on one line; remove it",
                               triangle[0], triangle[1], triangle[2]));
  }
  return triangle;
}

// What meshes of both kinds have: place, colour, and whom they concern.
void FinishMesh(ObjectReader& reader, Mesh& mesh) {
  mesh.position = reader.Vector("position", mesh.position, kLargestSize);
  mesh.rotation = reader.Vector("rotation", mesh.rotation, 20.0 * kPi);
  mesh.color = reader.ReadColor("color", mesh.color);
  mesh.solid = reader.Bool("solid", mesh.solid);
  mesh.visible = reader.Bool("visible", mesh.visible);
  mesh.drawn = reader.Bool("drawn", mesh.drawn);
  reader.Finish();
}

// Has each triangle a colour of its own?
void ReadPalette(ObjectReader& reader, Mesh& mesh) {
  if (!reader.Has("color_of")) return;
  for (const Field& color : reader.Require("palette").Items()) {
    mesh.palette.push_back(color.ReadColor());
  }
  const Field color_of = reader.Require("color_of");
  const auto last = static_cast<std::int64_t>(mesh.palette.size()) - 1;
  for (const Field& index : color_of.Items()) {
    mesh.color_of.push_back(static_cast<int>(index.Integer(0, last)));
  }
  if (mesh.color_of.size() != mesh.triangles.size()) {
    color_of.FailHere(fmt::format("has {} numbers, must have one for each of {} triangles",
                                  mesh.color_of.size(), mesh.triangles.size()));
  }
}

// The shapes of another file as one mesh.
void ReadMeshFile(ObjectReader& reader, Mesh& mesh) {
  const Field file = reader.Require("file");
  const double scale = reader.Number("scale", 1.0, {0.0, kLargestSize, true});
  try {
    const std::string folder = std::filesystem::path(file.file()).parent_path().string();
    Mesh merged = MergedMesh(assets::LoadAsset(assets::FindAsset(file.Text(), folder)));
    merged.id = mesh.id;
    merged.name = mesh.name;
    mesh = std::move(merged);
  } catch (const Error& error) {
    file.Fail(error.what());
  }
  if (mesh.triangles.empty()) file.FailHere("has nothing that has a surface");
  for (Vec3& vertex : mesh.vertices) {
    vertex = scale * vertex;
    if (!(std::max({std::fabs(vertex.x), std::fabs(vertex.y), std::fabs(vertex.z)}) <=
          kLargestSize)) {
      file.FailHere(
          fmt::format("reaches farther than {} m; give it another 'scale'", kLargestSize));
    }
  }
  if (reader.Has("color")) {
    mesh.palette.clear();
    mesh.color_of.clear();
  }
}

Mesh ReadMesh(const Field& field, bool needs_id = true) {
  ObjectReader reader(field);
  Mesh mesh;
  if (needs_id || reader.Has("id")) {
    mesh.id = static_cast<int>(reader.Require("id").Integer(1, 1000000));
  }
  if (reader.Has("name")) mesh.name = reader.Require("name").Identifier();
  if (reader.Has("file")) {
    ReadMeshFile(reader, mesh);
    FinishMesh(reader, mesh);
    return mesh;
  }
  const Field vertices = reader.Require("vertices");
  for (const Field& vertex : vertices.Items()) {
    mesh.vertices.push_back(vertex.Vector(kLargestSize));
  }
  if (mesh.vertices.size() < 3) {
    vertices.FailHere(fmt::format("has {} vertices, must have 3 or more", mesh.vertices.size()));
  }
  const Field triangles = reader.Require("triangles");
  for (const Field& triangle : triangles.Items()) {
    mesh.triangles.push_back(ReadTriangle(triangle, mesh.vertices));
  }
  if (mesh.triangles.empty()) triangles.FailHere("is empty, must have a triangle or more");
  ReadPalette(reader, mesh);
  FinishMesh(reader, mesh);
  return mesh;
}

std::vector<Mesh> ReadMeshes(const Field& field, const std::vector<Box>& boxes) {
  std::vector<Mesh> meshes;
  std::map<int, int> line_of_id;
  for (const Field& item : field.Items()) {
    Mesh mesh = ReadMesh(item);
    const auto [other, is_new] = line_of_id.emplace(mesh.id, item.line());
    if (!is_new) {
      item.FailHere(fmt::format("has id {}, as has the mesh on line {}; ids must be unique",
                                mesh.id, other->second));
    }
    if (std::any_of(boxes.begin(), boxes.end(),
                    [&mesh](const Box& box) { return box.id == mesh.id; })) {
      item.FailHere(fmt::format("has id {}, as has a box; ids must be unique", mesh.id));
    }
    meshes.push_back(std::move(mesh));
  }
  std::sort(meshes.begin(), meshes.end(), [](const Mesh& a, const Mesh& b) { return a.id < b.id; });
  return meshes;
}

// Hardly any box or mesh says so, and a file of thousands is long enough.
void AddUnlessTrue(const char* key, bool value, Json::Object& object) {
  if (!value) object.emplace_back(key, false);
}

Json MeshToJson(const Mesh& mesh) {
  Json::Array vertices;
  for (const Vec3& vertex : mesh.vertices) vertices.push_back(VectorToJson(vertex));
  Json::Array triangles;
  for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(Json::Array{a, b, c});
  Json::Object object = {{"id", mesh.id}};
  if (!mesh.name.empty()) object.emplace_back("name", mesh.name);
  object.insert(object.end(), {{"vertices", std::move(vertices)},
                               {"triangles", std::move(triangles)},
                               {"position", VectorToJson(mesh.position)},
                               {"rotation", VectorToJson(mesh.rotation)},
                               {"color", ColorText(mesh.color)}});
  if (!mesh.color_of.empty()) {
    Json::Array palette;
    for (const Color& color : mesh.palette) palette.emplace_back(ColorText(color));
    Json::Array color_of(mesh.color_of.begin(), mesh.color_of.end());
    object.emplace_back("palette", std::move(palette));
    object.emplace_back("color_of", std::move(color_of));
  }
  AddUnlessTrue("solid", mesh.solid, object);
  AddUnlessTrue("visible", mesh.visible, object);
  AddUnlessTrue("drawn", mesh.drawn, object);
  return object;
}

// [x, y] in the world, m.
Vec2 ReadPoint(const Field& field) {
  const std::vector<Field> place = field.Items();
  if (place.size() != 2) {
    field.FailHere(fmt::format("has {} numbers, must be [x, y]", place.size()));
  }
  return {place[0].Number(kCoordinate), place[1].Number(kCoordinate)};
}

Light ReadLight(const Field& field) {
  static const std::vector<std::string> kinds = {"sun", "spot"};
  ObjectReader reader(field);
  Light light;
  light.kind = reader.Require("kind").Choice(kinds);
  light.position = reader.Require("position").Vector(kLargestSize);
  light.energy = reader.Number("energy", light.energy, {0.0, 1000.0});
  light.shadows = reader.Bool("shadows", light.shadows);
  reader.Finish();
  return light;
}

}  // namespace

std::vector<Mesh> ReadShape(const Field& field) {
  std::vector<Mesh> shape;
  for (const Field& item : field.Items()) {
    Mesh mesh = ReadMesh(item, false);
    mesh.id = static_cast<int>(shape.size()) + 1;
    mesh.solid = mesh.visible = false;
    shape.push_back(std::move(mesh));
  }
  return shape;
}

Json ShapeToJson(const std::vector<Mesh>& shape) {
  Json::Array list;
  for (const Mesh& mesh : shape) list.push_back(MeshToJson(mesh));
  return list;
}

World ReadWorld(const Field& field) {
  ObjectReader reader(field);
  World world;
  world.name = reader.Require("name").Identifier();
  const Field size = reader.Require("size");
  const std::vector<Field> sides = size.Items();
  if (sides.size() != 2) size.FailHere(fmt::format("has {} numbers, must be [x, y]", sides.size()));
  world.size_x = sides[0].Number(kSize);
  world.size_y = sides[1].Number(kSize);
  if (reader.Has("low")) world.low = ReadPoint(reader.Require("low"));
  if (reader.Has("origin")) world.origin = ReadPoint(reader.Require("origin"));
  if (reader.Has("floor") && reader.Require("floor").value().IsBool()) {
    world.has_floor = reader.Require("floor").Bool();
  } else {
    world.floor = reader.ReadColor("floor", world.floor);
  }
  world.terrain = reader.Bool("terrain", false);
  std::map<std::string, Look> kinds;
  if (reader.Has("kinds")) kinds = ReadKinds(reader.Require("kinds"));
  if (reader.Has("boxes")) world.boxes = ReadBoxes(reader.Require("boxes"), kinds);
  if (reader.Has("meshes")) {
    world.meshes = ReadMeshes(reader.Require("meshes"), world.boxes);
  }
  if (reader.Has("docks")) {
    for (const Field& dock : reader.Require("docks").Items()) world.docks.push_back(ReadPose(dock));
  }
  if (reader.Has("lights")) {
    for (const Field& light : reader.Require("lights").Items()) {
      world.lights.push_back(ReadLight(light));
    }
  }
  reader.Finish();
  return world;
}

World LoadWorld(const std::string& path) {
  const std::string text = ReadFile(path);
  try {
    const Json json = Json::Parse(text);
    return ReadWorld(Field(json, "", path));
  } catch (const JsonError& error) {
    throw Error(
        fmt::format("{}:{}: {} (column {})", path, error.line(), error.reason(), error.column()));
  }
}

Json WorldToJson(const World& world) {
  Json::Array boxes;
  for (const Box& box : world.boxes) {
    Json::Object object = {{"id", box.id},         {"kind", box.kind},
                           {"x", box.pose.x},      {"y", box.pose.y},
                           {"yaw", box.pose.yaw},  {"size", Json::Array{box.size_x, box.size_y}},
                           {"height", box.height}, {"color", ColorText(box.color)}};
    if (box.dynamic) {
      object.emplace_back("dynamic", true);
      object.emplace_back("raised", false);
    }
    AddUnlessTrue("solid", box.solid, object);
    AddUnlessTrue("visible", box.visible, object);
    boxes.emplace_back(std::move(object));
  }
  Json::Array meshes;
  for (const Mesh& mesh : world.meshes) meshes.push_back(MeshToJson(mesh));
  Json::Array docks;
  for (const Pose2& dock : world.docks) docks.push_back(PoseToJson(dock));
  Json::Array lights;
  for (const Light& light : world.lights) {
    lights.emplace_back(Json::Object{{"kind", light.kind},
                                     {"position", VectorToJson(light.position)},
                                     {"energy", light.energy},
                                     {"shadows", light.shadows}});
  }
  Json::Object object = {{"name", world.name},
                         {"size", Json::Array{world.size_x, world.size_y}},
                         {"origin", Json::Array{world.origin.x, world.origin.y}},
                         {"floor", world.has_floor ? Json(ColorText(world.floor)) : Json(false)},
                         {"boxes", std::move(boxes)},
                         {"meshes", std::move(meshes)},
                         {"docks", std::move(docks)},
                         {"lights", std::move(lights)}};
  if (world.terrain) object.emplace_back("terrain", true);
  if (world.low.x != 0.0 || world.low.y != 0.0) {
    object.emplace_back("low", Json::Array{world.low.x, world.low.y});
  }
  return object;
}

Pose2 ReadPose(const Field& field) {
  ObjectReader reader(field);
  Pose2 pose;
  pose.x = reader.Require("x").Number(kCoordinate);
  pose.y = reader.Require("y").Number(kCoordinate);
  pose.yaw = reader.Angle("yaw", 0.0);
  reader.Finish();
  return pose;
}

Json PoseToJson(const Pose2& pose) {
  return Json::Object{{"x", pose.x}, {"y", pose.y}, {"yaw", pose.yaw}};
}

Json VectorToJson(const Vec3& vector) { return Json::Array{vector.x, vector.y, vector.z}; }

}  // namespace ccmorse::scene
