#include "sim/rays/triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ccmorse::sim {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

bool InCone(const Cone& cone, const Vec3& point) {
  return Dot(point, cone.axis) >= cone.cosine * std::sqrt(Dot(point, point));
}

// `point`, in the plane of the triangle, lies within it.
bool InTriangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c,
                const Vec3& normal) {
  return Dot(Cross(b - a, point - a), normal) >= 0.0 &&
         Dot(Cross(c - b, point - b), normal) >= 0.0 && Dot(Cross(a - c, point - c), normal) >= 0.0;
}

// Distance from 0 to the nearest point in the cone, whose apex is 0, of the edge from a to b.
double EdgeDistance(const Cone& cone, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const auto at = [&](double s) { return a + s * along; };
  const double nearest = std::clamp(-Dot(a, along) / Dot(along, along), 0.0, 1.0);
  if (InCone(cone, at(nearest))) return std::sqrt(Dot(at(nearest), at(nearest)));
  // The part within the cone, if any, begins or ends on its surface, as the cone is convex:
  // (P axis)^2 = cosine^2 P^2 with P = at(s).
  const double square = cone.cosine * cone.cosine;
  const double a_axis = Dot(a, cone.axis);
  const double along_axis = Dot(along, cone.axis);
  const double q2 = along_axis * along_axis - square * Dot(along, along);
  const double q1 = a_axis * along_axis - square * Dot(a, along);
  const double q0 = a_axis * a_axis - square * Dot(a, a);
  const double discriminant = q1 * q1 - q2 * q0;
  if (discriminant < 0.0) return kNever;
  const double q = -(q1 + std::copysign(std::sqrt(discriminant), q1));
  double least = kNever;
  for (const double s : {q / q2, q0 / q}) {
    if (!(s >= 0.0 && s <= 1.0) || a_axis + s * along_axis < 0.0) continue;
    least = std::min(least, std::sqrt(Dot(at(s), at(s))));
  }
  return least;
}

}  // namespace

bool LineMeets(const Vec3& origin, const Vec3& direction, const Vec3& a, const Vec3& b,
               const Vec3& c) {
  const Vec3 to_a = a - origin;
  const Vec3 to_b = b - origin;
  const Vec3 to_c = c - origin;
  const double u = Dot(direction, Cross(to_b, to_c));
  const double v = Dot(direction, Cross(to_c, to_a));
  const double w = Dot(direction, Cross(to_a, to_b));
  return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
}

double ConeDistance(const Cone& cone, const Vec3& a, const Vec3& b, const Vec3& c,
                    const Vec3& normal) {
  const Vec3 to_a = a - cone.apex;
  const Vec3 to_b = b - cone.apex;
  const Vec3 to_c = c - cone.apex;
  // In the triangle's plane the distance grows with the distance from the foot of the
  // perpendicular, and cone and triangle cut a convex piece out of it. So the nearest point is
  // the foot, or the point of the cone nearest to the foot, or on an edge.
  const double length = std::sqrt(Dot(normal, normal));
  const double signed_height = Dot(normal, to_a) / length;
  const double height = std::fabs(signed_height);
  const Vec3 down = (std::copysign(1.0, signed_height) / length) * normal;  // unit, to the plane
  const double cosine = Dot(down, cone.axis);
  Vec3 nearest = down;  // of the cone's directions the one nearest to `down`
  if (cosine < cone.cosine) {
    const Vec3 sideways = down - cosine * cone.axis;
    const double sine = std::sqrt(Dot(sideways, sideways));
    if (sine == 0.0) return kNever;  // the plane lies behind
    nearest = cone.cosine * cone.axis + (cone.sine / sine) * sideways;
  }
  const double slope = Dot(nearest, down);
  if (slope <= 0.0) return kNever;
  const double distance = height / slope;
  if (InTriangle(distance * nearest, to_a, to_b, to_c, normal)) return distance;
  return std::min({EdgeDistance(cone, to_a, to_b), EdgeDistance(cone, to_b, to_c),
                   EdgeDistance(cone, to_c, to_a)});
}

}  // namespace ccmorse::sim
