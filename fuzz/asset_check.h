#pragma once

#include <cmath>
#include <string>

#include "assets/asset_scene.h"
#include "base/error.h"
#include "fuzz/check.h"

namespace ccmorse::fuzz {

/// Calls read(limits) with small limits, and requires that it gives a sound scene or throws an
/// Error of one line about "input".
template <typename Read>
void CheckReader(const Read& read) {
  const assets::AssetLimits limits{std::size_t{1} << 22U, 20'000, 2'000};
  assets::AssetScene scene;
  try {
    scene = read(limits);
  } catch (const Error& error) {
    const std::string what = error.what();
    Require(what.find('\n') == std::string::npos, "an Error is one line", what);
    Require(what.starts_with("input:"), "an Error names the file", what);
    return;
  }
  const auto objects = static_cast<int>(scene.objects.size());
  const auto materials = static_cast<int>(scene.materials.size());
  const auto images = static_cast<int>(scene.images.size());
  Require(scene.objects.size() <= limits.objects, "objects are within the limit", "");
  Require(scene.camera >= -1 && scene.camera < objects, "the camera is an object", "");
  for (const assets::AssetMaterial& material : scene.materials) {
    Require(material.image >= -1 && material.image < images, "a material's image is there", "");
  }
  std::size_t triangles = 0;
  for (const assets::AssetObject& object : scene.objects) {
    Require(object.parent >= -1 && object.parent < objects, "a parent is an object", object.name);
    int steps = 0;
    for (int up = object.parent; up >= 0; up = scene.objects[static_cast<std::size_t>(up)].parent) {
      Require(++steps <= objects, "parents do not run in a circle", object.name);
    }
    for (const Vec3& v : object.vertices) {
      Require(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z),
              "positions are finite", object.name);
    }
    Require(object.material_of.size() == object.triangles.size(), "every triangle has its material",
            object.name);
    for (const int material : object.material_of) {
      Require(material >= -1 && material < materials, "a material is there", object.name);
    }
    for (const auto& triangle : object.triangles) {
      for (const int corner : triangle) {
        Require(corner >= 0 && static_cast<std::size_t>(corner) < object.vertices.size(),
                "a corner is a vertex", object.name);
      }
    }
    triangles += object.triangles.size();
  }
  Require(triangles <= limits.triangles, "triangles are within the limit", "");
}

}  // namespace ccmorse::fuzz
