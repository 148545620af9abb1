#include "base/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/trig.h"

namespace ccmorse {
namespace {

// Largest over a's edges of the smallest distance of b's corners beyond that edge.
double GapAlongNormals(std::span<const Vec2> a, std::span<const Vec2> b) {
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 from = a[i];
    const Vec2 edge = a[(i + 1) % a.size()] - from;
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2 corner : b) least = std::min(least, Cross(corner - from, edge));
    best = std::max(best, least / std::sqrt(Dot(edge, edge)));
  }
  return best;
}

// Does one of a's edges have all of b on its outer side? Decided as GapAlongNormals() would.
bool EdgeSeparates(std::span<const Vec2> a, std::span<const Vec2> b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 from = a[i];
    const Vec2 edge = a[i + 1 == a.size() ? 0 : i + 1] - from;
    bool outside = true;
    for (std::size_t k = 0; outside && k < b.size(); ++k) {
      outside = Cross(b[k] - from, edge) >= 0.0;
    }
    if (outside) return true;
  }
  return false;
}

}  // namespace

Vec2 Transform(const Pose2& frame, Vec2 point) {
  const auto [s, c] = SinCos(frame.yaw);
  return {frame.x + c * point.x - s * point.y, frame.y + s * point.x + c * point.y};
}

Vec2 InverseTransform(const Pose2& frame, Vec2 point) {
  const auto [s, c] = SinCos(frame.yaw);
  const Vec2 d{point.x - frame.x, point.y - frame.y};
  return {c * d.x + s * d.y, c * d.y - s * d.x};
}

void Place(std::span<const Vec2> points, const Pose2& frame, std::span<Vec2> placed) {
  const auto [s, c] = SinCos(frame.yaw);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 p = points[i];
    placed[i] = {frame.x + c * p.x - s * p.y, frame.y + s * p.x + c * p.y};
  }
}

std::array<Vec2, 4> BoxCorners(const Pose2& centre, double size_x, double size_y) {
  const double hx = size_x / 2.0;
  const double hy = size_y / 2.0;
  return {Transform(centre, {hx, hy}), Transform(centre, {-hx, hy}), Transform(centre, {-hx, -hy}),
          Transform(centre, {hx, -hy})};
}

double ConvexGap(std::span<const Vec2> a, std::span<const Vec2> b) {
  return std::max(GapAlongNormals(a, b), GapAlongNormals(b, a));
}

bool ConvexOverlap(std::span<const Vec2> a, std::span<const Vec2> b) {
  return !EdgeSeparates(a, b) && !EdgeSeparates(b, a);
}

double DistanceBeyondEdges(std::span<const Vec2> polygon, Vec2 point) {
  return GapAlongNormals(polygon, {&point, 1});
}

bool Contains(std::span<const Vec2> polygon, Vec2 point) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    if (Cross(edge, point - polygon[i]) < 0.0) return false;
  }
  return true;
}

}  // namespace ccmorse
