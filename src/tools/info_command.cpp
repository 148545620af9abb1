#include "tools/info_command.h"

#include <fmt/core.h>

#include <algorithm>

#include "assets/load.h"

namespace ccmorse::tools {
namespace {

using assets::AssetObject;
using assets::AssetScene;
using assets::Extent;

Json Point(const Vec3& v) { return Json(Json::Array{v.x, v.y, v.z}); }

Json ToJson(const AssetScene& scene) {
  Json::Array objects;
  for (const AssetObject& object : scene.objects) {
    Json::Object properties;
    for (const assets::AssetProperty& property : object.properties) {
      properties.emplace_back(property.name, property.value);
    }
    const Extent extent = ExtentOf(object);
    Json parent;
    if (object.parent >= 0) parent = scene.objects[static_cast<std::size_t>(object.parent)].name;
    objects.emplace_back(
        Json::Object{{"name", object.name},
                     {"type", object.type},
                     {"parent", std::move(parent)},
                     {"position", Point(object.matrix.position)},
                     {"low", extent.empty() ? Json() : Point(extent.low)},
                     {"high", extent.empty() ? Json() : Point(extent.high)},
                     {"vertices", static_cast<std::int64_t>(object.vertices.size())},
                     {"faces", object.faces},
                     {"triangles", static_cast<std::int64_t>(object.triangles.size())},
                     {"shown", object.shown},
                     {"hidden", object.hidden},
                     {"instance", object.instance},
                     {"physics", object.physics.type},
                     {"actor", object.physics.actor},
                     {"ghost", object.physics.ghost},
                     {"mass", object.physics.mass},
                     {"radius", object.physics.radius},
                     {"bounds", object.physics.bounds},
                     {"properties", std::move(properties)}});
  }
  Json::Array notes(scene.notes.begin(), scene.notes.end());
  return Json::Object{{"format", scene.format},
                      {"gravity", Point(scene.gravity)},
                      {"materials", static_cast<std::int64_t>(scene.materials.size())},
                      {"images", static_cast<std::int64_t>(scene.images.size())},
                      {"objects", std::move(objects)},
                      {"notes", std::move(notes)}};
}

std::string SizeText(const Extent& extent) {
  if (extent.empty()) return "-";
  const Vec3 size = extent.high - extent.low;
  return fmt::format("{:.2f} x {:.2f} x {:.2f}", size.x, size.y, size.z);
}

// "RIGID_BODY 20 kg, CONVEX_HULL, actor"
std::string PhysicsText(const AssetObject& object) {
  const assets::AssetPhysics& physics = object.physics;
  std::string text = physics.type;
  if (physics.type != "STATIC" && physics.Collides()) text += fmt::format(" {:g} kg", physics.mass);
  if (!physics.bounds.empty()) text += ", " + physics.bounds;
  if (physics.compound) text += ", compound";
  if (physics.actor) text += ", actor";
  if (physics.ghost) text += ", ghost";
  return text;
}

}  // namespace

int Info(const InfoArguments& arguments) {
  const std::string path = assets::FindAsset(arguments.file, "");
  assets::LoadReport report;
  const AssetScene scene = assets::LoadAsset(path, {}, &report);
  if (arguments.json) {
    fmt::print("{}\n", ToJson(scene).Dump());
    return 0;
  }
  std::size_t triangles = 0;
  std::size_t width = 6;
  for (const AssetObject& object : scene.objects) {
    triangles += object.triangles.size();
    width = std::max(width, std::min<std::size_t>(object.name.size(), 40));
  }
  fmt::print("{}: {}, {} objects, {} triangles, {} materials, {} images; read in {:.0f} ms{}\n",
             path, scene.format, scene.objects.size(), triangles, scene.materials.size(),
             scene.images.size(), 1e3 * report.seconds, report.from_cache ? " from the cache" : "");
  const Extent whole = ExtentOf(scene);
  if (!whole.empty()) {
    fmt::print("shown: {} m, from ({:.2f}, {:.2f}, {:.2f}) to ({:.2f}, {:.2f}, {:.2f})\n",
               SizeText(whole), whole.low.x, whole.low.y, whole.low.z, whole.high.x, whole.high.y,
               whole.high.z);
  }
  fmt::print("{:<{}}  {:<8}  {:<24}  {:>9}  physics; properties\n", "object", width, "type",
             "size, m", "triangles");
  for (const AssetObject& object : scene.objects) {
    std::string more = PhysicsText(object);
    for (const assets::AssetProperty& property : object.properties) {
      more += fmt::format("; {} = {}", assets::OneLine(property.name), property.value.Dump());
    }
    if (!object.shown) more += "; not shown";
    if (object.hidden) more += "; hidden";
    fmt::print("{:<{}}  {:<8}  {:<24}  {:>9}  {}\n", assets::OneLine(object.name), width,
               object.type, SizeText(ExtentOf(object)), object.triangles.size(), more);
  }
  for (const std::string& note : scene.notes) fmt::print("not read: {}\n", note);
  return 0;
}

}  // namespace ccmorse::tools
