#include "sim/sensors/magnetic_field.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/trig.h"

namespace ccmorse::sim {
namespace {

constexpr int kSize = scene::kMostMagneticDegree + 1;
constexpr double kReference = 6371200.0;  // m, the radius that the terms are for

// Numbers by degree and order.
class Table {
 public:
  double& operator()(int n, int m) { return numbers_[At(n, m)]; }
  double operator()(int n, int m) const { return numbers_[At(n, m)]; }

 private:
  static std::size_t At(int n, int m) {
    return static_cast<std::size_t>(n) * kSize + static_cast<std::size_t>(m);
  }

  std::array<double, std::size_t{kSize} * kSize> numbers_{};
};

// Schmidt's half normalized associated Legendre functions of cos(colatitude), p; their derivatives
// by colatitude, dp; and p / sin(colatitude) for orders from 1 on, q, which exists at the poles.
struct Legendre {
  Table p;
  Table dp;
  Table q;
};

void Compute(Legendre& of, double sine, double cosine, int degree) {
  Table& p = of.p;
  Table& dp = of.dp;
  Table& q = of.q;
  p(0, 0) = 1.0;
  for (int n = 1; n <= degree; ++n) {
    const double diagonal = n == 1 ? 1.0 : std::sqrt((2.0 * n - 1.0) / (2.0 * n));
    p(n, n) = diagonal * sine * p(n - 1, n - 1);
    dp(n, n) = diagonal * (sine * dp(n - 1, n - 1) + cosine * p(n - 1, n - 1));
    q(n, n) = n == 1 ? 1.0 : diagonal * sine * q(n - 1, n - 1);
    for (int m = 0; m < n; ++m) {
      const double before = n >= 2 ? std::sqrt((n - 1.0) * (n - 1.0) - 1.0 * m * m) : 0.0;
      const double scale = 1.0 / std::sqrt(1.0 * n * n - 1.0 * m * m);
      const double twice = 2.0 * n - 1.0;
      const auto older = [&](const Table& table) { return n >= 2 ? table(n - 2, m) : 0.0; };
      p(n, m) = scale * (twice * cosine * p(n - 1, m) - before * older(p));
      dp(n, m) =
          scale * (twice * (cosine * dp(n - 1, m) - sine * p(n - 1, m)) - before * older(dp));
      if (m > 0) q(n, m) = scale * (twice * cosine * q(n - 1, m) - before * older(q));
    }
  }
}

}  // namespace

MagneticField::MagneticField(const scene::MagneticFieldDef& def) : def_(def) {
  for (const scene::MagneticTerm& term : def_.terms) degree_ = std::max(degree_, term.degree);
}

Vec3 MagneticField::NorthEastDown(const GeodeticPlace& place, double year) const {
  const Vec3 at = Geodesy::EcefFromGeodetic({0.0, place.latitude, place.altitude});
  const double radius = std::sqrt(at.x * at.x + at.z * at.z);
  // Of the direction from the Earth's centre: colatitude.
  const double sine = at.x / radius;
  const double cosine = at.z / radius;
  Legendre legendre;
  Compute(legendre, sine, cosine, degree_);
  std::array<double, kSize> shrinks{};  // (reference / radius)^(n + 2)
  const double ratio = kReference / radius;
  shrinks[0] = ratio * ratio;
  for (std::size_t n = 1; n < shrinks.size(); ++n) shrinks[n] = shrinks[n - 1] * ratio;
  Vec3 field;  // north, east, down of the sphere
  for (const scene::MagneticTerm& term : def_.terms) {
    const int n = term.degree;
    const int m = term.order;
    const double years = year - def_.epoch;
    const double g = term.g + years * term.g_rate;
    const double h = term.h + years * term.h_rate;
    const auto [s, c] = SinCos(m * Radians(place.longitude));
    const double shrink = shrinks[static_cast<std::size_t>(n)];
    field.x += shrink * (g * c + h * s) * legendre.dp(n, m);
    field.y += shrink * m * (g * s - h * c) * legendre.q(n, m);
    field.z -= shrink * (n + 1) * (g * c + h * s) * legendre.p(n, m);
  }
  // The ellipsoid's down is not the sphere's.
  const auto [slat, clat] = SinCos(Radians(place.latitude));
  const double turn_sine = cosine * clat - sine * slat;  // of geocentric less geodetic latitude
  const double turn_cosine = sine * clat + cosine * slat;
  return {field.x * turn_cosine - field.z * turn_sine, field.y,
          field.x * turn_sine + field.z * turn_cosine};
}

}  // namespace ccmorse::sim
