#include "base/euler.h"

#include <cmath>

#include "base/trig.h"

namespace ccmorse {
namespace {

constexpr double kUpright = 1e-9;  // the cosine of pitch below which x points up or down

}  // namespace

Vec3 ToEuler(const Rotation& rotation) {
  const Vec3& x = rotation.x;
  const double level = std::sqrt(x.x * x.x + x.y * x.y);
  const double pitch = Atan2(0.0 - x.z, level);
  if (level < kUpright) return {0.0, pitch, Atan2(0.0 - rotation.y.x, rotation.y.y)};
  return {Atan2(rotation.y.z, rotation.z.z), pitch, Atan2(x.y, x.x)};
}

Rotation Combined(const Rotation& outer, const Rotation& inner) {
  return {Rotate(outer, inner.x), Rotate(outer, inner.y), Rotate(outer, inner.z)};
}

}  // namespace ccmorse
