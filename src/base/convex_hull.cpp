#include "base/convex_hull.h"

#include <algorithm>

namespace ccmorse {

std::vector<Vec2> ConvexHull(std::vector<Vec2> points) {
  const auto before = [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::sort(points.begin(), points.end(), before);
  const auto same = [](Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const Vec2 point : points) {
      while (hull.size() >= start + 2 &&
             Cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();  // the next pass begins with it
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace ccmorse
