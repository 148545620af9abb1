#pragma once

#include <cstddef>

namespace ccmorse::scene {

// What every kind of scene file may ask for, whatever format it has.

/// m from the origin, and the longest edge of a floor; more is a mistake in the unit.
inline constexpr double kFarthest = 1000.0;

/// The largest id of an object.
inline constexpr int kLastId = 1'000'000;

/// Corners of a robot's outline: what the simulator moves at once (sim/physics/kinematics.h).
inline constexpr std::size_t kFootprintCorners = 16;

}  // namespace ccmorse::scene
