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
      latitude_(SinCos(Radians(def.latitude))),
      origin_(EcefFromGeodetic({def.longitude, def.latitude, def.altitude})) {}

Vec3 Geodesy::EcefFromGeodetic(const GeodeticPlace& place) {
  const auto [slon, clon] = SinCos(Radians(place.longitude));
  const auto [slat, clat] = SinCos(Radians(place.latitude));
  const double normal = kEquator / std::sqrt(1.0 - kSquare * slat * slat);
  const double out = (normal + place.altitude) * clat;
  return {out * clon, out * slon, (normal * (1.0 - kSquare) + place.altitude) * slat};
}

Vec3 Geodesy::ToEnu(const Vec3& world) const {
  return {turn_.cos * world.x - turn_.sin * world.y, turn_.sin * world.x + turn_.cos * world.y,
          world.z};
}

Geodesy::Axes Geodesy::LocalAxes() const {
  const auto [slon, clon] = longitude_;
  const auto [slat, clat] = latitude_;
  return {{-slon, clon, 0.0}, {-slat * clon, -slat * slon, clat}, {clat * clon, clat * slon, slat}};
}

Vec3 Geodesy::ToEcef(const Vec3& world) const {
  const Vec3 enu = ToEnu(world);
  const Axes axes = LocalAxes();
  return origin_ + enu.x * axes.east + enu.y * axes.north + enu.z * axes.up;
}

Vec3 Geodesy::FromEcef(const Vec3& ecef) const {
  const Vec3 off = ecef - origin_;
  const Axes axes = LocalAxes();
  const double east = Dot(off, axes.east);
  const double north = Dot(off, axes.north);
  return {turn_.cos * east + turn_.sin * north, turn_.cos * north - turn_.sin * east,
          Dot(off, axes.up)};
}

GeodeticPlace Geodesy::GeodeticFromEcef(const Vec3& ecef) {
  const Vec3& at = ecef;
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
