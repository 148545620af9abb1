#include "sim/sensors/geodesy.h"

#include <cmath>

namespace ccmorse::sim {
namespace {

constexpr double kEquator = 6378137.0;  // m
constexpr double kEccentricity = 8.181919191e-2;
constexpr double kSquare = kEccentricity * kEccentricity;

}  // namespace

Geodesy::Geodesy(const scene::GeodesyDef& def)
    : turn_(SinCos(Radians(90.0 - def.angle_against_north))),
      longitude_(SinCos(Radians(def.longitude))),
      latitude_(SinCos(Radians(def.latitude))) {
  const double normal = kEquator / std::sqrt(1.0 - kSquare * latitude_.sin * latitude_.sin);
  const double out = (normal + def.altitude) * latitude_.cos;
  origin_ = {out * longitude_.cos, out * longitude_.sin,
             (normal * (1.0 - kSquare) + def.altitude) * latitude_.sin};
}

Vec3 Geodesy::ToEnu(const Vec3& world) const {
  return {turn_.cos * world.x - turn_.sin * world.y, turn_.sin * world.x + turn_.cos * world.y,
          world.z};
}

GeodeticPlace Geodesy::PlaceOf(const Vec3& world) const {
  const Vec3 enu = ToEnu(world);
  const auto [slon, clon] = longitude_;
  const auto [slat, clat] = latitude_;
  const Vec3 east{-slon, clon, 0.0};
  const Vec3 north{-slat * clon, -slat * slon, clat};
  const Vec3 up{clat * clon, clat * slon, slat};
  const Vec3 at = origin_ + enu.x * east + enu.y * north + enu.z * up;
  // Bowring's formula, again and again: near the ground each turn gains some ten digits.
  const double out = std::sqrt(at.x * at.x + at.y * at.y);
  const double flat = std::sqrt(1.0 - kSquare);  // polar by equatorial radius
  double reduced = Atan2(at.z, flat * out);
  double latitude = 0.0;
  for (int turn = 0; turn < 3; ++turn) {
    const auto [s, c] = SinCos(reduced);
    latitude =
        Atan2(at.z + kSquare / flat * kEquator * s * s * s, out - kSquare * kEquator * c * c * c);
    const SinCosPair found = SinCos(latitude);
    reduced = Atan2(flat * found.sin, found.cos);
  }
  const auto [s, c] = SinCos(latitude);
  const double altitude = out * c + at.z * s - kEquator * std::sqrt(1.0 - kSquare * s * s);
  return {Degrees(Atan2(at.y, at.x)), Degrees(latitude), altitude};
}

}  // namespace ccmorse::sim
