#include "sim/rays/planar_scan.h"

#include <algorithm>
#include <cmath>

#include "base/trig.h"

namespace ccmorse::sim {
namespace {

// inverse[i] = max(inverse[i], a * cosines[i] + b * sines[i]): the whole inner loop. The two builds
// of it do the same IEEE operations, so they give the same bits.
#define CCMORSE_RAISE_LOOP                                        \
  for (int i = 0; i < count; ++i) {                               \
    const double candidate = a * cosines[i] + b * sines[i];       \
    inverse[i] = candidate > inverse[i] ? candidate : inverse[i]; \
  }

using RaiseFunction = void (*)(double*, const double*, const double*, double, double, int);

void RaisePortable(double* __restrict inverse, const double* __restrict cosines,
                   const double* __restrict sines, double a, double b, int count) {
  CCMORSE_RAISE_LOOP
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void RaiseAvx2(double* __restrict inverse,
                                               const double* __restrict cosines,
                                               const double* __restrict sines, double a, double b,
                                               int count) {
  CCMORSE_RAISE_LOOP
}
const RaiseFunction kRaise = __builtin_cpu_supports("avx2") ? RaiseAvx2 : RaisePortable;
#else
const RaiseFunction kRaise = RaisePortable;
#endif
#undef CCMORSE_RAISE_LOOP

// atan2 within 3e-4 rad. It only says where to look; which beams an edge covers is then decided by
// cross products.
double RoughAngle(Vec2 v) {
  const double ax = std::fabs(v.x);
  const double ay = std::fabs(v.y);
  const double larger = std::max(ax, ay);
  if (larger == 0.0) return 0.0;
  const double t = std::min(ax, ay) / larger;
  const double z = t * t;
  double angle =
      t * (0.99986600 + z * (-0.33029950 + z * (0.18014100 + z * (-0.08513300 + z * 0.02083510))));
  if (ay > ax) angle = kPi / 2.0 - angle;
  if (v.x < 0.0) angle = kPi - angle;
  return v.y < 0.0 ? -angle : angle;
}

}  // namespace

void PlanarWorld::Clear() {
  corners_.clear();
  outlines_.clear();
}

void PlanarWorld::Add(std::span<const Vec2> outline, int owner) {
  Outline added{static_cast<std::uint32_t>(corners_.size()),
                static_cast<std::uint32_t>(outline.size()),
                {},
                0.0,
                owner};
  for (const Vec2 corner : outline) {
    corners_.push_back(corner);
    added.centre = added.centre + (1.0 / static_cast<double>(outline.size())) * corner;
  }
  for (const Vec2 corner : outline) {
    const Vec2 d = corner - added.centre;
    added.radius = std::max(added.radius, std::sqrt(Dot(d, d)));
  }
  outlines_.push_back(added);
}

PlanarScanner::PlanarScanner(int count, double first_angle, double step, double range)
    : count_(count), first_angle_(first_angle), step_(step), range_(range) {
  const auto size = static_cast<std::size_t>(count);
  cosines_.resize(size);
  sines_.resize(size);
  inverse_.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    const auto [s, c] = SinCos(first_angle + static_cast<double>(i) * step);
    cosines_[i] = c;
    sines_[i] = s;
  }
}

void PlanarScanner::Scan(const Pose2& pose, const PlanarWorld& fixed, const PlanarWorld& moving,
                         int self, std::span<double> ranges) {
  const double floor = 1.0 / range_;
  std::fill(inverse_.begin(), inverse_.end(), floor);
  ScanWorld(pose, fixed, self);
  ScanWorld(pose, moving, self);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    ranges[i] = inverse_[i] > floor ? 1.0 / inverse_[i] : range_;
  }
}

void PlanarScanner::ScanWorld(const Pose2& pose, const PlanarWorld& world, int self) {
  const auto [s, c] = SinCos(pose.yaw);
  for (const PlanarWorld::Outline& outline : world.outlines()) {
    if (outline.owner >= 0 && outline.owner == self) continue;
    const Vec2 to_centre = outline.centre - Vec2{pose.x, pose.y};
    const double reach = range_ + outline.radius;
    if (Dot(to_centre, to_centre) > reach * reach) continue;

    const std::span<const Vec2> corners = world.Corners(outline);
    local_.resize(corners.size());
    angles_.resize(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 d{corners[i].x - pose.x, corners[i].y - pose.y};
      local_[i] = {c * d.x + s * d.y, c * d.y - s * d.x};
      double angle = RoughAngle(local_[i]) - first_angle_;
      if (angle < 0.0) angle += 2.0 * kPi;
      if (angle >= 2.0 * kPi) angle -= 2.0 * kPi;
      angles_[i] = angle;
    }
    // Outlines run counter-clockwise, so from outside an edge's end lies to the right of its start.
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t next = i + 1 == corners.size() ? 0 : i + 1;
      RasteriseEdge(local_[next], local_[i], angles_[next], angles_[i]);
    }
  }
}

void PlanarScanner::RasteriseEdge(Vec2 right, Vec2 left, double right_angle, double left_angle) {
  // Twice the area of sensor, right, left: positive when the front faces the sensor. Below the
  // limit the edge is seen end on and covers no beam that its neighbours do not.
  const double area = Cross(right, left);
  if (area <= 1e-12) return;
  // A point at distance r along the unit vector d lies on the edge's line when
  // cross(r d, left - right) = area, so 1/r = d.x * a + d.y * b:
  const double a = (left.y - right.y) / area;
  const double b = (right.x - left.x) / area;
  const int low = static_cast<int>(std::ceil(right_angle / step_));
  const int high = static_cast<int>(std::floor(left_angle / step_));
  if (left_angle >= right_angle || high - low > count_) {
    Cover(low, high, right, left, a, b);
  } else if (right_angle - left_angle > kPi) {  // the edge crosses the direction of the first beam
    Cover(low, count_ - 1, right, left, a, b);
    Cover(0, high, right, left, a, b);
  } else {
    // Both ends fall, within the rough angle's error, on one direction: at most one beam is meant.
    Cover(high, low, right, left, a, b);
  }
}

void PlanarScanner::Cover(int low, int high, Vec2 right, Vec2 left, double a, double b) {
  low = std::max(low, 0);
  high = std::min(high, count_ - 1);
  // Put right what the rough angles missed at the two ends.
  while (low > 0 && low <= count_ && Cross(right, Direction(low - 1)) >= 0.0 &&
         Dot(right, Direction(low - 1)) > 0.0) {
    --low;
  }
  while (high < count_ - 1 && high >= -1 && Cross(Direction(high + 1), left) >= 0.0 &&
         Dot(left, Direction(high + 1)) > 0.0) {
    ++high;
  }
  while (low <= high && Cross(right, Direction(low)) < 0.0) ++low;
  while (low <= high && Cross(Direction(high), left) < 0.0) --high;
  if (low > high) return;
  const auto at = static_cast<std::size_t>(low);
  kRaise(&inverse_[at], &cosines_[at], &sines_[at], a, b, high - low + 1);
}

}  // namespace ccmorse::sim
