#pragma once

#include <cmath>
#include <string>

// Programs and other headers have macros of these names.
#undef min
#undef max

namespace PlayerCc {

/// Player's port, and the host that clients ask by default (specs: player.md A.1).
const int PLAYER_PORTNUM = 6665;
const std::string PLAYER_HOSTNAME = "localhost";  // NOLINT(cert-err58-cpp): Player's own type

/// Radians to degrees.
inline double rtod(double radians) { return radians * 180.0 / 3.14159265358979323846; }
/// Degrees to radians.
inline double dtor(double degrees) { return degrees * 3.14159265358979323846 / 180.0; }
/// The same angle, rad, between -pi and pi.
inline double normalize(double angle) { return std::atan2(std::sin(angle), std::cos(angle)); }

/// The smaller of two.
template <typename T>
T min(T a, T b) {
  return a < b ? a : b;
}
/// The larger of two.
template <typename T>
T max(T a, T b) {
  return a > b ? a : b;
}
/// `a`, held between the two others.
template <typename T>
T limit(T a, T min, T max) {
  if (a < min) return min;
  return a > max ? max : a;
}

}  // namespace PlayerCc
