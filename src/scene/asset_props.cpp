#include "scene/asset_props.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/convex_hull.h"
#include "base/error.h"
#include "base/euler.h"
#include "base/rotation.h"
#include "scene/asset_world.h"
#include "scene/limits.h"
#include "scene/mesh.h"

namespace ccmorse::scene {
namespace {

constexpr int kSlices = 12;  // of a robot's hull
constexpr std::size_t kHullCorners = 32;

// The rotation in an affine map, without its scale; none where it has no extent along an axis.
Rotation RotationIn(const assets::Affine& map) {
  const double x = Length(map.x);
  const double z = Length(map.z);
  if (!(x > 0.0) || !(z > 0.0)) return {};
  Rotation rotation;
  rotation.z = (1.0 / z) * map.z;
  const Vec3 side = Cross(rotation.z, map.x);
  if (!(Length(side) > 0.0)) return {};
  rotation.y = (1.0 / Length(side)) * side;
  rotation.x = Cross(rotation.y, rotation.z);
  return rotation;
}

bool IsBelow(const assets::AssetScene& asset, int object, int root) {
  for (std::size_t steps = 0; object >= 0 && steps <= asset.objects.size(); ++steps) {
    if (object == root) return true;
    object = asset.objects[static_cast<std::size_t>(object)].parent;
  }
  return false;
}

// Indexes of the objects that `prefix` names, and first among them the root: the first that has no
// parent among them.
std::vector<int> Chosen(const assets::AssetScene& asset, const std::string& prefix) {
  std::vector<int> chosen;
  for (std::size_t i = 0; i < asset.objects.size(); ++i) {
    const assets::AssetObject& object = asset.objects[i];
    // What a name asks for may lie on any layer: MORSE appends it to the scene by that name.
    const bool wanted = prefix.empty() ? object.shown : object.name.starts_with(prefix);
    if (wanted && !object.instance) chosen.push_back(static_cast<int>(i));
  }
  const auto is_root = [&](int index) {
    const assets::AssetObject& object = asset.objects[static_cast<std::size_t>(index)];
    if (object.light || object.camera) return false;
    return std::none_of(chosen.begin(), chosen.end(),
                        [&](int other) { return other != index && IsBelow(asset, index, other); });
  };
  const auto root = std::find_if(chosen.begin(), chosen.end(), is_root);
  if (root == chosen.end()) return {};
  std::rotate(chosen.begin(), root, root + 1);
  // What a group puts in the place of one of them goes with it.
  for (std::size_t i = 0; i < asset.objects.size(); ++i) {
    const assets::AssetObject& object = asset.objects[i];
    if (!object.instance) continue;
    const bool wanted = std::any_of(chosen.begin(), chosen.end(), [&](int other) {
      return IsBelow(asset, object.parent, other);
    });
    if (wanted) chosen.push_back(static_cast<int>(i));
  }
  return chosen;
}

void Scale(const Vec3& scale, Mesh& mesh) {
  for (Vec3& v : mesh.vertices) v = {scale.x * v.x, scale.y * v.y, scale.z * v.z};
}

// A mirror or a scale of nothing leaves triangles without an area, which nothing can hit.
void DropFlat(Mesh& mesh) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Vec3& first = mesh.vertices[static_cast<std::size_t>(a)];
    const Vec3 normal = Cross(mesh.vertices[static_cast<std::size_t>(b)] - first,
                              mesh.vertices[static_cast<std::size_t>(c)] - first);
    if (!(Dot(normal, normal) > 0.0)) continue;
    mesh.triangles[kept] = mesh.triangles[i];
    if (!mesh.color_of.empty()) mesh.color_of[kept] = mesh.color_of[i];
    ++kept;
  }
  mesh.triangles.resize(kept);
  if (!mesh.color_of.empty()) mesh.color_of.resize(kept);
}

// What a script's word for the physics makes of an object.
void ApplyPhysics(const std::string& physics, Mesh& mesh) {
  if (physics.empty()) return;
  mesh.solid = physics != "NO_COLLISION" && physics != "SENSOR" && physics != "OCCLUDER";
  mesh.visible = mesh.solid;
}

double Reach(const Mesh& mesh) {
  double reach = 0.0;
  for (const Vec3& v : mesh.vertices) {
    reach = std::max({reach, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  }
  return reach;
}

std::vector<Vec3> Between(const Mesh& mesh, const std::array<int, 3>& triangle, double bottom,
                          double top) {
  std::vector<Vec3> polygon;
  for (const int corner : triangle) {
    polygon.push_back(mesh.vertices[static_cast<std::size_t>(corner)]);
  }
  return ClippedToSlab(polygon, bottom, top);
}

bool Alike(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  constexpr double kSame = 1e-6;  // m
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::fabs(a[i].x - b[i].x) > kSame || std::fabs(a[i].y - b[i].y) > kSame) return false;
  }
  return true;
}

}  // namespace

std::vector<Vec2> RoundedHull(std::vector<Vec2> points, std::size_t most) {
  std::vector<Vec2> hull = ConvexHull(std::move(points));
  while (hull.size() > most && hull.size() > 3) {
    std::size_t least = 0;
    double least_area = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Vec2 before = hull[(i + hull.size() - 1) % hull.size()];
      const double area = Cross(hull[i] - before, hull[(i + 1) % hull.size()] - before);
      if (area < least_area) {
        least_area = area;
        least = i;
      }
    }
    hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(least));
  }
  return hull;
}

std::vector<HullPart> SlicedHull(const std::vector<Mesh>& meshes, double lowest) {
  double highest = lowest;
  for (const Mesh& mesh : meshes) {
    for (const Vec3& v : mesh.vertices) highest = std::max(highest, v.z);
  }
  constexpr double kThinnest = 0.01;  // m: what is flatter is one slice
  const int slices = highest - lowest < kSlices * kThinnest ? 1 : kSlices;
  const double step = (highest - lowest) / slices;
  std::vector<HullPart> hull;
  for (int i = 0; i < slices && step > 0.0; ++i) {
    const double bottom = lowest + i * step;
    const double top = i + 1 == slices ? highest : bottom + step;
    std::vector<Vec2> points;
    for (const Mesh& mesh : meshes) {
      for (const auto& triangle : mesh.triangles) {
        for (const Vec3& point : Between(mesh, triangle, bottom, top)) {
          points.push_back({point.x, point.y});
        }
      }
    }
    std::vector<Vec2> outline = RoundedHull(std::move(points), kHullCorners);
    if (outline.size() < 3) continue;
    if (!hull.empty() && hull.back().top == bottom - lowest &&
        Alike(hull.back().outline, outline)) {
      hull.back().top = top - lowest;
    } else {
      hull.push_back({std::move(outline), bottom - lowest, top - lowest});
    }
  }
  return hull;
}

std::vector<Mesh> MeshesOfProp(const assets::AssetScene& asset, const PropPlace& place,
                               int first_id, PropDef& prop) {
  const std::vector<int> chosen = Chosen(asset, prop.object);
  if (chosen.empty()) {
    throw Error(prop.object.empty() ? std::string("shows no object")
                                    : fmt::format("has no object called {}", prop.object));
  }
  const assets::AssetObject& root = asset.objects[static_cast<std::size_t>(chosen[0])];
  const Rotation turned = RotationIn(root.matrix);
  const Vec3 origin = root.matrix.position;
  if (place.keep_pose) {
    prop.position = prop.position + origin;
    prop.rotation = prop.rotation + ToEuler(turned);
  }
  for (const assets::AssetProperty& property : root.properties) {
    if (prop.properties.Find(property.name) == nullptr) {
      prop.properties.Set(property.name, property.value);
    }
  }
  std::vector<Mesh> meshes;
  for (const int index : chosen) {
    const assets::AssetObject& object = asset.objects[static_cast<std::size_t>(index)];
    if (object.triangles.empty() || (object.hidden && !object.physics.Collides())) continue;
    Mesh mesh = MeshOf(asset, object);
    for (Vec3& v : mesh.vertices) v = RotateBack(turned, v - origin);
    Scale(place.scale, mesh);
    DropFlat(mesh);
    if (mesh.triangles.empty() || Reach(mesh) > kFarthest) continue;
    ApplyPhysics(place.physics, mesh);
    if (first_id > kLastId) throw Error("a world can have ids up to 1000000");
    mesh.id = first_id++;
    mesh.position = prop.position;
    mesh.rotation = prop.rotation;
    prop.meshes.push_back(mesh.id);
    meshes.push_back(std::move(mesh));
  }
  if (meshes.empty()) throw Error("has nothing there that has a surface");
  return meshes;
}

std::vector<Mesh> PlacedShape(std::vector<Mesh> shape, const PropPlace& place,
                              const PropDef& prop) {
  for (Mesh& mesh : shape) {
    mesh.vertices = PlacedVertices(mesh);  // in the prop's frame
    Scale(place.scale, mesh);
    DropFlat(mesh);
    mesh.position = prop.position;
    mesh.rotation = prop.rotation;
    ApplyPhysics(place.physics.empty() ? "NO_COLLISION" : place.physics, mesh);
  }
  return shape;
}

RobotShape RobotShapeOf(const assets::AssetScene& asset, const std::string& physics,
                        const Vec3& scale) {
  const std::vector<int> chosen = Chosen(asset, "");
  if (chosen.empty()) throw Error("shows no object");
  const assets::AssetObject& root = asset.objects[static_cast<std::size_t>(chosen[0])];
  RobotShape result;
  result.mass = root.physics.mass > 0.0 ? root.physics.mass : 1.0;
  const std::string& type = physics.empty() ? root.physics.type : physics;
  std::vector<Mesh> touching;
  std::vector<Mesh> all;
  for (const int index : chosen) {
    const assets::AssetObject& object = asset.objects[static_cast<std::size_t>(index)];
    if (object.triangles.empty() || (object.hidden && !object.physics.Collides())) continue;
    Mesh mesh = MeshOf(asset, object);
    for (Vec3& v : mesh.vertices) v = v - root.matrix.position;
    Scale(scale, mesh);
    DropFlat(mesh);
    if (mesh.triangles.empty() || Reach(mesh) > kFarthest) continue;
    if (index == chosen[0]) ApplyPhysics(physics, mesh);
    if (mesh.solid) touching.push_back(mesh);
    all.push_back(mesh);
    if (!mesh.drawn) continue;
    mesh.id = static_cast<int>(result.shape.size()) + 1;
    mesh.solid = mesh.visible = false;
    result.shape.push_back(std::move(mesh));
  }
  if (all.empty()) throw Error("has nothing that has a surface");
  result.collides = type != "NO_COLLISION" || !touching.empty();
  if (touching.empty()) touching = std::move(all);
  result.lowest = std::numeric_limits<double>::infinity();
  std::vector<Vec2> points;
  for (const Mesh& mesh : touching) {
    for (const auto& triangle : mesh.triangles) {
      for (const int corner : triangle) {
        const Vec3& v = mesh.vertices[static_cast<std::size_t>(corner)];
        points.push_back({v.x, v.y});
        result.lowest = std::min(result.lowest, v.z);
      }
    }
  }
  result.footprint = RoundedHull(std::move(points), kFootprintCorners);
  if (result.footprint.size() < 3) throw Error("is flat: a robot needs a body with an area");
  result.hull = SlicedHull(touching, result.lowest);
  return result;
}

Mesh Simplified(Mesh mesh, std::size_t most) {
  if (mesh.triangles.size() <= most) return mesh;
  const Mesh whole = std::move(mesh);
  const double size = Reach(whole);
  Mesh result;
  for (double cell = size / 256.0;; cell *= 1.5) {
    result = whole;
    result.vertices.clear();
    result.triangles.clear();
    result.color_of.clear();
    // The mean of the corners of a cell takes their place.
    std::map<std::array<std::int64_t, 3>, int> index_of;
    std::vector<int> of(whole.vertices.size());
    std::vector<int> members;
    for (std::size_t i = 0; i < whole.vertices.size(); ++i) {
      const Vec3& v = whole.vertices[i];
      const std::array<std::int64_t, 3> key = {static_cast<std::int64_t>(std::floor(v.x / cell)),
                                               static_cast<std::int64_t>(std::floor(v.y / cell)),
                                               static_cast<std::int64_t>(std::floor(v.z / cell))};
      const auto [found, is_new] = index_of.emplace(key, static_cast<int>(members.size()));
      if (is_new) {
        result.vertices.push_back({});
        members.push_back(0);
      }
      of[i] = found->second;
      const auto at = static_cast<std::size_t>(found->second);
      result.vertices[at] = result.vertices[at] + v;
      ++members[at];
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
      result.vertices[i] = (1.0 / members[i]) * result.vertices[i];
    }
    std::set<std::array<int, 3>> known;
    for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
      std::array<int, 3> t{};
      for (std::size_t k = 0; k < 3; ++k) {
        t[k] = of[static_cast<std::size_t>(whole.triangles[i][k])];
      }
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      std::array<int, 3> key = t;
      std::sort(key.begin(), key.end());
      if (!known.insert(key).second) continue;
      result.triangles.push_back(t);
      if (!whole.color_of.empty()) result.color_of.push_back(whole.color_of[i]);
    }
    DropFlat(result);
    if (result.triangles.size() <= most) return result;
  }
}

}  // namespace ccmorse::scene
