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
  GeodeticPlace PlaceOf(const Vec3& world) const { return GeodeticFromEcef(ToEcef(world)); }
  /// The point of the world, m, that is there.
  Vec3 WorldPoint(const GeodeticPlace& place) const { return FromEcef(EcefFromGeodetic(place)); }

  /// Between the world and the frame of the Earth's centre, whose x goes through the equator at
  /// longitude 0 and whose z through the north pole; m.
  Vec3 ToEcef(const Vec3& world) const;
  Vec3 FromEcef(const Vec3& ecef) const;

  /// Between that frame and the ellipsoid. At a depth of more than 6000 km there is no answer.
  static GeodeticPlace GeodeticFromEcef(const Vec3& ecef);
  static Vec3 EcefFromGeodetic(const GeodeticPlace& place);

 private:
  struct Axes {
    Vec3 east, north, up;
  };
  Axes LocalAxes() const;

  SinCosPair turn_;  // of the world's x axis from east
  SinCosPair longitude_;
  SinCosPair latitude_;
  Vec3 origin_;  // m from the Earth's centre
};

}  // namespace ccmorse::sim
