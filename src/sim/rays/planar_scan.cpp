#include "sim/rays/planar_scan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <tuple>

#include "base/trig.h"

namespace ccmorse::sim {
namespace {

constexpr std::size_t kCheckEvery = 8;  // outlines, between looks at the farthest hit
constexpr int kBlock = 32;              // beams that share an entry of work_->least
constexpr double kRemembered = 0.5;     // m that a sensor may move before FindNear() looks again
constexpr double kRoughError = 3e-4;    // rad, of RoughAngle()

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
  circles_.clear();
  ++revision_;
}

void PlanarWorld::Add(std::span<const Vec2> outline, int owner) {
  Circle around;
  for (const Vec2 corner : outline) {
    corners_.push_back(corner);
    around.centre = around.centre + (1.0 / static_cast<double>(outline.size())) * corner;
  }
  for (const Vec2 corner : outline) {
    const Vec2 d = corner - around.centre;
    around.radius = std::max(around.radius, std::sqrt(Dot(d, d)));
  }
  outlines_.push_back({static_cast<std::uint32_t>(corners_.size() - outline.size()),
                       static_cast<std::uint32_t>(outline.size()), around, owner});
  circles_.push_back(around);
  ++revision_;
}

void PlanarWorld::Finish() { grid_.Build(circles_); }

void PlanarWorld::Near(Vec2 point, double reach, std::vector<std::uint32_t>& found) const {
  grid_.ForNear(point, reach, [&found](std::uint32_t index) { found.push_back(index); });
}

struct PlanarScanner::Fan {
  Fan(int count, double first_angle, double step) {
    for (int i = 0; i < count; ++i) {
      const auto [s, c] = SinCos(first_angle + static_cast<double>(i) * step);
      cosines.push_back(c);
      sines.push_back(s);
    }
  }
  std::vector<double> cosines;  // of the beams' angles in the sensor's frame, (count)
  std::vector<double> sines;
};

struct PlanarScanner::Work {
  std::vector<double> inverse;  // 1/m, nearest so far, (count)
  std::vector<double> least;    // 1/m, the least of each block of inverse, or 0: not known
  std::vector<std::uint32_t> near_moving;
  std::vector<Vec2> local;     // corners of one outline in the sensor's frame
  std::vector<double> angles;  // their rough angles from the first beam, rad, 0..2 pi
};

PlanarScanner::PlanarScanner(int count, double first_angle, double step, double range)
    : count_(count), first_angle_(first_angle), step_(step), range_(range) {
  // Thousands of scanners alike would otherwise fill the processor's caches with the same numbers.
  using Key = std::tuple<int, double, double>;
  static std::mutex mutex;
  static std::map<Key, std::weak_ptr<const Fan>> fans;
  const std::lock_guard lock(mutex);
  std::weak_ptr<const Fan>& known = fans[{count, first_angle, step}];
  fan_ = known.lock();
  if (!fan_) known = fan_ = std::make_shared<const Fan>(count, first_angle, step);
}

Vec2 PlanarScanner::Direction(int i) const {
  const auto index = static_cast<std::size_t>(i);
  return {fan_->cosines[index], fan_->sines[index]};
}

void PlanarScanner::Scan(const Pose2& pose, const PlanarWorld& fixed, const PlanarWorld& moving,
                         int self, std::span<double> ranges) {
  thread_local Work work;
  work_ = &work;
  work.inverse.resize(static_cast<std::size_t>(count_));
  work.least.resize((work.inverse.size() + kBlock - 1) / kBlock);
  const Vec2 at{pose.x, pose.y};
  FindNear(at, fixed);
  const double floor = 1.0 / range_;
  std::fill(work_->inverse.begin(), work_->inverse.end(), floor);
  std::fill(work_->least.begin(), work_->least.end(), floor);
  const auto [s, c] = SinCos(pose.yaw);
  const Vec2 moved = at - near_at_;
  const double since = std::sqrt(Dot(moved, moved));
  for (std::size_t i = 0; i < near_.size(); ++i) {
    // They come nearest first: once one lies behind all that is hit, so do the rest.
    if (i % kCheckEvery == kCheckEvery - 1 && Farthest() < near_gaps_[i] - since - 1e-6) {
      break;
    }
    ScanOutline(fixed, fixed.outlines()[near_[i]], pose, s, c);
  }
  work_->near_moving.clear();
  moving.Near(at, range_, work_->near_moving);
  for (const std::uint32_t index : work_->near_moving) {
    const PlanarWorld::Outline& outline = moving.outlines()[index];
    if (outline.owner < 0 || outline.owner != self) ScanOutline(moving, outline, pose, s, c);
  }
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    ranges[i] = work_->inverse[i] > floor ? 1.0 / work_->inverse[i] : range_;
  }
}

void PlanarScanner::FindNear(Vec2 at, const PlanarWorld& world) {
  const Vec2 moved = at - near_at_;
  if (near_world_ == &world && near_revision_ == world.revision() &&
      Dot(moved, moved) < kRemembered * kRemembered) {
    return;
  }
  near_world_ = &world;
  near_revision_ = world.revision();
  near_at_ = at;
  near_.clear();
  world.Near(at, range_ + kRemembered, near_);
  const auto gap = [&world, at](std::uint32_t index) {
    const Circle& around = world.outlines()[index].around;
    const Vec2 d = around.centre - at;
    return std::sqrt(Dot(d, d)) - around.radius;
  };
  std::sort(near_.begin(), near_.end(), [&gap](std::uint32_t a, std::uint32_t b) {
    const double gap_a = gap(a);
    const double gap_b = gap(b);
    return gap_a < gap_b || (gap_a == gap_b && a < b);
  });
  near_gaps_.resize(near_.size());
  std::transform(near_.begin(), near_.end(), near_gaps_.begin(), gap);
}

double PlanarScanner::Least(int block) {
  double& least = work_->least[static_cast<std::size_t>(block)];
  if (least == 0.0) {
    const double* const first =
        &work_->inverse[static_cast<std::size_t>(block) * std::size_t{kBlock}];
    least = *std::min_element(first, first + std::min(kBlock, count_ - block * kBlock));
  }
  return least;
}

double PlanarScanner::Farthest() {
  double least = Least(0);
  for (int block = 1; block < static_cast<int>(work_->least.size()); ++block) {
    least = std::min(least, Least(block));
  }
  return 1.0 / least;
}

// Is everything in the circle (in the sensor's frame) behind what the beams towards it hit already?
bool PlanarScanner::IsHidden(Vec2 centre, double radius) {
  const double distance = std::sqrt(Dot(centre, centre));
  const double gap = distance - radius;
  if (!(gap > 0.01)) return false;
  // asin(q) <= q (pi/2 - 1) q^2 + q for q in [0, 1]; the last terms cover the rough angle's error.
  const double q = radius / distance;
  const double half = q + (kPi / 2.0 - 1.0) * q * q * q + 2.0 * kRoughError;
  double middle = RoughAngle(centre) - first_angle_;
  if (middle < 0.0) middle += 2.0 * kPi;
  const double nearest =
      1.0 / (gap - 1e-6);  // a little nearer than it is, so rounding is no matter
  const auto covered = [this, nearest](double from, double to) {
    // Held within the fan before they become integers: steps may be as fine as they like.
    const int low =
        static_cast<int>(std::min<double>(count_, std::max(std::floor(from / step_), 0.0)));
    const int high =
        static_cast<int>(std::min(std::max(std::ceil(to / step_), -1.0), count_ - 1.0));
    for (int block = low / kBlock; block * kBlock <= high; ++block) {
      if (Least(block) < nearest) return false;
    }
    return true;
  };
  return covered(middle - half, middle + half) &&
         (middle + half < 2.0 * kPi || covered(0.0, middle + half - 2.0 * kPi)) &&
         (middle - half > 0.0 || covered(middle - half + 2.0 * kPi, 2.0 * kPi));
}

void PlanarScanner::ScanOutline(const PlanarWorld& world, const PlanarWorld::Outline& outline,
                                const Pose2& pose, double sine, double cosine) {
  const auto to_local = [&pose, sine, cosine](Vec2 point) {
    const Vec2 d{point.x - pose.x, point.y - pose.y};
    return Vec2{cosine * d.x + sine * d.y, cosine * d.y - sine * d.x};
  };
  if (IsHidden(to_local(outline.around.centre), outline.around.radius)) return;
  const std::span<const Vec2> corners = world.Corners(outline);
  work_->local.resize(corners.size());
  work_->angles.resize(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    work_->local[i] = to_local(corners[i]);
    double angle = RoughAngle(work_->local[i]) - first_angle_;
    if (angle < 0.0) angle += 2.0 * kPi;
    if (angle >= 2.0 * kPi) angle -= 2.0 * kPi;
    work_->angles[i] = angle;
  }
  // Outlines run counter-clockwise, so from outside an edge's end lies to the right of its start.
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = i + 1 == corners.size() ? 0 : i + 1;
    RasteriseEdge(work_->local[next], work_->local[i], work_->angles[next], work_->angles[i]);
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
  // Held behind the last beam: with tiny steps, no int would hold the quotient.
  const double behind = count_ + 1.0;
  const int low = static_cast<int>(std::min(behind, std::ceil(right_angle / step_)));
  const int high = static_cast<int>(std::min(behind, std::floor(left_angle / step_)));
  // The left end may lie a little beyond the first beam, and only seem to lie before it.
  if (left_angle > 2.0 * kPi - 2.0 * kRoughError) Cover(0, 0, right, left, a, b);
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
  low = std::clamp(low, 0, count_);
  high = std::clamp(high, -1, count_ - 1);
  // Put right what the rough angles missed at the two ends.
  while (low > 0 && Cross(right, Direction(low - 1)) >= 0.0 &&
         Dot(right, Direction(low - 1)) > 0.0) {
    --low;
  }
  while (high < count_ - 1 && Cross(Direction(high + 1), left) >= 0.0 &&
         Dot(left, Direction(high + 1)) > 0.0) {
    ++high;
  }
  while (low <= high && Cross(right, Direction(low)) < 0.0) ++low;
  while (low <= high && Cross(Direction(high), left) < 0.0) --high;
  if (low > high) return;
  const auto at = static_cast<std::size_t>(low);
  kRaise(&work_->inverse[at], &fan_->cosines[at], &fan_->sines[at], a, b, high - low + 1);
  for (int block = low / kBlock; block <= high / kBlock; ++block) {
    work_->least[static_cast<std::size_t>(block)] = 0.0;
  }
}

}  // namespace ccmorse::sim
