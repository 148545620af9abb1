#pragma once

#include <vector>

#include "base/pose.h"
#include "scene/scenario.h"

namespace ccmorse::scene {

/// What a viewer shows of one of the mesh's triangles. Precondition: it has so many.
inline Color ColorOf(const Mesh& mesh, std::size_t triangle) {
  if (mesh.color_of.empty()) return mesh.color;
  return mesh.palette[static_cast<std::size_t>(mesh.color_of[triangle])];
}

/// The mesh's vertices in the world, m.
std::vector<Vec3> PlacedVertices(const Mesh& mesh);

/// The part of a convex polygon whose z lies within bottom..top, m; fewer than three corners where
/// there is next to none.
std::vector<Vec3> ClippedToSlab(const std::vector<Vec3>& polygon, double bottom, double top);

/// What robots run into of a mesh: the part of each triangle between the heights where robots have
/// their bodies, seen from above. Convex outlines, m, counter-clockwise; of an upright triangle a
/// line of two corners. Triangles above and below give none.
std::vector<std::vector<Vec2>> MeshOutlines(const Mesh& mesh);

}  // namespace ccmorse::scene
