#pragma once

// Player's conversions as macros (specs: player.md A.1).

#include <cmath>

#ifndef M_PI
#define M_PI 3.14159265358979323846
#endif

// NOLINTBEGIN(cppcoreguidelines-macro-usage): programs use these names as macros
/// Radians to degrees.
#define RTOD(r) ((r)*180.0 / M_PI)
/// Degrees to radians.
#define DTOR(d) ((d)*M_PI / 180.0)
/// The same angle, rad, between -pi and pi.
#define NORMALIZE(z) std::atan2(std::sin(z), std::cos(z))
// NOLINTEND(cppcoreguidelines-macro-usage)
