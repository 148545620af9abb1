#include "base/trig.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <random>

namespace ccmorse {
namespace {

TEST(Trig, SineAndCosineAgreeWithTheCLibraryInLongDouble) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> angles(-1e5, 1e5);
  std::uniform_real_distribution<double> small(-7.0, 7.0);
  for (int i = 0; i < 200000; ++i) {
    const double angle = i % 2 == 0 ? angles(random) : small(random);
    const auto [s, c] = SinCos(angle);
    ASSERT_NEAR(s, static_cast<double>(std::sin(static_cast<long double>(angle))), 3e-16) << angle;
    ASSERT_NEAR(c, static_cast<double>(std::cos(static_cast<long double>(angle))), 3e-16) << angle;
  }
}

TEST(Trig, LogAgreesWithTheCLibraryInLongDouble) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> exponents(-700.0, 700.0);
  std::uniform_real_distribution<double> near_one(0.5, 2.0);
  for (int i = 0; i < 200000; ++i) {
    const double x = i % 2 == 0 ? std::exp(exponents(random)) : near_one(random);
    const auto expected = static_cast<double>(std::log(static_cast<long double>(x)));
    ASSERT_NEAR(Log(x), expected, 1e-16 + 4.5e-16 * std::fabs(expected)) << x;
  }
  EXPECT_EQ(Log(1.0), 0.0);
}

TEST(Trig, Atan2AgreesWithTheCLibrary) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> part(-10.0, 10.0);
  for (int i = 0; i < 100000; ++i) {
    const double y = part(random);
    const double x = i % 10 == 0 ? 0.0 : part(random);
    ASSERT_NEAR(Atan2(y, x), std::atan2(y, x), 1e-14) << y << " " << x;
  }
  EXPECT_EQ(Atan2(0.0, 0.0), 0.0);
  EXPECT_NEAR(Atan2(0.0, -1.0), kPi, 1e-15);
}

TEST(Trig, NormalizedAnglesPointTheSameWay) {
  EXPECT_TRUE(rc::check("same direction, in (-pi, pi]", [] {
    const double angle =
        *rc::gen::map(rc::gen::inRange(-1000000, 1000000), [](int n) { return n * 1e-4; });
    const double normal = NormalizeAngle(angle);
    RC_ASSERT(normal > -kPi && normal <= kPi);
    RC_ASSERT(std::abs(std::remainder(normal - angle, 2 * kPi)) < 1e-12);
  }));
  EXPECT_EQ(NormalizeAngle(-kPi), kPi);
}

TEST(Trig, WhatIsNoAngleStaysNoAngle) {
  EXPECT_TRUE(std::isnan(SinCos(std::nan("")).sin));
  EXPECT_TRUE(std::isnan(SinCos(INFINITY).cos));
}

TEST(Trig, ExpAgreesWithTheCLibrary) {
  for (int i = -70000; i <= 70000; ++i) {
    const double x = 0.01 * i;
    ASSERT_NEAR(Exp(x) / std::exp(x), 1.0, 1e-15) << x;
  }
  EXPECT_EQ(Exp(0.0), 1.0);
  EXPECT_EQ(Exp(-701.0), 0.0);
  EXPECT_EQ(Exp(-INFINITY), 0.0);
  EXPECT_EQ(Exp(INFINITY), Exp(700.0));
  EXPECT_TRUE(std::isnan(Exp(std::nan(""))));
}

}  // namespace
}  // namespace ccmorse
