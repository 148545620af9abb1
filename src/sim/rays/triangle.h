#pragma once

#include "base/pose.h"

namespace ccmorse::sim {

/// A cone of rays from a sensor.
struct Cone {
  Vec3 apex;          ///< m
  Vec3 axis;          ///< unit vector
  double cosine = 1;  ///< of half the opening angle, which is in (0, pi/2)
  double sine = 0;    ///< of the same
};

/// Distance along the ray `origin` + t `direction` to the plane of a triangle with normal `normal`
/// (of any length) through `corner`, in units of `direction`; infinite or NaN when parallel.
constexpr double PlaneDistance(const Vec3& origin, const Vec3& direction, const Vec3& normal,
                               const Vec3& corner) {
  return Dot(normal, corner - origin) / Dot(normal, direction);
}

/// Does the line through `origin` along `direction` pass through the triangle a b c, its edges
/// included? Triangles that share an edge leave no gap: both compute the same number for it, one
/// with the other sign.
bool LineMeets(const Vec3& origin, const Vec3& direction, const Vec3& a, const Vec3& b,
               const Vec3& c);

/// Distance from the cone's apex to the nearest point of the triangle a b c that lies in the cone,
/// m; infinite when none does. `normal` is Cross(b - a, c - a), not zero.
double ConeDistance(const Cone& cone, const Vec3& a, const Vec3& b, const Vec3& c,
                    const Vec3& normal);

}  // namespace ccmorse::sim
