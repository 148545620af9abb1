#pragma once

#include <vector>

#include "base/pose.h"

namespace ccmorse {

/// The convex hull of points in the plane, counter-clockwise, without needless corners; fewer than
/// three points where they have no area (Andrew's monotone chain, 1979).
std::vector<Vec2> ConvexHull(std::vector<Vec2> points);

}  // namespace ccmorse
