#include "scene/asset_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include "assets/load.h"
#include "base/error.h"
#include "scene/limits.h"

namespace ccmorse::scene {
namespace {

constexpr double kMargin = 0.5;  // m of floor around what stands on it
constexpr double kClear = 0.05;  // what is less opaque is not drawn

// Collects triangles with their colours; vertices that no triangle has are left behind.
class MeshMaker {
 public:
  explicit MeshMaker(const assets::AssetScene& asset) : asset_(asset) {}

  void Add(const assets::AssetObject& object) {
    std::vector<int> at(object.vertices.size(), -1);
    for (std::size_t i = 0; i < object.triangles.size(); ++i) {
      std::array<int, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto vertex = static_cast<std::size_t>(object.triangles[i][k]);
        if (at[vertex] < 0) {
          at[vertex] = static_cast<int>(mesh_.vertices.size());
          mesh_.vertices.push_back(object.vertices[vertex]);
        }
        triangle[k] = at[vertex];
      }
      mesh_.triangles.push_back(triangle);
      const int index =
          PaletteIndex(object.material_of[i],
                       object.color_of.empty() ? std::nullopt : std::optional(object.color_of[i]));
      mesh_.color_of.push_back(index);
    }
  }

  Mesh Take() {
    // One colour needs no list.
    if (mesh_.palette.size() == 1) {
      mesh_.color = mesh_.palette[0];
      mesh_.palette.clear();
      mesh_.color_of.clear();
    }
    mesh_.drawn = opaque_ || mesh_.triangles.empty();
    return std::move(mesh_);
  }

 private:
  // `shown`: what a picture makes of the material's colour there.
  int PaletteIndex(int material, std::optional<Color> shown) {
    Color color{204, 204, 204};
    if (material >= 0) {
      const assets::AssetMaterial& of = asset_.materials[static_cast<std::size_t>(material)];
      color = of.pictured.value_or(of.color);
      opaque_ = opaque_ || of.alpha >= kClear;
    } else {
      opaque_ = true;
    }
    if (shown) {
      // Of pictures there would be a colour for each triangle: 32 shades a channel will do.
      const auto shade = [](std::uint8_t c) { return static_cast<std::uint8_t>((c & 0xF8U) | 4U); };
      color = {shade(shown->r), shade(shown->g), shade(shown->b)};
    }
    const int key = (color.r << 16) | (color.g << 8) | color.b;
    const auto [found, is_new] = index_of_.try_emplace(key, static_cast<int>(mesh_.palette.size()));
    if (is_new) mesh_.palette.push_back(color);
    return found->second;
  }

  const assets::AssetScene& asset_;
  Mesh mesh_;
  std::map<int, int> index_of_;
  bool opaque_ = false;
};

// A box or ball around it all that shows a sky: the game engine draws its inside only, and views
// from outside would see nothing else.
bool IsSky(const std::string& name) {
  std::string small = name;
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return small.find("sky") != std::string::npos;
}

bool IsFar(const assets::Extent& extent) {
  return std::min({extent.low.x, extent.low.y, extent.low.z}) < -kFarthest ||
         std::max({extent.high.x, extent.high.y, extent.high.z}) > kFarthest;
}

// m2 of a mesh that a robot could stand on, seen from above.
double GroundArea(const Mesh& mesh) {
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& first = mesh.vertices[static_cast<std::size_t>(a)];
    const Vec3 normal = Cross(mesh.vertices[static_cast<std::size_t>(b)] - first,
                              mesh.vertices[static_cast<std::size_t>(c)] - first);
    // Flatter than 45 degrees, from whichever side.
    const double level = std::fabs(normal.z);
    if (level > std::hypot(normal.x, normal.y) && first.z < 1.0) area += level / 2.0;
  }
  return area;
}

}  // namespace

std::string IdentifierOf(const std::string& name) {
  std::string text;
  for (const char c : name.substr(0, 64)) {
    const bool fine = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    text.push_back(fine ? c : '_');
  }
  return text.empty() ? "mesh" : text;
}

void Paint(Color color, Mesh& mesh) {
  if (mesh.color_of.empty()) {
    mesh.color = color;
    return;
  }
  std::vector<double> area(mesh.palette.size(), 0.0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Vec3& first = mesh.vertices[static_cast<std::size_t>(a)];
    const Vec3 normal = Cross(mesh.vertices[static_cast<std::size_t>(b)] - first,
                              mesh.vertices[static_cast<std::size_t>(c)] - first);
    area[static_cast<std::size_t>(mesh.color_of[i])] += std::sqrt(Dot(normal, normal));
  }
  const auto largest = std::max_element(area.begin(), area.end());
  mesh.palette[static_cast<std::size_t>(largest - area.begin())] = color;
}

Mesh MeshOf(const assets::AssetScene& asset, const assets::AssetObject& object) {
  MeshMaker maker(asset);
  maker.Add(object);
  Mesh mesh = maker.Take();
  mesh.name = IdentifierOf(object.name);
  const bool touches = object.physics.Collides() && object.physics.type != "SENSOR";
  mesh.solid = touches && !object.physics.ghost;
  mesh.visible = touches;
  mesh.drawn = mesh.drawn && !object.hidden && !IsSky(object.name);
  return mesh;
}

std::vector<Mesh> MeshesOf(const assets::AssetScene& asset, int first_id,
                           std::vector<std::string>* notes) {
  std::vector<Mesh> meshes;
  for (const assets::AssetObject& object : asset.objects) {
    if (!object.shown || object.triangles.empty()) continue;
    const bool collides = object.physics.Collides();
    if (object.hidden && !collides) continue;
    if (IsFar(assets::ExtentOf(object))) {
      if (notes != nullptr) {
        notes->push_back(fmt::format("object '{}' reaches farther than {} m and is left out",
                                     object.name, kFarthest));
      }
      continue;
    }
    Mesh mesh = MeshOf(asset, object);
    if (first_id > kLastId) throw Error("a world can have ids up to 1000000");
    mesh.id = first_id++;
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

Mesh MergedMesh(const assets::AssetScene& asset) {
  MeshMaker maker(asset);
  for (const assets::AssetObject& object : asset.objects) {
    if (object.shown && !object.hidden) maker.Add(object);
  }
  return maker.Take();
}

World WorldOf(const assets::AssetScene& asset, const std::string& name,
              std::vector<std::string>* notes) {
  World world;
  world.name = IdentifierOf(name);
  world.meshes = MeshesOf(asset, 1, notes);
  if (world.meshes.empty()) throw Error("shows nothing that has a surface");
  assets::Extent extent;
  double ground = 0.0;
  for (const Mesh& mesh : world.meshes) {
    if (!mesh.drawn) continue;
    for (const Vec3& vertex : mesh.vertices) extent.Add(vertex);
    ground += GroundArea(mesh);
  }
  if (extent.empty()) extent = assets::ExtentOf(asset);
  world.low = {extent.low.x, extent.low.y};
  world.size_x = extent.high.x - extent.low.x;
  world.size_y = extent.high.y - extent.low.y;
  constexpr double kShare = 0.2;
  world.has_floor = ground < kShare * world.size_x * world.size_y;
  if (world.has_floor || world.size_x <= 0.0 || world.size_y <= 0.0) {
    world.low = world.low - Vec2{kMargin, kMargin};
    world.size_x += 2.0 * kMargin;
    world.size_y += 2.0 * kMargin;
  }
  if (world.size_x > kFarthest || world.size_y > kFarthest) {
    // A floor larger than a scenario can have is cut; meshes may reach beyond it.
    const Vec2 middle = world.low + 0.5 * Vec2{world.size_x, world.size_y};
    world.size_x = std::min(world.size_x, kFarthest);
    world.size_y = std::min(world.size_y, kFarthest);
    world.low = middle - 0.5 * Vec2{world.size_x, world.size_y};
  }
  for (const assets::AssetObject& object : asset.objects) {
    if (!object.shown || !object.light || object.light->kind != "SUN") continue;
    const Vec3& from = object.matrix.z;  // it shines along -z
    const double length = std::sqrt(Dot(from, from));
    if (!(length > 0.0) || from.z <= 0.05 * length) continue;
    world.lights.push_back(
        {"sun", (1.0 / length) * from, std::clamp(object.light->energy, 0.2, 1.0), true});
  }
  // One sun is what a picture is exposed for.
  if (world.lights.size() > 1) world.lights.resize(1);
  return world;
}

std::vector<PropDef> PropsOf(const assets::AssetScene& asset, const World& world) {
  std::vector<PropDef> props;
  for (const assets::AssetObject& object : asset.objects) {
    if (!object.shown || object.properties.empty()) continue;
    PropDef prop;
    prop.name = object.name;
    prop.position = object.matrix.position;
    for (const assets::AssetProperty& property : object.properties) {
      prop.properties.Set(property.name, property.value);
    }
    const std::string name = IdentifierOf(object.name);
    for (const Mesh& mesh : world.meshes) {
      if (mesh.name == name) prop.meshes.push_back(mesh.id);
    }
    props.push_back(std::move(prop));
  }
  return props;
}

World LoadAssetWorld(const std::string& path, std::vector<PropDef>* props) {
  const assets::AssetScene asset = assets::LoadAsset(path);
  try {
    World world = WorldOf(asset, std::filesystem::path(path).stem().string());
    if (props != nullptr) *props = PropsOf(asset, world);
    return world;
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", path, error.what()));
  }
}

Scenario ScenarioOfAsset(const std::string& path, std::vector<std::string>* notes) {
  const assets::AssetScene asset = assets::LoadAsset(path);
  Scenario scenario;
  scenario.name = std::filesystem::path(path).stem().string();
  try {
    scenario.world = WorldOf(asset, scenario.name, notes);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", path, error.what()));
  }
  if (notes != nullptr) notes->insert(notes->end(), asset.notes.begin(), asset.notes.end());
  const World& world = scenario.world;
  const double size = 0.5 * (world.size_x + world.size_y);
  // From the south, downwards at 45 degrees, about as far away as the scene is wide.
  constexpr double kDown = 0.785;  // rad
  scenario.camera.rotation = {kDown, 0.0, 0.0};
  const double away = std::min(0.95 * size, 0.9 * kFarthest);
  const auto within = [](double v) { return std::clamp(v, -kFarthest, kFarthest); };
  scenario.camera.position = {within(world.low.x + world.size_x / 2.0),
                              within(world.low.y + world.size_y / 2.0 - away), within(away)};
  scenario.canvas.width = 64;
  scenario.canvas.height = 64;
  return scenario;
}

}  // namespace ccmorse::scene
