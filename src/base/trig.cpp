#include "base/trig.h"

#include <algorithm>
#include <cmath>

namespace ccmorse {
namespace {

// pi/2 in three parts, the first two with enough trailing zero bits that k * part is exact for
// |k| < 2^20 (Cody and Waite's reduction).
constexpr double kHalfPiHigh = 1.57079632673412561417e+00;
constexpr double kHalfPiMiddle = 6.07710050630396597660e-11;
constexpr double kHalfPiLow = 2.02226624879595063154e-21;
constexpr double kLargest = 1e15;  // rad; the spacing of doubles there is a tenth of a radian

// Taylor polynomials: on |x| <= pi/4 the first term left out is below 1e-19.
double SinKernel(double x) {
  const double z = x * x;
  double p = 1.0 / 355687428096000.0;  // 1/17!
  p = p * z - 1.0 / 1307674368000.0;
  p = p * z + 1.0 / 6227020800.0;
  p = p * z - 1.0 / 39916800.0;
  p = p * z + 1.0 / 362880.0;
  p = p * z - 1.0 / 5040.0;
  p = p * z + 1.0 / 120.0;
  p = p * z - 1.0 / 6.0;
  return x + x * z * p;
}

double CosKernel(double x) {
  const double z = x * x;
  double p = -1.0 / 6402373705728000.0;  // 1/18!
  p = p * z + 1.0 / 20922789888000.0;
  p = p * z - 1.0 / 87178291200.0;
  p = p * z + 1.0 / 479001600.0;
  p = p * z - 1.0 / 3628800.0;
  p = p * z + 1.0 / 40320.0;
  p = p * z - 1.0 / 720.0;
  p = p * z + 1.0 / 24.0;
  const double half = 0.5 * z;
  const double rough = 1.0 - half;
  return rough + (((1.0 - rough) - half) + z * z * p);  // keeps the bits that 1 - z/2 rounds away
}

// To the nearest whole number, ties to even, without a call into the C library; what is beyond
// 2^51 has only few bits behind the point and stays as it is.
double RoundToEven(double x) {
  constexpr double kShift = 0x1.8p52;
  if (!(std::fabs(x) < 0x1p51)) return x;
  const double shifted = x + kShift;
  return shifted - kShift;
}

}  // namespace

SinCosPair SinCos(double angle) {
  if (!(std::fabs(angle) < kLargest)) {
    // Infinity and NaN give NaN; far beyond all angles there are, any pair on the circle is right.
    return std::isfinite(angle) ? SinCosPair{} : SinCosPair{angle - angle, angle - angle};
  }
  const double quarter = RoundToEven(angle * (2.0 / kPi));
  const double x =
      ((angle - quarter * kHalfPiHigh) - quarter * kHalfPiMiddle) - quarter * kHalfPiLow;
  const double s = SinKernel(x);
  const double c = CosKernel(x);
  switch (static_cast<long long>(quarter) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double NormalizeAngle(double angle) {
  if (angle > -kPi && angle <= kPi) return angle;
  const double wrapped =
      std::remainder(angle, 2.0 * kPi);  // exact by IEEE 754: no library variants
  return wrapped <= -kPi ? kPi : wrapped;
}

double Log(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // exact: no library variants
  if (m < 0.70710678118654752) {
    m *= 2.0;
    --exponent;
  }
  // log m = 2 atanh((m - 1) / (m + 1)); |s| <= 0.1716, so the first term left out is below 1e-18.
  const double s = (m - 1.0) / (m + 1.0);
  const double z = s * s;
  double p = 1.0 / 23.0;
  for (double odd = 21.0; odd > 2.0; odd -= 2.0) {
    p = p * z + 1.0 / odd;
  }
  constexpr double kLn2High = 6.93147180369123816490e-01;  // its last 32 bits are 0
  constexpr double kLn2Low = 1.90821492927058770002e-10;
  return exponent * kLn2High + (2.0 * s + (2.0 * s * z * p + exponent * kLn2Low));
}

double Atan2(double y, double x) {
  const double ax = std::fabs(x);
  const double ay = std::fabs(y);
  const double larger = ax > ay ? ax : ay;
  if (larger == 0.0) return 0.0;
  // Rough angle first (error below 0.01 rad), then one Newton-like correction with our own sine:
  // for the true angle a and the estimate e, asin of cross(e, a) is a - e up to its cube.
  const double ratio = (ax < ay ? ax : ay) / larger;
  double estimate = ratio * (kPi / 4.0 + 0.273 * (1.0 - ratio));
  if (ay > ax) estimate = kPi / 2.0 - estimate;
  if (x < 0.0) estimate = kPi - estimate;
  if (y < 0.0) estimate = -estimate;
  const double norm = std::sqrt(x * x + y * y);
  for (int i = 0; i < 2; ++i) {
    const SinCosPair e = SinCos(estimate);
    const double d = (y * e.cos - x * e.sin) / norm;
    estimate += d + d * d * d / 6.0 + 3.0 * d * d * d * d * d / 40.0;
  }
  return estimate;
}

double ArcSine(double x) { return Atan2(x, std::sqrt(1.0 - x * x)); }

double Exp(double x) {
  if (!(x >= -700.0)) return x < -700.0 ? 0.0 : x;  // NaN stays NaN
  x = std::min(x, 700.0);
  // x = k ln 2 + r with |r| <= ln 2 / 2; ln 2 in two parts, of which k times the first is exact.
  constexpr double kLn2High = 0x1.62e42fee00000p-1;
  constexpr double kLn2Low = 0x1.a39ef35793c76p-33;
  const double k = std::floor(x * 1.4426950408889634 + 0.5);
  const double r = (x - k * kLn2High) - k * kLn2Low;
  double sum = 1.0;  // Taylor's series by Horner; the 14th term is below 2^-56
  for (int n = 13; n >= 1; --n) sum = 1.0 + sum * r / n;
  return std::ldexp(sum, static_cast<int>(k));
}

}  // namespace ccmorse
