#include "client/core/vigil.h"

#include <gtest/gtest.h>

#include <chrono>

namespace {

using CCMorse::core::Vigil;
using Clock = Vigil::Clock;
using std::chrono::milliseconds;

constexpr Clock::time_point kNothing{};

TEST(Vigil, ItSleepsUntilShortlyBeforeDataAreExpected) {
  Vigil vigil;
  const auto expected = Clock::now() + std::chrono::seconds(10);
  vigil.Begin(expected + milliseconds(100), expected);
  EXPECT_LT(vigil.sleep_until(), expected);
  EXPECT_GT(vigil.sleep_until(), expected - milliseconds(1));
}

TEST(Vigil, ItIsAwakeAroundTheTimeAtWhichDataAreExpectedAndThenSleepsToTheEnd) {
  Vigil vigil;
  const auto expected = Clock::now();
  const auto until = expected + milliseconds(200);
  vigil.Begin(until, expected);
  while (vigil.StaysAwake()) {
  }
  EXPECT_GT(Clock::now(), expected + std::chrono::microseconds(150));
  EXPECT_EQ(vigil.sleep_until(), until);
}

TEST(Vigil, NoWaitIsLongerThanAskedFor) {
  Vigil vigil;
  const auto until = Clock::now() + std::chrono::microseconds(30);
  vigil.Begin(until, Clock::now() + std::chrono::seconds(10));
  while (vigil.StaysAwake()) ASSERT_LT(Clock::now(), until + milliseconds(500));
  EXPECT_EQ(vigil.sleep_until(), until);
  // What is expected never does not keep it awake.
  vigil.Begin(Clock::now() - milliseconds(1), kNothing);
  EXPECT_FALSE(vigil.StaysAwake());
}

}  // namespace
