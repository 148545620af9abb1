#include "scene/mesh.h"

#include <algorithm>
#include <limits>

#include "base/convex_hull.h"
#include "base/rotation.h"
#include "scene/robots.h"

namespace ccmorse::scene {
namespace {

// Heights between which some robot has its body, m above the floor.
struct Slab {
  double bottom = std::numeric_limits<double>::infinity();
  double top = 0.0;
};

Slab RobotSlab() {
  Slab slab;
  for (const std::string& type : RobotTypes()) {
    for (const HullPart& part : FindRobotModel(type).hull) {
      slab.bottom = std::min(slab.bottom, part.bottom);
      slab.top = std::max(slab.top, part.top);
    }
  }
  return slab;
}

// What of a convex polygon lies on the side of `height` that `sign` says: +1 above, -1 below.
std::vector<Vec3> Clipped(const std::vector<Vec3>& polygon, double height, double sign) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& from = polygon[i];
    const Vec3& to = polygon[(i + 1) % polygon.size()];
    const double from_side = sign * (from.z - height);
    const double to_side = sign * (to.z - height);
    if (from_side >= 0.0) kept.push_back(from);
    if ((from_side < 0.0) != (to_side < 0.0)) {
      kept.push_back(from + (from_side / (from_side - to_side)) * (to - from));
    }
  }
  return kept;
}

}  // namespace

std::vector<Vec3> ClippedToSlab(const std::vector<Vec3>& polygon, double bottom, double top) {
  return Clipped(Clipped(polygon, bottom, 1.0), top, -1.0);
}

std::vector<Vec3> PlacedVertices(const Mesh& mesh) {
  const Rotation rotation = FromEuler(mesh.rotation.x, mesh.rotation.y, mesh.rotation.z);
  std::vector<Vec3> placed;
  placed.reserve(mesh.vertices.size());
  for (const Vec3& vertex : mesh.vertices) {
    placed.push_back(mesh.position + Rotate(rotation, vertex));
  }
  return placed;
}

std::vector<std::vector<Vec2>> MeshOutlines(const Mesh& mesh) {
  static const Slab slab = RobotSlab();
  if (!mesh.solid) return {};
  const std::vector<Vec3> vertices = PlacedVertices(mesh);
  std::vector<std::vector<Vec2>> outlines;
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::vector<Vec3> triangle = {vertices[static_cast<std::size_t>(a)],
                                        vertices[static_cast<std::size_t>(b)],
                                        vertices[static_cast<std::size_t>(c)]};
    std::vector<Vec2> points;
    for (const Vec3& point : ClippedToSlab(triangle, slab.bottom, slab.top)) {
      points.push_back({point.x, point.y});
    }
    std::vector<Vec2> outline = ConvexHull(std::move(points));
    if (outline.size() >= 2) outlines.push_back(std::move(outline));
  }
  return outlines;
}

}  // namespace ccmorse::scene
