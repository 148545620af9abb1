#include "sim/physics/kinematics.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/polygon.h"
#include "base/trig.h"

namespace ccmorse::sim {
namespace {

constexpr double kCheckEvery = 0.005;     // m of the fastest point's path
constexpr double kStopShort = 1e-5;       // m: how closely a blocked robot stands before contact
constexpr std::size_t kMostCorners = 16;  // of a footprint, which is placed without allocation

double RadiusAround(std::span<const Vec2> outline, Vec2 centre) {
  double radius = 0.0;
  for (const Vec2 corner : outline) {
    const Vec2 d = corner - centre;
    radius = std::max(radius, std::sqrt(Dot(d, d)));
  }
  return radius;
}

// Of the origin, m/s. A square root would not give |v| to the last bit.
double Speed(double v, double side) {
  return side == 0.0 ? std::fabs(v) : std::sqrt(v * v + side * side);
}

}  // namespace

Pose2 DriveArc(const Pose2& start, double v, double w, double seconds, double side) {
  // The chord of the arc: length v t sin(h)/h in the direction of the middle heading, h = w t / 2.
  const double half = 0.5 * w * seconds;
  const double sinc = std::fabs(half) < 1e-4 ? 1.0 - half * half / 6.0 : SinCos(half).sin / half;
  const auto [s, c] = SinCos(start.yaw + half);
  const double chord = v * seconds * sinc;
  Pose2 end{start.x + chord * c, start.y + chord * s, NormalizeAngle(start.yaw + w * seconds)};
  if (side != 0.0) {
    const double across = side * seconds * sinc;
    end.x -= across * s;
    end.y += across * c;
  }
  return end;
}

Obstacle Obstacle::Make(std::vector<Vec2> outline, int box_id) {
  Obstacle made{std::move(outline), {}, 0.0, box_id};
  for (const Vec2 corner : made.outline) {
    made.centre = made.centre + (1.0 / static_cast<double>(made.outline.size())) * corner;
  }
  made.radius = RadiusAround(made.outline, made.centre);
  return made;
}

Footprint Footprint::Make(std::vector<Vec2> outline) {
  if (outline.size() > kMostCorners) throw Error("a footprint has at most 16 corners");
  Footprint made{std::move(outline), 0.0};
  made.radius = RadiusAround(made.outline, {});
  return made;
}

std::vector<Vec2> Footprint::At(const Pose2& pose) const {
  std::vector<Vec2> placed(outline.size());
  Place(outline, pose, placed);
  return placed;
}

void Obstacle::MoveTo(const Footprint& footprint, const Pose2& pose) {
  outline.resize(footprint.outline.size());
  Place(footprint.outline, pose, outline);
  centre = {pose.x, pose.y};
  radius = footprint.radius;
}

bool Collides(const Footprint& footprint, const Pose2& pose,
              std::span<const Obstacle* const> obstacles) {
  std::array<Vec2, kMostCorners> buffer;
  const std::size_t count = footprint.outline.size();
  bool placed = false;
  for (const Obstacle* obstacle : obstacles) {
    const Vec2 d{obstacle->centre.x - pose.x, obstacle->centre.y - pose.y};
    const double reach = obstacle->radius + footprint.radius;
    if (Dot(d, d) >= reach * reach) continue;
    if (!placed) {
      Place(footprint.outline, pose, std::span(buffer).first(count));
      placed = true;
    }
    if (ConvexOverlap(std::span(buffer).first(count), obstacle->outline)) return true;
  }
  return false;
}

MotionResult DriveUntilContact(const Footprint& footprint, const Pose2& start, double v, double w,
                               double seconds, std::span<const Obstacle* const> obstacles,
                               double side) {
  const double speed = Speed(v, side);
  if (obstacles.empty()) return {DriveArc(start, v, w, seconds, side), false, speed * seconds};
  const double path = (speed + std::fabs(w) * footprint.radius) * seconds;
  const int steps = std::max(1, static_cast<int>(std::ceil(path / kCheckEvery)));
  const auto at = [&](double fraction) { return DriveArc(start, v, w, fraction * seconds, side); };
  double free = 0.0;
  for (int step = 1; step <= steps; ++step) {
    const double next = step == steps ? 1.0 : static_cast<double>(step) / steps;
    if (!Collides(footprint, at(next), obstacles)) {
      free = next;
      continue;
    }
    double hit = next;
    while ((hit - free) * path > kStopShort) {
      const double middle = 0.5 * (free + hit);
      (Collides(footprint, at(middle), obstacles) ? hit : free) = middle;
    }
    return {free > 0.0 ? at(free) : start, true, speed * seconds * free};
  }
  return {at(1.0), false, speed * seconds};
}

}  // namespace ccmorse::sim
