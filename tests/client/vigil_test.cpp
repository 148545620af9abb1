#include "client/core/vigil.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>

#include "client/core/rhythm.h"

namespace {

using CCMorse::core::Rhythm;
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

using std::chrono::microseconds;
constexpr auto kTick = microseconds(16667);
const Clock::time_point kStart = Clock::time_point{} + std::chrono::hours(1);

TEST(Rhythm, NothingIsExpectedBeforeSomethingCameTwice) {
  Rhythm rhythm;
  EXPECT_EQ(rhythm.expected(), kNothing);
  rhythm.Came(kStart);
  EXPECT_EQ(rhythm.expected(), kStart);
  rhythm.Came(kStart + kTick);
  EXPECT_EQ(rhythm.expected(), kStart + 2 * kTick);
}

TEST(Rhythm, WhatIsLateByNowAndThenDoesNotMoveTheTimeAtWhichDataAreExpected) {
  Rhythm rhythm;
  std::uint32_t state = 1;
  for (int i = 0; i < 1000; ++i) {
    state = state * 1664525U + 1013904223U;
    // One in eight is late by up to 400 us, the others by up to 30.
    const auto late = microseconds((state >> 8U) % ((state >> 29U) == 0 ? 400 : 30));
    rhythm.Came(kStart + i * kTick + late);
    if (i < 100) continue;
    EXPECT_GT(rhythm.expected(), kStart + (i + 1) * kTick - microseconds(150)) << i;
    EXPECT_LT(rhythm.expected(), kStart + (i + 1) * kTick + microseconds(150)) << i;
  }
}

TEST(Rhythm, AClockThatGoesDifferentlyIsFollowed) {
  Rhythm rhythm;
  const auto interval = kTick + microseconds(5);
  for (int i = 0; i < 200; ++i) rhythm.Came(kStart + i * (i < 100 ? kTick : interval));
  EXPECT_LT(std::chrono::abs(rhythm.expected() - (kStart + 200 * interval)), microseconds(20));
}

TEST(Rhythm, AfterABreakItBeginsAnew) {
  Rhythm rhythm;
  for (int i = 0; i < 10; ++i) rhythm.Came(kStart + i * kTick);
  const auto later = kStart + std::chrono::seconds(10);
  for (int i = 0; i < 3; ++i) rhythm.Came(later + i * kTick);
  EXPECT_EQ(rhythm.expected(), later + 3 * kTick);
}

}  // namespace
