#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/pose.h"

namespace ccmorse {

/// Where `point` of the frame `frame` lies in the world, m.
Vec2 Transform(const Pose2& frame, Vec2 point);

/// Where `point` of the world lies in the frame `frame`, m.
Vec2 InverseTransform(const Pose2& frame, Vec2 point);

/// All `points` of the frame `frame` in the world, m, into `placed`, which holds as many.
void Place(std::span<const Vec2> points, const Pose2& frame, std::span<Vec2> placed);

/// The corners of an upright box seen from above, counter-clockwise from its (+x, +y) corner, m.
std::array<Vec2, 4> BoxCorners(const Pose2& centre, double size_x, double size_y);

/// Signed gap between two convex counter-clockwise polygons along the best separating edge normal,
/// m: positive and at most their distance when they are apart, minus the penetration depth when
/// they overlap, 0 when they touch.
double ConvexGap(std::span<const Vec2> a, std::span<const Vec2> b);

/// How far the point lies beyond the convex counter-clockwise polygon's edge lines, m: at most its
/// distance from the polygon, negative inside.
double DistanceBeyondEdges(std::span<const Vec2> polygon, Vec2 point);

/// Do the two convex counter-clockwise polygons share area?
bool ConvexOverlap(std::span<const Vec2> a, std::span<const Vec2> b);

/// Is the point inside (or on the edge of) the convex counter-clockwise polygon?
bool Contains(std::span<const Vec2> polygon, Vec2 point);

}  // namespace ccmorse
