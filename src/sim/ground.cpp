#include "sim/ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/convex_hull.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "scene/mesh.h"

namespace ccmorse::sim {
namespace {

constexpr double kSteepest = 0.642787609686539;  // cosine of 50 degrees
constexpr double kRise = 1.1917535925942100;     // its tangent
constexpr double kSeam = 1e-9;                   // share of a triangle by which neighbours overlap
constexpr double kMostGroundCells = 512;         // along each side of the grid
constexpr double kMarch = 0.05;                  // m from one look at the ground to the next
constexpr double kLevel = 0.03;  // m by which ground may differ from where a march ends
constexpr double kWheels = 0.8;  // of the footprint's extent: where the wheels are
constexpr double kSink = 1e-6;   // m: ground as high as the start of a search counts

// z of the triangle's plane at a point within it; nothing beside it.
std::optional<double> HeightAt(const std::array<Vec3, 3>& t, Vec2 at) {
  const Vec2 a{t[0].x, t[0].y};
  const Vec2 b{t[1].x, t[1].y};
  const Vec2 c{t[2].x, t[2].y};
  const double area = Cross(b - a, c - a);
  if (area == 0.0) return std::nullopt;
  const double u = Cross(b - at, c - at) / area;
  const double v = Cross(c - at, a - at) / area;
  const double w = 1.0 - u - v;
  if (u < -kSeam || v < -kSeam || w < -kSeam) return std::nullopt;
  return u * t[0].z + v * t[1].z + w * t[2].z;
}

Vec2 NearestOf(const std::vector<Vec2>& outline, Vec2 point) {
  if (outline.size() > 2 && Contains(outline, point)) return point;
  Vec2 nearest = outline[0];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 from = outline[i];
    const Vec2 edge = outline[(i + 1) % outline.size()] - from;
    const double length = Dot(edge, edge);
    const double along =
        length > 0.0 ? std::clamp(Dot(point - from, edge) / length, 0.0, 1.0) : 0.0;
    const Vec2 on = from + along * edge;
    const double far = Dot(on - point, on - point);
    if (far < least) {
      least = far;
      nearest = on;
    }
  }
  return nearest;
}

}  // namespace

Ground::Ground(const scene::World& world) {
  if (!world.terrain) return;
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-low.x, -low.y};
  for (const scene::Mesh& mesh : world.meshes) {
    if (!mesh.solid) continue;
    const std::vector<Vec3> vertices = scene::PlacedVertices(mesh);
    for (const auto& corners : mesh.triangles) {
      Triangle triangle;
      triangle.mesh = mesh.id;
      triangle.low = {std::numeric_limits<double>::infinity(),
                      std::numeric_limits<double>::infinity()};
      triangle.high = {-triangle.low.x, -triangle.low.y};
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& v = vertices[static_cast<std::size_t>(corners[k])];
        triangle.corners[k] = v;
        triangle.low = {std::min(triangle.low.x, v.x), std::min(triangle.low.y, v.y)};
        triangle.high = {std::max(triangle.high.x, v.x), std::max(triangle.high.y, v.y)};
      }
      const Vec3 normal = Cross(triangle.corners[1] - triangle.corners[0],
                                triangle.corners[2] - triangle.corners[0]);
      triangle.walkable = normal.z * normal.z >= kSteepest * kSteepest * Dot(normal, normal);
      low = {std::min(low.x, triangle.low.x), std::min(low.y, triangle.low.y)};
      high = {std::max(high.x, triangle.high.x), std::max(high.y, triangle.high.y)};
      triangles_.push_back(triangle);
    }
  }
  // Floors are drawn at z = 0 where meshes make no ground of their own.
  if (world.has_floor) {
    const Vec2 end = world.high();
    const Vec3 a{world.low.x, world.low.y, 0.0};
    const Vec3 b{end.x, world.low.y, 0.0};
    const Vec3 c{end.x, end.y, 0.0};
    const Vec3 d{world.low.x, end.y, 0.0};
    triangles_.push_back({{a, b, c}, 0, true, world.low, end});
    triangles_.push_back({{a, c, d}, 0, true, world.low, end});
    low = {std::min(low.x, world.low.x), std::min(low.y, world.low.y)};
    high = {std::max(high.x, end.x), std::max(high.y, end.y)};
  }
  if (triangles_.empty()) return;
  corner_ = low;
  const double size = std::max(high.x - low.x, high.y - low.y);
  // About two triangles a cell, and none smaller than a robot's wheel.
  const double count = std::sqrt(static_cast<double>(triangles_.size()) / 2.0);
  cell_ = std::max({size / std::clamp(count, 1.0, kMostGroundCells), 0.1, size / kMostGroundCells});
  columns_ = static_cast<std::size_t>((high.x - low.x) / cell_) + 1;
  rows_ = static_cast<std::size_t>((high.y - low.y) / cell_) + 1;
  const auto each_cell = [this](const Triangle& triangle, const auto& use) {
    for (std::size_t row = Row(triangle.low.y); row <= Row(triangle.high.y); ++row) {
      for (std::size_t column = Column(triangle.low.x); column <= Column(triangle.high.x);
           ++column) {
        use(row * columns_ + column);
      }
    }
  };
  starts_.assign(columns_ * rows_ + 1, 0);
  for (const Triangle& triangle : triangles_) {
    each_cell(triangle, [this](std::size_t cell) { ++starts_[cell + 1]; });
  }
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  items_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    each_cell(triangles_[i],
              [&](std::size_t cell) { items_[next[cell]++] = static_cast<std::uint32_t>(i); });
  }
}

std::size_t Ground::Column(double x) const {
  const double index = (x - corner_.x) / cell_;
  return index > 0.0 ? std::min(static_cast<std::size_t>(index), columns_ - 1) : 0;
}

std::size_t Ground::Row(double y) const {
  const double index = (y - corner_.y) / cell_;
  return index > 0.0 ? std::min(static_cast<std::size_t>(index), rows_ - 1) : 0;
}

template <typename Visit>
void Ground::ForNear(Vec2 low, Vec2 high, const Visit& visit) const {
  if (triangles_.empty()) return;
  const std::size_t left = Column(low.x);
  const std::size_t bottom = Row(low.y);
  const std::size_t right = Column(high.x);
  const std::size_t top = Row(high.y);
  for (std::size_t row = bottom; row <= top; ++row) {
    for (std::size_t column = left; column <= right; ++column) {
      const std::size_t cell = row * columns_ + column;
      for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
        const Triangle& triangle = triangles_[items_[i]];
        if (triangle.high.x < low.x || triangle.low.x > high.x || triangle.high.y < low.y ||
            triangle.low.y > high.y) {
          continue;
        }
        // Of the cells that it is in, the first one visited shows it.
        if (std::max(Column(triangle.low.x), left) != column ||
            std::max(Row(triangle.low.y), bottom) != row) {
          continue;
        }
        visit(triangle);
      }
    }
  }
}

std::optional<double> Ground::Below(Vec2 at, double from) const {
  std::optional<double> highest;
  ForNear(at, at, [&](const Triangle& triangle) {
    if (!triangle.walkable) return;
    const std::optional<double> z = HeightAt(triangle.corners, at);
    if (z && *z <= from + kSink && (!highest || *z > *highest)) highest = z;
  });
  return highest;
}

double Ground::Land(Vec2 at, double from) const {
  if (const std::optional<double> below = Below(at, from + kStep)) return *below;
  std::optional<double> lowest;
  ForNear(at, at, [&](const Triangle& triangle) {
    if (!triangle.walkable) return;
    const std::optional<double> z = HeightAt(triangle.corners, at);
    if (z && (!lowest || *z < *lowest)) lowest = z;
  });
  return lowest.value_or(0.0);
}

Stand Ground::StandAt(const Footprint& footprint, const Pose2& pose, double z) const {
  double front = 0.0;
  double back = 0.0;
  double left = 0.0;
  double right = 0.0;
  for (const Vec2 corner : footprint.outline) {
    front = std::max(front, kWheels * corner.x);
    back = std::min(back, kWheels * corner.x);
    left = std::max(left, kWheels * corner.y);
    right = std::min(right, kWheels * corner.y);
  }
  Stand stand;
  const Vec2 here{pose.x, pose.y};
  // Beside all ground it stays at its height.
  stand.z = Below(here, z + kStep + kRise * footprint.radius * 0.1).value_or(z);
  const double length = front - back;
  const double width = left - right;
  if (!(length > 0.0) || !(width > 0.0)) return stand;
  const auto height = [&](double x, double y) {
    const Vec2 at = Transform(pose, {x, y});
    const double far = std::sqrt(x * x + y * y);
    const double found = March(here, stand.z, at);
    // What is steeper than ground is an edge that the wheel hangs over.
    return found >= stand.z - kStep - kRise * far ? found : stand.z;
  };
  const double front_left = height(front, left);
  const double front_right = height(front, right);
  const double back_left = height(back, left);
  const double back_right = height(back, right);
  const double slope_x = 0.5 * (front_left + front_right - back_left - back_right) / length;
  const double slope_y = 0.5 * (front_left + back_left - front_right - back_right) / width;
  // The plane through the wheels, above the origin; what it would be buried by lifts it.
  const double mean = 0.25 * (front_left + front_right + back_left + back_right);
  const double middle_x = 0.5 * (front + back);
  const double middle_y = 0.5 * (left + right);
  stand.z = mean - slope_x * middle_x - slope_y * middle_y;
  if (slope_x == 0.0 && slope_y == 0.0) return stand;
  stand.pitch = -Atan2(slope_x, 1.0);
  // Rz(yaw) Ry(pitch) Rx(roll): roll is about the pitched x axis.
  stand.roll = Atan2(slope_y, std::sqrt(1.0 + slope_x * slope_x));
  return stand;
}

double Ground::March(Vec2 from, double z, Vec2 to) const {
  const Vec2 way = to - from;
  const double length = std::sqrt(Dot(way, way));
  const int steps = std::max(1, static_cast<int>(std::ceil(length / kMarch)));
  for (int i = 1; i <= steps; ++i) {
    const Vec2 at = from + (static_cast<double>(i) / steps) * way;
    z = Below(at, z + kStep + kRise * length / steps).value_or(z);
  }
  return z;
}

void Ground::Obstacles(const Pose2& pose, const Stand& stand, double reach, double bottom,
                       double top, bool level, std::vector<Obstacle>& found) const {
  const Vec2 low{pose.x - reach, pose.y - reach};
  const Vec2 high{pose.x + reach, pose.y + reach};
  // The plane's rise along the world's axes.
  double rise_x = 0.0;
  double rise_y = 0.0;
  if (!level && (stand.pitch != 0.0 || stand.roll != 0.0)) {
    const SinCosPair pitch = SinCos(stand.pitch);
    const SinCosPair roll = SinCos(stand.roll);
    const double forward = -pitch.sin / pitch.cos;
    const double sideways = roll.sin / (roll.cos * pitch.cos);
    const SinCosPair yaw = SinCos(pose.yaw);
    rise_x = yaw.cos * forward - yaw.sin * sideways;
    rise_y = yaw.sin * forward + yaw.cos * sideways;
  }
  const auto plane = [&](double x, double y) {
    return level ? 0.0 : stand.z + rise_x * (x - pose.x) + rise_y * (y - pose.y);
  };
  ForNear(low, high, [&](const Triangle& triangle) {
    std::vector<Vec3> above;
    above.reserve(5);
    bool over = false;
    bool under = false;
    for (const Vec3& corner : triangle.corners) {
      above.push_back({corner.x, corner.y, corner.z - plane(corner.x, corner.y)});
      over = over || above.back().z >= bottom;
      under = under || above.back().z <= top;
    }
    if (!over || !under) return;
    std::vector<Vec2> points;
    for (const Vec3& point : scene::ClippedToSlab(above, bottom, top)) {
      points.push_back({point.x, point.y});
    }
    std::vector<Vec2> outline = ConvexHull(std::move(points));
    if (outline.size() < 2) return;
    if (triangle.walkable && !level) {
      const Vec2 nearest = NearestOf(outline, {pose.x, pose.y});
      if (const std::optional<double> z = HeightAt(triangle.corners, nearest)) {
        if (std::fabs(March({pose.x, pose.y}, stand.z, nearest) - *z) <= kLevel) return;
      }
    }
    found.push_back(Obstacle::Make(std::move(outline), triangle.mesh));
  });
}

}  // namespace ccmorse::sim
