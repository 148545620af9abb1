#include "assets/triangulate.h"

#include <cmath>
#include <cstddef>

namespace ccmorse::assets {
namespace {

constexpr std::size_t kMostCorners = 1024;  // clipping costs their square

// Twice the polygon's area as a vector, by M. Newell's rule: good for what is not quite flat, too.
Vec3 Newell(std::span<const Vec3> corners) {
  Vec3 sum;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = corners[i] - corners[0];
    const Vec3 b = corners[(i + 1) % corners.size()] - corners[0];
    sum = sum + Cross(a, b);
  }
  return sum;
}

// The polygon seen from where its normal points.
std::vector<Vec2> Flattened(std::span<const Vec3> corners, const Vec3& normal) {
  const double x = std::fabs(normal.x);
  const double y = std::fabs(normal.y);
  const double z = std::fabs(normal.z);
  std::vector<Vec2> flat;
  flat.reserve(corners.size());
  for (const Vec3& c : corners) {
    Vec2 p;
    double side = 0.0;
    if (z >= x && z >= y) {
      p = {c.x, c.y};
      side = normal.z;
    } else if (y >= x) {
      p = {c.z, c.x};
      side = normal.y;
    } else {
      p = {c.y, c.z};
      side = normal.x;
    }
    flat.push_back(side < 0.0 ? Vec2{p.y, p.x} : p);
  }
  return flat;
}

bool IsEar(const std::vector<Vec2>& p, const std::vector<int>& left, std::size_t i) {
  const auto at = [&](std::size_t k) { return p[static_cast<std::size_t>(left[k % left.size()])]; };
  const Vec2 a = at(i + left.size() - 1);
  const Vec2 b = at(i);
  const Vec2 c = at(i + 1);
  if (!(Cross(b - a, c - b) > 0.0)) return false;
  for (std::size_t k = 2; k + 1 < left.size(); ++k) {
    const Vec2 q = at(i + k);
    if (Cross(b - a, q - a) >= 0.0 && Cross(c - b, q - b) >= 0.0 && Cross(a - c, q - c) >= 0.0) {
      // A corner in the place of one of these three, as where a slit leads to a hole, is no harm.
      const auto same = [q](Vec2 o) { return q.x == o.x && q.y == o.y; };
      if (!same(a) && !same(b) && !same(c)) return false;
    }
  }
  return true;
}

bool IsConvex(const std::vector<Vec2>& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 b = p[(i + 1) % p.size()];
    if (Cross(b - p[i], p[(i + 2) % p.size()] - b) < 0.0) return false;
  }
  return true;
}

}  // namespace

bool HasArea(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = Cross(b - a, c - a);
  const double area = Dot(normal, normal);
  return area > 0.0 && std::isfinite(area);
}

std::vector<std::array<int, 3>> Triangulate(std::span<const Vec3> corners) {
  std::vector<std::array<int, 3>> triangles;
  if (corners.size() < 3) return triangles;
  const auto add = [&](int a, int b, int c) {
    if (HasArea(corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)],
                corners[static_cast<std::size_t>(c)])) {
      triangles.push_back({a, b, c});
    }
  };
  std::vector<int> left;
  for (int i = 0; i < static_cast<int>(corners.size()); ++i) left.push_back(i);
  if (corners.size() > 3 && corners.size() <= kMostCorners) {
    const std::vector<Vec2> flat = Flattened(corners, Newell(corners));
    if (!IsConvex(flat)) {
      std::size_t i = 0;
      std::size_t tried = 0;
      while (left.size() > 3 && tried < left.size()) {
        if (!IsEar(flat, left, i)) {
          i = (i + 1) % left.size();
          ++tried;
          continue;
        }
        add(left[(i + left.size() - 1) % left.size()], left[i], left[(i + 1) % left.size()]);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        i %= left.size();
        tried = 0;
      }
    }
  }
  for (std::size_t i = 1; i + 1 < left.size(); ++i) add(left[0], left[i], left[i + 1]);
  return triangles;
}

}  // namespace ccmorse::assets
