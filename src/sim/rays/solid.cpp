#include "sim/rays/solid.h"

namespace ccmorse::sim {

void TriangleSet::Add(const Vec3& a, const Vec3& b, const Vec3& c, const Surface& surface) {
  corners.insert(corners.end(), {a, b, c});
  surfaces.push_back(surface);
}

void TriangleSet::AddPrism(std::span<const Vec2> outline, double bottom, double top,
                           const Surface& first) {
  const std::size_t count = outline.size();
  const auto low = [&](std::size_t i) { return Vec3{outline[i].x, outline[i].y, bottom}; };
  const auto high = [&](std::size_t i) { return Vec3{outline[i].x, outline[i].y, top}; };
  const auto surface = [&](std::size_t i) {
    return Surface{first.kind, first.object, first.surface + static_cast<int>(i)};
  };
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    Add(low(i), low(next), high(next), surface(i));
    Add(low(i), high(next), high(i), surface(i));
  }
  for (std::size_t i = 1; i + 1 < count; ++i) {
    Add(high(0), high(i), high(i + 1), surface(count));
    Add(low(0), low(i + 1), low(i), surface(count + 1));
  }
}

}  // namespace ccmorse::sim
