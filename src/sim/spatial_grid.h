#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/pose.h"

namespace ccmorse::sim {

/// A circle around something in the plane, m.
struct Circle {
  Vec2 centre;
  double radius = 0.0;
};

/// Which of many circles may be near a point: a uniform grid over their centres, cells in rows
/// (the broad phase of contact and of scans). Reading is thread safe.
class SpatialGrid {
 public:
  /// Forgets what was there and takes these; keeps its memory. O(circles).
  void Build(std::span<const Circle> circles);

  /// Calls visit(index) for every circle that comes within `reach` (m) of `point`, ordered by cell
  /// and, within one, by index: the order depends on nothing else.
  template <typename Visit>
  void ForNear(Vec2 point, double reach, Visit visit) const {
    if (circles_.empty()) return;
    const double farthest = reach + largest_radius_;
    const int left = Column(point.x - farthest);
    const int right = Column(point.x + farthest);
    const int top = Row(point.y + farthest);
    for (int row = Row(point.y - farthest); row <= top; ++row) {
      const std::uint32_t* const starts =
          &starts_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_)];
      for (std::uint32_t i = starts[left]; i < starts[right + 1]; ++i) {
        const Circle& circle = circles_[items_[i]];
        const Vec2 d = circle.centre - point;
        const double sum = reach + circle.radius;
        if (Dot(d, d) <= sum * sum) visit(items_[i]);
      }
    }
  }

 private:
  int Column(double x) const { return Clamped((x - corner_.x) / cell_, columns_); }
  int Row(double y) const { return Clamped((y - corner_.y) / cell_, rows_); }
  static int Clamped(double index, int count) {
    return index > 0.0 ? (index < count ? static_cast<int>(index) : count - 1) : 0;
  }

  std::vector<Circle> circles_;
  std::vector<std::uint32_t> starts_;  // (rows * columns + 1), first item of each cell
  std::vector<std::uint32_t> items_;   // indexes of circles, by cell
  std::vector<std::uint32_t> cells_;   // cell of each circle, scratch of Build()
  double largest_radius_ = 0.0;
  Vec2 corner_;
  double cell_ = 1.0;  // m
  int columns_ = 0;
  int rows_ = 0;
};

}  // namespace ccmorse::sim
