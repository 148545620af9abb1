#include "render/picture_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/polygon.h"
#include "base/trig.h"
#include "render/vector_math.h"

namespace ccmorse::render {
namespace {

constexpr int kCylinderSides = 48;
constexpr int kBevelSteps = 3;

Vec3 At(const Pose2& pose, Vec2 p, double z) {
  const Vec2 at = Transform(pose, p);
  return {at.x, at.y, z};
}

// The outline with every side moved inwards by `by`, m.
std::vector<Vec2> Inset(std::span<const Vec2> outline, double by) {
  std::vector<Vec2> inner;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = outline[i] - outline[(i + n - 1) % n];
    const Vec2 after = outline[(i + 1) % n] - outline[i];
    const double before_length = std::sqrt(Dot(before, before));
    const double after_length = std::sqrt(Dot(after, after));
    const Vec2 a = (1.0 / before_length) * Vec2{-before.y, before.x};  // inwards
    const Vec2 b = (1.0 / after_length) * Vec2{-after.y, after.x};
    inner.push_back(outline[i] + (by / (1.0 + Dot(a, b))) * (a + b));
  }
  return inner;
}

// How far the outline's shortest side would let it be inset, with some to spare.
double ShortestSide(std::span<const Vec2> outline) {
  double shortest = 1e9;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 side = outline[(i + 1) % outline.size()] - outline[i];
    shortest = std::min(shortest, std::sqrt(Dot(side, side)));
  }
  return shortest;
}

}  // namespace

Vec3 Linear(const Color& color) {
  // The transfer function of sRGB (IEC 61966-2-1).
  const auto linear = [](std::uint8_t value) {
    const double v = value / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return {linear(color.r), linear(color.g), linear(color.b)};
}

int PictureScene::AddMaterial(const Material& material) {
  materials_.push_back(material);
  return static_cast<int>(materials_.size()) - 1;
}

void PictureScene::AddTriangle(const std::array<Vec3, 3>& corners,
                               const std::array<Vec3, 3>& normals, int material) {
  const auto index = static_cast<int>(set_.size());
  set_.Add(corners[0], corners[1], corners[2], {sim::HitKind::kMesh, 0, index});
  normals_.push_back(normals);
  material_of_.push_back(material);
}

void PictureScene::AddTriangle(const std::array<Vec3, 3>& corners, int material) {
  const Vec3 normal = Cross(corners[1] - corners[0], corners[2] - corners[0]);
  if (!(Dot(normal, normal) > 0.0)) return;
  const Vec3 unit = Unit(normal);
  AddTriangle(corners, {unit, unit, unit}, material);
}

void PictureScene::AddPrism(const Pose2& pose, std::span<const Vec2> outline, double bottom,
                            double top, double bevel, int material) {
  const std::size_t n = outline.size();
  bevel = std::max(0.0, std::min({bevel, (top - bottom) / 4.0, ShortestSide(outline) / 4.0}));
  // Rings from the bottom up: the sides, then a quarter of a circle, each with its normal's tilt.
  struct Ring {
    std::vector<Vec2> outline;
    double z;
  };
  std::vector<Ring> rings = {{{outline.begin(), outline.end()}, bottom}};
  for (int k = 0; k <= kBevelSteps && bevel > 0.0; ++k) {
    const auto [s, c] = SinCos(kPi / 2.0 * k / kBevelSteps);
    rings.push_back({Inset(outline, bevel * (1.0 - c)), top - bevel * (1.0 - s)});
  }
  if (bevel <= 0.0) rings.push_back({{outline.begin(), outline.end()}, top});
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    const auto& [low, z_low] = rings[r];
    const auto& [high, z_high] = rings[r + 1];
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const Vec3 a = At(pose, low[i], z_low);
      const Vec3 b = At(pose, low[j], z_low);
      const Vec3 c = At(pose, high[j], z_high);
      const Vec3 d = At(pose, high[i], z_high);
      AddTriangle({a, b, c}, material);
      AddTriangle({a, c, d}, material);
    }
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const std::vector<Vec2>& lid = rings.back().outline;
    AddTriangle({At(pose, lid[0], top), At(pose, lid[i], top), At(pose, lid[i + 1], top)},
                material);
    AddTriangle({At(pose, outline[0], bottom), At(pose, outline[i + 1], bottom),
                 At(pose, outline[i], bottom)},
                material);
  }
}

void PictureScene::AddCylinder(const Vec3& from, const Vec3& to, double radius, int material) {
  const Vec3 axis = Unit(to - from);
  const Vec3 u = Unit(Cross(axis, std::fabs(axis.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
  const Vec3 v = Cross(axis, u);
  const auto out = [&](int i) {
    const auto [s, c] = SinCos(2.0 * kPi * i / kCylinderSides);
    return c * u + s * v;
  };
  for (int i = 0; i < kCylinderSides; ++i) {
    const Vec3 here = out(i);
    const Vec3 next = out(i + 1);
    const Vec3 a = from + radius * here;
    const Vec3 b = from + radius * next;
    const Vec3 c = to + radius * next;
    const Vec3 d = to + radius * here;
    AddTriangle({a, b, c}, {here, next, next}, material);
    AddTriangle({a, c, d}, {here, next, here}, material);
    AddTriangle({from, b, a}, material);
    AddTriangle({to, d, c}, material);
  }
}

void PictureScene::Build(double farthest) {
  set_.closed = false;
  triangles_.Build({set_}, {}, {}, farthest);
  triangles_.Commit();
}

Vec3 PictureScene::Normal(const sim::RayHit& hit, const Vec3& point) const {
  const auto index = static_cast<std::size_t>(hit.surface.surface);
  const Vec3& a = set_.corners[3 * index];
  const Vec3& b = set_.corners[3 * index + 1];
  const Vec3& c = set_.corners[3 * index + 2];
  const Vec3 normal = Cross(b - a, c - a);
  const double area = Dot(normal, normal);
  // Barycentric coordinates.
  const double u = Dot(Cross(c - b, point - b), normal) / area;
  const double v = Dot(Cross(a - c, point - c), normal) / area;
  const std::array<Vec3, 3>& normals = normals_[index];
  return Unit(u * normals[0] + v * normals[1] + (1.0 - u - v) * normals[2]);
}

Vec3 PictureScene::FlatNormal(const sim::RayHit& hit) const {
  const std::size_t first = 3 * static_cast<std::size_t>(hit.surface.surface);
  return Unit(Cross(set_.corners[first + 1] - set_.corners[first],
                    set_.corners[first + 2] - set_.corners[first]));
}

int PictureScene::MaterialOf(const sim::RayHit& hit) const {
  return material_of_[static_cast<std::size_t>(hit.surface.surface)];
}

}  // namespace ccmorse::render
