#include "scene/player/outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/convex_hull.h"
#include "base/trig.h"

namespace ccmorse::scene {
namespace {

double Area(const std::vector<Vec2>& polygon) {
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    // From the first corner, so that a polygon far from the origin loses nothing.
    area += Cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  }
  return 0.5 * area;
}

double Turn(Vec2 a, Vec2 b, Vec2 c) { return Cross(b - a, c - b); }

bool InTriangle(Vec2 point, Vec2 a, Vec2 b, Vec2 c) {
  return Cross(b - a, point - a) >= 0.0 && Cross(c - b, point - b) >= 0.0 &&
         Cross(a - c, point - c) >= 0.0;
}

// Drops corners until every one that is left turns left.
std::vector<Vec2> StrictlyConvex(std::vector<Vec2> polygon) {
  for (std::size_t i = 0, kept = 0; polygon.size() >= 3 && kept < polygon.size();) {
    const std::size_t n = polygon.size();
    const std::size_t middle = (i + 1) % n;
    if (Turn(polygon[i % n], polygon[middle], polygon[(i + 2) % n]) > 0.0) {
      i = (i + 1) % n;
      ++kept;
      continue;
    }
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(middle));
    i = 0;
    kept = 0;
  }
  if (polygon.size() < 3) polygon.clear();
  return polygon;
}

// The two polygons as one where they share a side and stay convex; empty otherwise.
std::vector<Vec2> Joined(const std::vector<int>& a, const std::vector<int>& b,
                         const std::vector<Vec2>& corners, std::vector<int>& indexes) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int from = a[i];
    const int to = a[(i + 1) % a.size()];
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (b[k] != to || b[(k + 1) % b.size()] != from) continue;
      indexes.clear();
      for (std::size_t n = 1; n <= a.size(); ++n) indexes.push_back(a[(i + n) % a.size()]);
      for (std::size_t n = 2; n < b.size(); ++n) indexes.push_back(b[(k + n) % b.size()]);
      std::vector<Vec2> joined;
      for (const int index : indexes) joined.push_back(corners[static_cast<std::size_t>(index)]);
      for (std::size_t n = 0; n < joined.size(); ++n) {
        if (Turn(joined[n], joined[(n + 1) % joined.size()], joined[(n + 2) % joined.size()]) <
            0.0) {
          return {};
        }
      }
      return joined;
    }
  }
  return {};
}

}  // namespace

bool IsStrictlyConvex(const std::vector<Vec2>& polygon) {
  if (polygon.size() < 3) return false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (!(Turn(polygon[i], polygon[(i + 1) % polygon.size()], polygon[(i + 2) % polygon.size()]) >
          0.0)) {
      return false;
    }
  }
  return true;
}

std::vector<Vec2> CleanPolygon(std::vector<Vec2> polygon) {
  for (bool changed = true; changed && polygon.size() >= 3;) {
    changed = false;
    for (std::size_t i = 0; i < polygon.size() && polygon.size() >= 3; ++i) {
      const Vec2 before = polygon[(i + polygon.size() - 1) % polygon.size()];
      const Vec2 here = polygon[i];
      const Vec2 after = polygon[(i + 1) % polygon.size()];
      const Vec2 in = here - before;
      const Vec2 out = after - here;
      const double scale = Dot(in, in) + Dot(out, out);
      if (std::fabs(Cross(in, out)) > 1e-12 * scale) continue;
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
      changed = true;
      --i;
    }
  }
  if (polygon.size() < 3) return {};
  const double area = Area(polygon);
  if (area < 0.0) std::reverse(polygon.begin(), polygon.end());
  if (!(std::fabs(area) > 0.0)) return {};
  return polygon;
}

std::vector<std::array<int, 3>> Triangulate(const std::vector<Vec2>& polygon) {
  // Ears are cut off one after the other (Meisters, 1975).
  std::vector<int> left(polygon.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = static_cast<int>(i);
  const auto at = [&polygon](int index) { return polygon[static_cast<std::size_t>(index)]; };
  std::vector<std::array<int, 3>> triangles;
  while (left.size() > 3) {
    bool cut = false;
    for (std::size_t i = 0; i < left.size() && !cut; ++i) {
      const int a = left[(i + left.size() - 1) % left.size()];
      const int b = left[i];
      const int c = left[(i + 1) % left.size()];
      if (!(Turn(at(a), at(b), at(c)) > 0.0)) continue;
      const bool ear = std::none_of(left.begin(), left.end(), [&](int other) {
        return other != a && other != b && other != c && InTriangle(at(other), at(a), at(b), at(c));
      });
      if (!ear) continue;
      triangles.push_back({a, b, c});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      cut = true;
    }
    if (!cut) return {};
  }
  if (!(Turn(at(left[0]), at(left[1]), at(left[2])) > 0.0)) return {};
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

std::vector<std::vector<Vec2>> ConvexPieces(const std::vector<Vec2>& polygon) {
  if (IsStrictlyConvex(polygon)) return {polygon};
  const std::vector<std::array<int, 3>> triangles = Triangulate(polygon);
  if (triangles.empty()) {
    std::vector<Vec2> hull = StrictlyConvex(ConvexHull(polygon));
    if (hull.empty()) return {};
    return {std::move(hull)};
  }
  std::vector<std::vector<int>> pieces;
  for (const auto& [a, b, c] : triangles) pieces.push_back({a, b, c});
  for (bool joined = true; joined;) {
    joined = false;
    for (std::size_t i = 0; i < pieces.size() && !joined; ++i) {
      for (std::size_t k = i + 1; k < pieces.size() && !joined; ++k) {
        std::vector<int> indexes;
        if (Joined(pieces[i], pieces[k], polygon, indexes).empty()) continue;
        pieces[i] = std::move(indexes);
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(k));
        joined = true;
      }
    }
  }
  std::vector<std::vector<Vec2>> outlines;
  for (const std::vector<int>& piece : pieces) {
    std::vector<Vec2> outline;
    for (const int index : piece) outline.push_back(polygon[static_cast<std::size_t>(index)]);
    outline = StrictlyConvex(std::move(outline));
    if (!outline.empty()) outlines.push_back(std::move(outline));
  }
  return outlines;
}

std::vector<Vec2> HullOf(const std::vector<Vec2>& points, std::size_t corners) {
  const std::vector<Vec2> hull = StrictlyConvex(ConvexHull(points));
  if (hull.size() <= corners) return hull;
  // Lines in `corners` directions that touch the hull, and where neighbours of them cross.
  std::vector<Vec2> around;
  const double step = 2.0 * kPi / static_cast<double>(corners);
  const auto reach = [&hull](Vec2 direction) {
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Vec2 corner : hull) farthest = std::max(farthest, Dot(corner, direction));
    return farthest;
  };
  const double determinant = SinCos(step).sin;
  for (std::size_t i = 0; i < corners; ++i) {
    const auto [s1, c1] = SinCos(step * static_cast<double>(i));
    const auto [s2, c2] = SinCos(step * static_cast<double>(i + 1));
    const double d1 = reach({c1, s1});
    const double d2 = reach({c2, s2});
    around.push_back({(d1 * s2 - d2 * s1) / determinant, (d2 * c1 - d1 * c2) / determinant});
  }
  return StrictlyConvex(ConvexHull(around));
}

}  // namespace ccmorse::scene
