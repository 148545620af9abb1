#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/pose.h"

namespace ccmorse::assets {

/// Cuts a polygon, flat or nearly so and possibly not convex, into triangles by clipping ears
/// (G. Meisters, "Polygons have ears", 1975). Indexes of `corners`; pieces without an area are left
/// out. One of more than 1024 corners, or that crosses itself, becomes a fan where no ear is left.
std::vector<std::array<int, 3>> Triangulate(std::span<const Vec3> corners);

/// Has the triangle an area worth the name?
bool HasArea(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace ccmorse::assets
