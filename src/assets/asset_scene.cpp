#include "assets/asset_scene.h"

#include <algorithm>

namespace ccmorse::assets {

void Extent::Add(const Vec3& point) {
  low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
  high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
}

std::string OneLine(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return text;
}

Extent ExtentOf(const AssetObject& object) {
  Extent extent;
  for (const Vec3& vertex : object.vertices) extent.Add(vertex);
  return extent;
}

Extent ExtentOf(const AssetScene& scene) {
  Extent extent;
  for (const AssetObject& object : scene.objects) {
    if (!object.shown) continue;
    for (const Vec3& vertex : object.vertices) extent.Add(vertex);
  }
  return extent;
}

}  // namespace ccmorse::assets
