#pragma once

#include "base/pose.h"
#include "base/rotation.h"

namespace ccmorse::render {

/// A pinhole camera. Its frame is that of MORSE's and Blender's cameras: it looks along -z, +x is
/// to the right of the picture and +y up.
struct Camera {
  Vec3 position;          ///< m
  Rotation rotation;      ///< of its frame in the world
  double fov_deg = 42.0;  ///< degrees, (0, 170): how much of the picture's height it sees

  /// A camera at `from` that looks at `at`, m, with the world's z up in the picture; straight up
  /// or down, the world's y is up. Throws Error when both are the same point.
  static Camera LookAt(const Vec3& from, const Vec3& at);

  /// Unit vector of the ray through a point of the picture: `right` and `up` from -1 to 1 between
  /// its lower and upper edge, `right` beyond that as the picture is wider than high.
  Vec3 Direction(double right, double up) const;
};

}  // namespace ccmorse::render
