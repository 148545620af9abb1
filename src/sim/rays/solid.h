#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "base/pose.h"

namespace ccmorse::sim {

/// What a ray can end at.
enum class HitKind : std::uint8_t { kNothing, kFloor, kBox, kMesh, kRobot };

/// A piece of a surface, as a hit names it.
struct Surface {
  HitKind kind = HitKind::kNothing;
  /// Id of the box or of the mesh, index of the robot (ordered by name); 0 for nothing and floor.
  int object = 0;
  /// Of a box or a part of a robot's hull with n corners: side i, from corner i to the next, is
  /// i, its top n, its bottom n + 1; a robot's parts are counted through from the lowest. Boxes
  /// begin at their (+x, +y) corner: 0 is the +y side, 1 -x, 2 -y, 3 +x. Of a mesh: the triangle.
  int surface = 0;

  bool operator==(const Surface& other) const = default;
  bool operator<(const Surface& other) const {
    return std::tie(kind, object, surface) < std::tie(other.kind, other.object, other.surface);
  }
};

/// Triangles in double precision: what the general path of the range engine sees.
struct TriangleSet {
  std::vector<Vec3> corners;      ///< m, three a triangle, counter-clockwise seen from outside
  std::vector<Surface> surfaces;  ///< one a triangle
  /// Seen from outside only, as boxes and hulls are: a sensor within one looks out of it.
  bool closed = true;

  std::size_t size() const { return surfaces.size(); }

  void Add(const Vec3& a, const Vec3& b, const Vec3& c, const Surface& surface);
  /// Adds the upright prism over a convex outline (m, counter-clockwise) from `bottom` to `top`
  /// (m). `first` names its side 0.
  void AddPrism(std::span<const Vec2> outline, double bottom, double top, const Surface& first);
};

/// Surfaces of a prism over `corners` corners.
constexpr int PrismSurfaces(std::size_t corners) { return static_cast<int>(corners) + 2; }

}  // namespace ccmorse::sim
