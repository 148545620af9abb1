#pragma once

#include <cmath>

#include "base/pose.h"

namespace ccmorse::render {

/// `v` in the length of 1. Precondition: it is not zero.
inline Vec3 Unit(const Vec3& v) { return (1.0 / std::sqrt(Dot(v, v))) * v; }

/// How bright a linear r, g, b is to the eye (ITU-R BT.709).
constexpr double Luminance(const Vec3& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

}  // namespace ccmorse::render
