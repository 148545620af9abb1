#include "sim/modifiers/coordinates.h"

#include <cmath>
#include <functional>
#include <utility>

#include "base/error.h"
#include "base/trig.h"
#include "sim/modifiers/settings.h"
#include "sim/sensors/geodesy.h"

namespace ccmorse::sim {
namespace {

constexpr double kFeet = 3.2808399;      // of a metre, as MORSE counts (specs: morse.md B.5)
constexpr double kFarthestOrigin = 1e9;  // m

using Change = std::function<Vec3(const Vec3&)>;

// x, y and z in other coordinates.
class PlaceModifier : public Modifier {
 public:
  explicit PlaceModifier(Change change) : change_(std::move(change)) {}

  void Apply(std::span<const DataField> data, const Instant& /*now*/) override {
    double* const x = FindNumber(data, "x");
    double* const y = FindNumber(data, "y");
    double* const z = FindNumber(data, "z");
    if (x == nullptr || y == nullptr || z == nullptr) return;
    const Vec3 changed = change_({*x, *y, *z});
    *x = changed.x;
    *y = changed.y;
    *z = changed.z;
  }

 private:
  Change change_;
};

// Also of what has angles only.
class NedModifier : public PlaceModifier {
 public:
  explicit NedModifier(bool inwards)
      : PlaceModifier([](const Vec3& at) {
          return Vec3{at.y, at.x, -at.z};
        }),
        inwards_(inwards) {}

  void Apply(std::span<const DataField> data, const Instant& now) override {
    PlaceModifier::Apply(data, now);
    double* const yaw = FindNumber(data, "yaw");
    double* const pitch = FindNumber(data, "pitch");
    double* const roll = FindNumber(data, "roll");
    if (yaw == nullptr || pitch == nullptr || roll == nullptr) return;
    if (FindNumber(data, "x") != nullptr) return;  // MORSE changes either places or angles
    const double before = *yaw;
    *yaw = inwards_ ? kPi / 2.0 - *roll : *roll;
    *roll = inwards_ ? before : kPi / 2.0 - before;
    *pitch = -*pitch;
  }

 private:
  bool inwards_;
};

Vec3 AsVector(const GeodeticPlace& place) {
  return {place.longitude, place.latitude, place.altitude};
}

Vec3 ToGeocentric(const Vec3& ecef) {
  const double out = std::sqrt(ecef.x * ecef.x + ecef.y * ecef.y);
  return {Degrees(Atan2(ecef.y, ecef.x)), Degrees(Atan2(ecef.z, out)), std::sqrt(Dot(ecef, ecef))};
}

Vec3 FromGeocentric(const Vec3& at) {
  const auto [slon, clon] = SinCos(Radians(at.x));
  const auto [slat, clat] = SinCos(Radians(at.y));
  return {at.z * clat * clon, at.z * clat * slon, at.z * slat};
}

Geodesy GeodesyOf(const Component& component, const scene::ModifierDef& def,
                  const scene::Scenario& scenario) {
  const ModifierSettings settings(component.full_name(), def);
  const bool given =
      settings.Has("longitude") && settings.Has("latitude") && settings.Has("altitude");
  if (!scenario.geodesy && !given) {
    throw Error("the modifier " + def.type + " of " + component.full_name() +
                " needs to know where on the Earth the world lies: set longitude, latitude and "
                "altitude of the environment");
  }
  scene::GeodesyDef place = scenario.geodesy.value_or(scene::GeodesyDef{});
  place.longitude = settings.Number("longitude", place.longitude, -180.0, 180.0);
  place.latitude = settings.Number("latitude", place.latitude, -90.0, 90.0);
  place.altitude = settings.Number("altitude", place.altitude, -12000.0, 1e6);
  place.angle_against_north =
      settings.Number("angle_against_north", place.angle_against_north, -360.0, 360.0);
  return Geodesy(place);
}

Change GeodesyChange(const std::string& type, const Geodesy& earth, bool inwards) {
  if (type == "ECEF") {
    if (inwards) return [earth](const Vec3& at) { return earth.FromEcef(at); };
    return [earth](const Vec3& at) { return earth.ToEcef(at); };
  }
  if (type == "geodetic") {
    if (inwards) {
      return [earth](const Vec3& at) { return earth.WorldPoint({at.x, at.y, at.z}); };
    }
    return [earth](const Vec3& at) { return AsVector(earth.PlaceOf(at)); };
  }
  if (inwards) return [earth](const Vec3& at) { return earth.FromEcef(FromGeocentric(at)); };
  return [earth](const Vec3& at) { return ToGeocentric(earth.ToEcef(at)); };
}

}  // namespace

std::unique_ptr<Modifier> MakeCoordinateModifier(const Component& component,
                                                 const scene::ModifierDef& def,
                                                 const scene::Scenario& scenario) {
  const bool inwards = dynamic_cast<const Actuator*>(&component) != nullptr;
  if (def.type == "NED") return std::make_unique<NedModifier>(inwards);
  if (def.type == "feet") {
    const double factor = inwards ? 1.0 / kFeet : kFeet;
    return std::make_unique<PlaceModifier>([factor](const Vec3& at) { return factor * at; });
  }
  if (def.type == "UTM") {
    const ModifierSettings settings(component.full_name(), def);
    const Vec3 offset{settings.Number("x_offset", 0.0, -kFarthestOrigin, kFarthestOrigin),
                      settings.Number("y_offset", 0.0, -kFarthestOrigin, kFarthestOrigin),
                      settings.Number("z_offset", 0.0, -kFarthestOrigin, kFarthestOrigin)};
    const double sign = inwards ? -1.0 : 1.0;
    return std::make_unique<PlaceModifier>(
        [offset, sign](const Vec3& at) { return at + sign * offset; });
  }
  if (def.type == "ECEF" || def.type == "geodetic" || def.type == "geocentric") {
    const Geodesy earth = GeodesyOf(component, def, scenario);
    return std::make_unique<PlaceModifier>(GeodesyChange(def.type, earth, inwards));
  }
  return nullptr;
}

}  // namespace ccmorse::sim
