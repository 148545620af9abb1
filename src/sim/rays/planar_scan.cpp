#include "sim/rays/planar_scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <mutex>
#include <tuple>

#include "base/polygon.h"
#include "base/trig.h"

namespace ccmorse::sim {
namespace {

constexpr std::size_t kChunk = 64;   // corners, about, between looks at the farthest hit
constexpr double kRemembered = 0.5;  // m that a sensor may move before FindNear() looks again
constexpr double kLarge = 0.5;       // m, radius of outlines that FindNear() expects to hide others
constexpr std::size_t kMostScreens = 8;  // of them, the nearest
constexpr double kRoughError = 1e-6;     // rad, of RoughAngle(), with room to spare
constexpr double kTouching = 1e-30;      // m^2, below which there is no inverse
constexpr double kEndOn = 1e-12;         // m^2, see Kernel::Edges()
constexpr std::size_t kPadding = 4;  // numbers that loops may touch behind the end of their arrays

// The loops below work on four numbers at a time and exist twice: for any processor, and with AVX2
// where there is one. Both do the same IEEE operations in the same order for each beam and corner,
// so they give the same bits.
#define CCMORSE_INLINE inline __attribute__((always_inline))
using Four = double __attribute__((vector_size(32)));
constexpr Four kLanes{0.0, 1.0, 2.0, 3.0};

CCMORSE_INLINE Four Load(const double* from) {
  Four four;
  std::memcpy(&four, from, sizeof four);
  return four;
}

CCMORSE_INLINE void Store(Four four, double* to) { std::memcpy(to, &four, sizeof four); }

// atan2 within kRoughError, without branches. It says which beams an edge may cover; where it is in
// doubt about a beam, cross products decide. Polynomial: atan(t)/t in t^2 on [0, 1], interpolated
// at Chebyshev nodes, off by 4.2e-7 at most.
CCMORSE_INLINE Four RoughAngle(Four x, Four y) {
  const Four ax = x < 0.0 ? -x : x;
  const Four ay = y < 0.0 ? -y : y;
  const Four larger = ax > ay ? ax : ay;
  const Four smaller = ax > ay ? ay : ax;
  const Four t = smaller / (larger > 1e-300 ? larger : larger + 1e-300);
  const Four z = t * t;
  Four p = z * 0.007648353926762847 - 0.036360430857318375;
  p = p * z + 0.08312645300619721;
  p = p * z - 0.1344786405809062;
  p = p * z + 0.19872040268214644;
  p = p * z - 0.3332567803972393;
  p = p * z + 0.9999992255890977;
  const Four octant = p * t;
  const Four quadrant = ay > ax ? kPi / 2.0 - octant : octant;
  const Four half = x < 0.0 ? kPi - quadrant : quadrant;
  return y < 0.0 ? -half : half;
}

// inverse[i] = max(inverse[i], a * cosines[i] + b * sines[i]) for i < count. Reads and writes, but
// does not change, up to three numbers beyond.
CCMORSE_INLINE void Raise(double* inverse, const double* cosines, const double* sines, double a,
                          double b, int count) {
  int i = 0;
  for (; i + 4 <= count; i += 4) {
    const Four candidate = a * Load(cosines + i) + b * Load(sines + i);
    const Four before = Load(inverse + i);
    Store(candidate > before ? candidate : before, inverse + i);
  }
  if (i == count) return;
  const Four candidate = a * Load(cosines + i) + b * Load(sines + i);
  const Four before = Load(inverse + i);
  const auto higher = (candidate > before) & (kLanes < static_cast<double>(count - i));
  Store(higher ? candidate : before, inverse + i);
}

// Does the segment from `from` to `to` pass through the convex outline, and where is it within?
bool CrossesAt(Vec2 from, Vec2 to, std::span<const Vec2> outline, Vec2* middle) {
  const Vec2 along = to - from;
  double enter = 0.0;
  double leave = 1.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 corner = outline[i];
    const Vec2 edge = outline[i + 1 == outline.size() ? 0 : i + 1] - corner;
    const double start = Cross(edge, from - corner);  // >= 0: inside of this edge
    const double slope = Cross(edge, along);
    if (slope > 0.0) {
      enter = std::max(enter, -start / slope);
    } else if (slope < 0.0) {
      leave = std::min(leave, -start / slope);
    } else if (start < 0.0) {
      return false;
    }
    if (enter >= leave) return false;
  }
  *middle = from + (0.5 * (enter + leave)) * along;
  return true;
}

// Is everything in `behind` hidden from everywhere in `eye` by the convex outline alone? It is when
// the outline cuts both outer tangents of the two circles, between them: then the line through it
// from the one cut to the other parts them. False when in doubt.
bool Hides(std::span<const Vec2> outline, const Circle& around, const Circle& eye,
           const Circle& behind) {
  const Vec2 between = behind.centre - eye.centre;
  const double distance = std::sqrt(Dot(between, between));
  if (distance <= eye.radius + behind.radius) return false;
  const Vec2 u = (1.0 / distance) * between;
  const Vec2 to = around.centre - eye.centre;
  if (std::fabs(Cross(u, to)) > around.radius || Dot(u, to) > distance + around.radius) {
    return false;
  }
  const double sine = (eye.radius - behind.radius) / distance;
  const double cosine = std::sqrt(1.0 - sine * sine);
  Vec2 cuts[2];
  for (const int side : {0, 1}) {
    const double across = side == 0 ? cosine : -cosine;
    const Vec2 normal{sine * u.x - across * u.y, sine * u.y + across * u.x};
    if (!CrossesAt(eye.centre + eye.radius * normal, behind.centre + behind.radius * normal,
                   outline, &cuts[side])) {
      return false;
    }
  }
  // The circles must lie off the line between the cuts, each on its own side.
  const Vec2 line = cuts[1] - cuts[0];
  const double length = std::sqrt(Dot(line, line));
  const double eye_side = Cross(line, eye.centre - cuts[0]);
  const double behind_side = Cross(line, behind.centre - cuts[0]);
  constexpr double kRoom = 1e-6;  // m, so that rounding is no matter
  return (eye_side < 0.0) != (behind_side < 0.0) &&
         std::fabs(eye_side) > (eye.radius + kRoom) * length &&
         std::fabs(behind_side) > (behind.radius + kRoom) * length;
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

void PlanarScanner::Nearby::Clear() {
  xs.clear();
  ys.clear();
  counts.clear();
  gaps.clear();
}

void PlanarScanner::Nearby::Add(const PlanarWorld& world, const PlanarWorld::Outline& outline,
                                double gap) {
  if (xs.size() + outline.count + kPadding > xs.capacity()) {
    // With room for a denser place, so that this is rare once a scanner has looked about.
    for (auto* const numbers : {&xs, &ys}) numbers->reserve(2 * xs.size() + 512);
    gaps.reserve(xs.capacity() / 3);
    counts.reserve(xs.capacity() / 3);
  }
  for (const Vec2 corner : world.Corners(outline)) {
    xs.push_back(corner.x);
    ys.push_back(corner.y);
  }
  counts.push_back(outline.count);
  gaps.push_back(gap);
}

void PlanarScanner::Nearby::Finish() {
  xs.resize(xs.size() + kPadding);
  ys.resize(ys.size() + kPadding);
}

struct PlanarScanner::Fan {
  Fan(int count, double first_angle, double step) {
    for (int i = 0; i < count; ++i) {
      const auto [s, c] = SinCos(first_angle + static_cast<double>(i) * step);
      cosines.push_back(c);
      sines.push_back(s);
    }
    cosines.resize(cosines.size() + kPadding);
    sines.resize(sines.size() + kPadding);
  }
  std::vector<double> cosines;  // of the beams' angles in the sensor's frame, (count + kPadding)
  std::vector<double> sines;
};

struct PlanarScanner::Work {
  std::vector<double> inverse;   // 1/m, nearest so far, (count + kPadding)
  std::vector<double> xs, ys;    // m, corners in the sensor's frame, (corners of a Nearby)
  std::vector<double> bearings;  // of the corners from the first beam, in beams
  std::vector<std::uint32_t> found;
  std::vector<std::pair<double, std::uint32_t>> by_gap;  // of FindNear()
  Nearby moving;

  void Reserve(std::size_t corners) {
    if (xs.size() >= corners) return;
    xs.resize(corners);
    ys.resize(corners);
    bearings.resize(corners);
  }
};

// One scan's constants and its loops.
struct PlanarScanner::Kernel {
  Vec2 at;
  double sine, cosine;      // of the sensor's yaw
  double first_angle;       // rad
  double beams_per_radian;  // 1 / step
  double turn;              // beams in 2 pi
  double slack;             // beams, error of a bearing
  int count;                // beams
  const double* cosines;    // (count)
  const double* sines;      // (count)
  Work* work;

  CCMORSE_INLINE void Corners(const Nearby& near, std::size_t begin, std::size_t end) const {
    const double* const in_x = near.xs.data();
    const double* const in_y = near.ys.data();
    double* const xs = work->xs.data();
    double* const ys = work->ys.data();
    double* const bearings = work->bearings.data();
    for (std::size_t i = begin; i < end; i += 4) {
      const Four dx = Load(in_x + i) - at.x;
      const Four dy = Load(in_y + i) - at.y;
      const Four x = cosine * dx + sine * dy;
      const Four y = cosine * dy - sine * dx;
      const Four angle = RoughAngle(x, y) - first_angle;
      const Four above = angle < 0.0 ? angle + 2.0 * kPi : angle;
      const Four within = above >= 2.0 * kPi ? above - 2.0 * kPi : above;
      Store(x, xs + i);
      Store(y, ys + i);
      Store(within * beams_per_radian, bearings + i);
    }
  }

  // Outlines run counter-clockwise, so from outside an edge's end lies to the right of its start.
  CCMORSE_INLINE void Edges(std::size_t begin, std::size_t corners) const {
    const double* const xs = work->xs.data() + begin;
    const double* const ys = work->ys.data() + begin;
    const double* const bearings = work->bearings.data() + begin;
    for (std::size_t l = 0; l < corners; ++l) {
      const std::size_t r = l + 1 == corners ? 0 : l + 1;
      const Vec2 right{xs[r], ys[r]};
      const Vec2 left{xs[l], ys[l]};
      // Twice the area of sensor, right, left: positive when the front faces the sensor. Below the
      // limit, unless the sensor all but touches the edge, it is seen end on and covers no beam
      // that its neighbours do not.
      const double area = Cross(right, left);
      if (area <= kTouching || (area <= kEndOn && Dot(right, left) > 0.0)) continue;
      // A point at distance r along the unit vector d lies on the edge's line when
      // cross(r d, left - right) = area, so 1/r = d.x * a + d.y * b:
      const double a = (left.y - right.y) / area;
      const double b = (right.x - left.x) / area;
      if (IsInDoubt(bearings[r]) || IsInDoubt(bearings[l])) {
        Doubtful(right, left, bearings[r], bearings[l], a, b);
        continue;
      }
      const int low = static_cast<int>(bearings[r]) + 1;
      const int high = static_cast<int>(bearings[l]);
      if (bearings[l] >= bearings[r]) {
        Cover(low, high, a, b);
      } else if (bearings[r] - bearings[l] > 0.5 * turn) {  // across the first beam's direction
        Cover(low, count - 1, a, b);
        Cover(0, high, a, b);
      }  // else both ends lie between the same two beams
    }
  }

  // Might the error of the bearing move it across a beam, or across the first beam from behind?
  CCMORSE_INLINE bool IsInDoubt(double bearing) const {
    if (slack >= 0.25 || bearing > turn - slack) return true;
    const double part = bearing - static_cast<int>(bearing);
    return part < slack || part > 1.0 - slack;
  }

  CCMORSE_INLINE void Cover(int low, int high, double a, double b) const {
    high = high < count ? high : count - 1;
    if (low > high) return;
    Raise(work->inverse.data() + low, cosines + low, sines + low, a, b, high - low + 1);
  }

  // Decides beam by beam.
  void Doubtful(Vec2 right, Vec2 left, double right_bearing, double left_bearing, double a,
                double b) const {
    double width = left_bearing - right_bearing;
    if (width < -0.5 * turn) width += turn;
    const double margin = slack + 1.0;
    for (const double shift : {-turn, 0.0, turn}) {
      const double from = right_bearing + shift - margin;
      const double to = right_bearing + shift + width + margin;
      // Held within the fan before they become integers: steps may be as fine as they like.
      const int low = static_cast<int>(std::clamp(from, 0.0, static_cast<double>(count)));
      const int high = static_cast<int>(std::clamp(to, -1.0, count - 1.0));
      for (int i = low; i <= high; ++i) {
        const Vec2 beam{cosines[i], sines[i]};
        if (Cross(right, beam) >= 0.0 && Cross(beam, left) >= 0.0) {
          Raise(work->inverse.data() + i, cosines + i, sines + i, a, b, 1);
        }
      }
    }
  }

  // Of all beams' hits so far, or the range, m.
  CCMORSE_INLINE double Farthest() const {
    const double* const inverse = work->inverse.data();
    Four least = Load(inverse);
    for (int i = 4; i < count; i += 4) {
      const Four next = Load(inverse + i);
      least = next < least ? next : least;
    }
    return 1.0 / std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
  }

  // `since`: m, that the sensor has moved since the gaps were measured.
  CCMORSE_INLINE void Outlines(const Nearby& near, double since) const {
    work->Reserve(near.xs.capacity());
    std::size_t outline = 0;
    std::size_t begin = 0;
    while (outline < near.counts.size()) {
      // They come nearest first: once one lies behind all that is hit, so do the rest.
      if (outline > 0 && Farthest() < near.gaps[outline] - since - 1e-6) break;
      std::size_t last = outline;
      std::size_t end = begin;
      while (last < near.counts.size() && end - begin < kChunk) end += near.counts[last++];
      Corners(near, begin, end);
      for (; outline < last; ++outline) {
        Edges(begin, near.counts[outline]);
        begin += near.counts[outline];
      }
    }
  }

  CCMORSE_INLINE void Ranges(double range, double* ranges) const {
    const double* const inverse = work->inverse.data();
    const double floor = 1.0 / range;
    const Four without{range, range, range, range};
    int i = 0;
    for (; i + 4 <= count; i += 4) {
      const Four nearest = Load(inverse + i);
      Store(nearest > floor ? 1.0 / nearest : without, ranges + i);
    }
    for (; i < count; ++i) ranges[i] = inverse[i] > floor ? 1.0 / inverse[i] : range;
  }

  CCMORSE_INLINE void All(const PlanarScanner& scanner, const PlanarWorld& moving, int self,
                          double* ranges) const {
    const Vec2 moved = at - scanner.near_at_;
    Outlines(scanner.near_, std::sqrt(Dot(moved, moved)));
    if (!moving.outlines().empty()) {
      CollectMoving(moving, self);
      Outlines(work->moving, 0.0);
    }
    Ranges(scanner.range_, ranges);
  }

  void CollectMoving(const PlanarWorld& moving, int self) const {
    const double farthest = Farthest();
    work->found.clear();
    work->moving.Clear();
    moving.Near(at, farthest, work->found);
    for (const std::uint32_t index : work->found) {
      const PlanarWorld::Outline& outline = moving.outlines()[index];
      if (outline.owner >= 0 && outline.owner == self) continue;
      work->moving.Add(moving, outline, 0.0);
    }
    work->moving.Finish();
  }

  using Scan = void (*)(const Kernel&, const PlanarScanner&, const PlanarWorld&, int, double*);
  static void Portable(const Kernel& kernel, const PlanarScanner& scanner,
                       const PlanarWorld& moving, int self, double* ranges) {
    kernel.All(scanner, moving, self, ranges);
  }
#if defined(__x86_64__)
  __attribute__((target("avx2"))) static void Avx2(const Kernel& kernel,
                                                   const PlanarScanner& scanner,
                                                   const PlanarWorld& moving, int self,
                                                   double* ranges) {
    kernel.All(scanner, moving, self, ranges);
  }
  static Scan Best() { return __builtin_cpu_supports("avx2") ? Avx2 : Portable; }
#else
  static Scan Best() { return Portable; }
#endif
  static Scan scan;
};
#undef CCMORSE_INLINE

PlanarScanner::Kernel::Scan PlanarScanner::Kernel::scan = PlanarScanner::Kernel::Best();

void PlanarScanner::ForcePortable(bool portable) {
  Kernel::scan = portable ? Kernel::Portable : Kernel::Best();
}

PlanarScanner::PlanarScanner(int count, double first_angle, double step, double range)
    : count_(count), first_angle_(NormalizeAngle(first_angle)), step_(step), range_(range) {
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
  const Vec2 at{pose.x, pose.y};
  FindNear(at, fixed, work);
  const auto beams = static_cast<std::size_t>(count_);
  work.inverse.assign(beams + kPadding, 1.0 / range_);
  // The padding never is the farthest.
  std::fill(work.inverse.begin() + static_cast<std::ptrdiff_t>(beams), work.inverse.end(), 1e300);
  const auto [sine, cosine] = SinCos(pose.yaw);
  const double beams_per_radian = 1.0 / step_;
  Kernel::scan(
      {at, sine, cosine, first_angle_, beams_per_radian, 2.0 * kPi * beams_per_radian,
       kRoughError * beams_per_radian, count_, fan_->cosines.data(), fan_->sines.data(), &work},
      *this, moving, self, ranges.data());
}

void PlanarScanner::FindNear(Vec2 at, const PlanarWorld& world, Work& work) {
  const Vec2 moved = at - near_at_;
  if (near_world_ == &world && near_revision_ == world.revision() &&
      Dot(moved, moved) < kRemembered * kRemembered) {
    return;
  }
  near_world_ = &world;
  near_revision_ = world.revision();
  near_at_ = at;
  work.found.clear();
  work.found.reserve(world.outlines().size());
  work.by_gap.reserve(world.outlines().size());
  world.Near(at, range_ + kRemembered, work.found);
  work.by_gap.clear();
  for (const std::uint32_t index : work.found) {
    const Circle& around = world.outlines()[index].around;
    const Vec2 d = around.centre - at;
    work.by_gap.emplace_back(std::sqrt(Dot(d, d)) - around.radius, index);
  }
  std::sort(work.by_gap.begin(), work.by_gap.end());
  near_.Clear();
  // What a single larger outline hides from wherever this is remembered need not be looked at.
  const Circle eye{at, kRemembered};
  std::array<const PlanarWorld::Outline*, kMostScreens> screens;
  std::size_t count = 0;
  for (const auto& [gap, index] : work.by_gap) {
    const PlanarWorld::Outline& outline = world.outlines()[index];
    const bool large = outline.around.radius > kLarge;
    const bool hidden =
        std::any_of(screens.begin(), screens.begin() + count, [&](const auto* screen) {
          const auto hides = [&](const Circle& behind) {
            return Hides(world.Corners(*screen), screen->around, eye, behind);
          };
          // What a convex outline hides from a point is convex, so the corners stand for all.
          if (!large) return hides(outline.around);
          const std::span<const Vec2> corners = world.Corners(outline);
          return std::all_of(corners.begin(), corners.end(), [&](Vec2 corner) {
            return hides({corner, 0.0});
          });
        });
    if (hidden) continue;
    near_.Add(world, outline, gap);
    // From within, an outline hides nothing.
    const bool apart = DistanceBeyondEdges(world.Corners(outline), at) > kRemembered;
    if (large && apart && count < kMostScreens) screens[count++] = &outline;
  }
  near_.Finish();
}

}  // namespace ccmorse::sim
