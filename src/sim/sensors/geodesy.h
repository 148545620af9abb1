#pragma once

#include "base/pose.h"
#include "base/trig.h"
#include "scene/scenario.h"

namespace ccmorse::sim {

/// A place on the Earth.
struct GeodeticPlace {
  double longitude = 0.0;  ///< degrees, positive east
  double latitude = 0.0;   ///< degrees, positive north
  double altitude = 0.0;   ///< m above the ellipsoid
};

/// Where places of the world lie on the Earth: a local tangent plane (east, north, up) at the
/// world's origin, on the ellipsoid of MORSE's numbers (specs: morse.md B.5, "Geodesy"). In double
/// throughout: within 1e-6 m. Any number of threads may ask.
class Geodesy {
 public:
  explicit Geodesy(const scene::GeodesyDef& def);

  /// A vector of the world as east, north, up.
  Vec3 ToEnu(const Vec3& world) const;
  /// Where the point of the world, m, is.
  GeodeticPlace PlaceOf(const Vec3& world) const;

 private:
  SinCosPair turn_;  // of the world's x axis from east
  SinCosPair longitude_;
  SinCosPair latitude_;
  Vec3 origin_;  // m from the Earth's centre
};

}  // namespace ccmorse::sim
