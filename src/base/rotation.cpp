#include "base/rotation.h"

#include "base/trig.h"

namespace ccmorse {

Rotation FromEuler(double roll, double pitch, double yaw) {
  const auto [sr, cr] = SinCos(roll);
  const auto [sp, cp] = SinCos(pitch);
  const auto [sy, cy] = SinCos(yaw);
  // 0 - sp, as -sp would make a negative zero of no pitch.
  return {{cy * cp, sy * cp, 0.0 - sp},
          {cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr},
          {cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr}};
}

}  // namespace ccmorse
