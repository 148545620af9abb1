#pragma once

#include <cmath>

#include "base/pose.h"
#include "base/rotation.h"
#include "base/trig.h"

namespace ccmorse::sim {

/// Roll, pitch and yaw (rad) that FromEuler() makes this rotation of: roll and yaw in (-pi, pi],
/// pitch in [-pi/2, pi/2]. The same bits on every machine (specs: morse.md H.3).
inline Vec3 EulerOf(const Rotation& r) {
  const double level = std::sqrt(r.x.x * r.x.x + r.x.y * r.x.y);
  return {Atan2(r.y.z, r.z.z), Atan2(-r.x.z, level), Atan2(r.x.y, r.x.x)};
}

/// What is turned by `inner` in a frame that is turned by `outer`.
constexpr Rotation Combined(const Rotation& outer, const Rotation& inner) {
  return {Rotate(outer, inner.x), Rotate(outer, inner.y), Rotate(outer, inner.z)};
}

}  // namespace ccmorse::sim
