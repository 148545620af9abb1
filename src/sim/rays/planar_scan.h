#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/pose.h"

namespace ccmorse::sim {

/// The world cut at one height: convex outlines, as a scanner at that height meets them.
/// Plain data; reading is thread safe.
class PlanarWorld {
 public:
  struct Outline {
    std::uint32_t first = 0;  ///< index of its first corner
    std::uint32_t count = 0;  ///< corners, >= 3
    Vec2 centre;              ///< m, of a circle around it
    double radius = 0.0;      ///< m
    int owner = -1;           ///< robot whose hull it is, -1 for a box of the world
  };

  void Clear();
  /// Adds a convex outline, counter-clockwise, m. Keeps a copy.
  void Add(std::span<const Vec2> outline, int owner = -1);

  std::span<const Outline> outlines() const { return outlines_; }
  std::span<const Vec2> Corners(const Outline& outline) const {
    return std::span(corners_).subspan(outline.first, outline.count);
  }

 private:
  std::vector<Vec2> corners_;
  std::vector<Outline> outlines_;
};

/// A planar range scanner's fan of beams and its beam buffer (design: Rays). No ray is traced: each
/// front-facing edge is rasterised into the buffer of beams as 1/range, which is linear in the
/// beam's direction, and the nearest wins. Exact up to rounding; the same on every instruction set.
/// One thread at a time may scan with one object.
class PlanarScanner {
 public:
  /// `count` beams, the first at `first_angle` (rad, in the sensor's frame), then counter-clockwise
  /// in steps of `step` (rad, > 0; count * step <= 2 pi + step). Beams without a hit give `range`
  /// (m).
  PlanarScanner(int count, double first_angle, double step, double range);

  int count() const { return count_; }
  double range() const { return range_; }
  /// Unit vector of beam i in the sensor's frame.
  Vec2 Direction(int i) const {
    return {cosines_[static_cast<std::size_t>(i)], sines_[static_cast<std::size_t>(i)]};
  }

  /// Distances along all beams, m, (count), of a sensor at `pose`, to the outlines of `fixed` and
  /// `moving` that are not `self`'s own.
  void Scan(const Pose2& pose, const PlanarWorld& fixed, const PlanarWorld& moving, int self,
            std::span<double> ranges);

 private:
  void ScanWorld(const Pose2& pose, const PlanarWorld& world, int self);
  void RasteriseEdge(Vec2 right, Vec2 left, double right_angle, double left_angle);
  void Cover(int low, int high, Vec2 right, Vec2 left, double a, double b);

  int count_;
  double first_angle_;
  double step_;
  double range_;
  std::vector<double> cosines_;  // of the beams, (count)
  std::vector<double> sines_;
  std::vector<double> inverse_;  // 1/m, nearest so far, (count)
  std::vector<Vec2> local_;      // corners of one outline in the sensor's frame, scratch
  std::vector<double> angles_;   // their rough angles from the first beam, rad, 0..2 pi, scratch
};

}  // namespace ccmorse::sim
