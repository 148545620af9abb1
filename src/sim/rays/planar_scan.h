#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/pose.h"
#include "sim/spatial_grid.h"

namespace ccmorse::sim {

/// The world cut at one height: convex outlines, as a scanner at that height meets them.
/// Reading is thread safe.
class PlanarWorld {
 public:
  struct Outline {
    std::uint32_t first = 0;  ///< index of its first corner
    std::uint32_t count = 0;  ///< corners, >= 3
    Circle around;            ///< all of it
    int owner = -1;           ///< robot whose hull it is, -1 for a box of the world
  };

  void Clear();
  /// Adds a convex outline, counter-clockwise, m. Keeps a copy.
  void Add(std::span<const Vec2> outline, int owner = -1);

  /// To be called when all outlines are added, before the first scan.
  void Finish();

  /// Changes whenever the content may have.
  std::uint64_t revision() const { return revision_; }

  /// Appends the indexes of all outlines that come within `reach` (m) of `point`.
  void Near(Vec2 point, double reach, std::vector<std::uint32_t>& found) const;

  std::span<const Outline> outlines() const { return outlines_; }
  std::span<const Vec2> Corners(const Outline& outline) const {
    return std::span(corners_).subspan(outline.first, outline.count);
  }

 private:
  std::vector<Vec2> corners_;
  std::vector<Outline> outlines_;
  std::vector<Circle> circles_;  // of the outlines
  SpatialGrid grid_;
  std::uint64_t revision_ = 0;
};

/// A planar range scanner's fan of beams and its beam buffer (design: Rays). No ray is traced: each
/// front-facing edge is rasterised into the buffer of beams as 1/range, which is linear in the
/// beam's direction, and the nearest wins. Outlines come nearest first, and those that lie behind
/// all that was hit are left out. Exact up to rounding; the same on every instruction set. One
/// thread at a time may scan with one object.
class PlanarScanner {
 public:
  /// `count` beams, the first at `first_angle` (rad, in the sensor's frame), then counter-clockwise
  /// in steps of `step` (rad, > 0; count * step <= 2 pi + step). Beams without a hit give `range`
  /// (m).
  PlanarScanner(int count, double first_angle, double step, double range);

  int count() const { return count_; }
  double range() const { return range_; }
  /// Unit vector of beam i in the sensor's frame.
  Vec2 Direction(int i) const;

  /// Distances along all beams, m, (count), of a sensor at `pose`, to the outlines of `fixed` and
  /// `moving` that are not `self`'s own. Both are finished. What lies near in `fixed` is remembered
  /// from scan to scan, by its address and revision.
  void Scan(const Pose2& pose, const PlanarWorld& fixed, const PlanarWorld& moving, int self,
            std::span<double> ranges);

  /// Uses the portable kernels even where the processor has AVX2: tests compare the two.
  static void ForcePortable(bool portable);

 private:
  // Outlines of which a scan may meet some, nearest first, their corners one after the other.
  struct Nearby {
    std::vector<double> xs, ys;         // m, corners in the world's frame
    std::vector<std::uint32_t> counts;  // corners of each outline
    std::vector<double> gaps;           // m, from the sensor to each outline's circle
    void Clear();
    void Add(const PlanarWorld& world, const PlanarWorld::Outline& outline, double gap);
    void Finish();  // pads the corners for the loops
  };
  struct Fan;     // the beams' directions; scanners alike share one
  struct Work;    // the beam buffer and other scratch; scanners of a thread share one
  struct Kernel;  // the loops, compiled for two instruction sets

  void FindNear(Vec2 at, const PlanarWorld& world, Work& work);

  int count_;
  double first_angle_;  // rad, in (-pi, pi]
  double step_;
  double range_;
  std::shared_ptr<const Fan> fan_;
  const PlanarWorld* near_world_ = nullptr;  // of which near_ was made, at
  std::uint64_t near_revision_ = 0;          // this revision,
  Vec2 near_at_;                             // for scans around here
  Nearby near_;                              // of the fixed world
};

}  // namespace ccmorse::sim
