#include "assets/shape_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "assets/triangulate.h"
#include "base/error.h"

namespace ccmorse::assets {

AssetObject& ShapeBuilder::AddObject(const std::string& name, const Affine& matrix,
                                     const std::string& type) {
  if (scene_.objects.size() >= limits_.objects) {
    Fail(fmt::format("has more than {} objects", limits_.objects));
  }
  AssetObject& object = scene_.objects.emplace_back();
  object.name = name;
  object.type = type;
  object.matrix = matrix;
  return object;
}

void ShapeBuilder::AddVertex(const Vec3& vertex, AssetObject& object) {
  if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y) || !std::isfinite(vertex.z)) {
    Fail(fmt::format("vertex {} of '{}' is nowhere", object.vertices.size(), object.name));
  }
  if (++vertices_ / 3 > limits_.triangles) {
    Fail(fmt::format("has more than {} vertices", 3 * limits_.triangles));
  }
  object.vertices.push_back(vertex);
}

void ShapeBuilder::AddFace(const std::vector<int>& face, int material, AssetObject& object) {
  std::vector<Vec3> corners;
  for (const int i : face) {
    if (i < 0 || static_cast<std::size_t>(i) >= object.vertices.size()) {
      Fail(fmt::format("a face of '{}' has vertex {}, and there are {}", object.name, i,
                       object.vertices.size()));
    }
    corners.push_back(object.vertices[static_cast<std::size_t>(i)]);
  }
  ++object.faces;
  for (const auto& [a, b, c] : Triangulate(corners)) {
    object.triangles.push_back({face[static_cast<std::size_t>(a)],
                                face[static_cast<std::size_t>(b)],
                                face[static_cast<std::size_t>(c)]});
    object.material_of.push_back(material);
    if (++triangles_ > limits_.triangles) {
      Fail(fmt::format("has more than {} triangles", limits_.triangles));
    }
  }
}

void ShapeBuilder::Fail(const std::string& text) const {
  throw Error(fmt::format("{}: {}", name_, OneLine(text)));
}

Affine FromQuaternion(double w, Vec3 v) {
  const double length = std::sqrt(w * w + Dot(v, v));
  if (!(length > 0.0)) return {};
  w /= length;
  v = (1.0 / length) * v;
  return {{1 - 2 * (v.y * v.y + v.z * v.z), 2 * (v.x * v.y + w * v.z), 2 * (v.x * v.z - w * v.y)},
          {2 * (v.x * v.y - w * v.z), 1 - 2 * (v.x * v.x + v.z * v.z), 2 * (v.y * v.z + w * v.x)},
          {2 * (v.x * v.z + w * v.y), 2 * (v.y * v.z - w * v.x), 1 - 2 * (v.x * v.x + v.y * v.y)},
          {}};
}

std::uint8_t FromShare(double share) {
  if (!(share > 0.0)) return 0;  // NaN, too
  return static_cast<std::uint8_t>(std::lround(255.0 * std::min(share, 1.0)));
}

std::uint8_t FromLinear(double share) {
  if (!(share > 0.0)) return 0;
  share = std::min(share, 1.0);
  return FromShare(share <= 0.0031308 ? 12.92 * share : 1.055 * std::pow(share, 1.0 / 2.4) - 0.055);
}

}  // namespace ccmorse::assets
