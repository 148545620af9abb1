#pragma once

namespace ccmorse {

inline constexpr double kPi = 3.14159265358979323846;

/// Radians from degrees.
constexpr double Radians(double degrees) { return degrees * (kPi / 180.0); }
/// Degrees from radians.
constexpr double Degrees(double radians) { return radians * (180.0 / kPi); }

struct SinCosPair {
  double sin = 0.0;
  double cos = 1.0;
};

/// Sine and cosine, the same bits on every x86-64 machine: the C library picks its own by CPU, and
/// the variants differ in the last bit, which would break the promise of equal runs. Within 2 ulp
/// of the true value for |angle| <= 1e5 rad; larger angles lose precision, from 1e15 on they count
/// as 0, NaN and infinity give NaN.
SinCosPair SinCos(double angle);

/// The angle in (-pi, pi] that points where `angle` does, rad; the same bits on every machine.
double NormalizeAngle(double angle);

/// atan2(y, x) within 1e-14 rad, the same bits on every machine; 0 for (0, 0).
double Atan2(double y, double x);

/// The angle whose sine is x, -1 < x < 1, rad; the same bits on every machine.
double ArcSine(double x);

/// Natural logarithm of a positive, normal number, within 2 ulp (or 1e-16 about 1), the same bits
/// on every machine.
double Log(double x);

/// e to the power of x within 4 ulp, the same bits on every machine: 0 below -700, and no larger
/// than at 700 above it.
double Exp(double x);

}  // namespace ccmorse
