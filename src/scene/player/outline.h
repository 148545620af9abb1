#pragma once

#include <array>
#include <vector>

#include "base/pose.h"

namespace ccmorse::scene {

/// The polygon counter-clockwise, without corners that lie twice in one place or on a straight
/// side; empty where nothing with an area is left.
std::vector<Vec2> CleanPolygon(std::vector<Vec2> polygon);

/// Triangles that fill a simple polygon, counter-clockwise, by the indexes of its corners; empty
/// where the polygon crosses itself. Precondition: `polygon` is clean.
std::vector<std::array<int, 3>> Triangulate(const std::vector<Vec2>& polygon);

/// Convex polygons, counter-clockwise, that fill a simple polygon; its convex hull where it crosses
/// itself. Precondition: `polygon` is clean.
std::vector<std::vector<Vec2>> ConvexPieces(const std::vector<Vec2>& polygon);

/// The convex hull of the points with at most `corners` corners (4 or more); around the hull where
/// that has more. Turns left at every corner; empty where the points have no area.
std::vector<Vec2> HullOf(const std::vector<Vec2>& points, std::size_t corners);

/// Does it turn left at every corner? What a scenario asks of outlines.
bool IsStrictlyConvex(const std::vector<Vec2>& polygon);

}  // namespace ccmorse::scene
