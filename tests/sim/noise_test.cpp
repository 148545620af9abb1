#include "sim/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/philox.h"
#include "scene/scenario.h"
#include "sim/sensors/laser_scanner.h"
#include "sim/simulation.h"

namespace ccmorse::sim {
namespace {

using Block = std::array<std::uint32_t, 4>;

TEST(Noise, PhiloxGivesItsAuthorsKnownAnswers) {
  EXPECT_EQ(Philox({0, 0, 0, 0}, {0, 0}), (Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(Philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(Philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

std::vector<double> Sample(const Noise& noise, std::uint64_t tick, std::size_t count) {
  std::vector<double> numbers(count);
  noise.AddGaussian(tick, 1.0, numbers.data(), count);
  return numbers;
}

TEST(Noise, IsNormallyDistributed) {
  // A million numbers of one fixed seed: mean, spread, tails and the largest gap between the
  // empirical and the true distribution function (Kolmogorov and Smirnov; 1.95 / sqrt(n) is passed
  // by chance once in a thousand seeds).
  constexpr std::size_t kCount = 1'000'000;
  std::vector<double> numbers = Sample(Noise(7, "s1r.hokuyo"), 0, kCount);
  std::sort(numbers.begin(), numbers.end());
  double gap = 0.0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const double expected = 0.5 * std::erfc(-numbers[i] / std::sqrt(2.0));
    gap = std::max(gap, std::fabs(expected - (static_cast<double>(i) + 0.5) / kCount));
  }
  EXPECT_LT(gap, 1.95 / std::sqrt(static_cast<double>(kCount)));
  EXPECT_GT(numbers.back(), 4.0);
  EXPECT_LT(numbers.back(), 7.0);
}

TEST(Noise, DependsOnSeedComponentTickAndSampleAlone) {
  const Noise noise(1, "a.laser");
  EXPECT_EQ(Sample(noise, 5, 10), Sample(Noise(1, "a.laser"), 5, 10));
  EXPECT_NE(Sample(noise, 5, 10), Sample(noise, 6, 10));
  EXPECT_NE(Sample(noise, 5, 10), Sample(Noise(2, "a.laser"), 5, 10));
  EXPECT_NE(Sample(noise, 5, 10), Sample(Noise(1, "b.laser"), 5, 10));
  std::vector<double> later(4);
  noise.AddGaussian(5, 1.0, later.data(), 4, 6);
  const std::vector<double> all = Sample(noise, 5, 10);
  EXPECT_TRUE(std::equal(later.begin(), later.end(), all.begin() + 6));
}

std::vector<double> Ranges(const std::string& seed, int ticks) {
  Simulation simulation(scene::ParseScenario(
      R"({"seed": )" + seed + R"(, "robots": [{"laser": {"range_std": 0.02}}]})", "test.json"));
  for (int i = 0; i < ticks; ++i) {
    simulation.Sense();
    simulation.Act();
  }
  return dynamic_cast<LaserScanner*>(simulation.FindComponent("s1r.hokuyo"))->ranges();
}

TEST(Noise, TheScenariosSeedAndSpreadMakeTheScannersNoise) {
  Simulation exact(scene::ParseScenario("{}", "test.json"));
  exact.Sense();
  const auto& truth = dynamic_cast<LaserScanner*>(exact.FindComponent("s1r.hokuyo"))->ranges();
  const std::vector<double> noisy = Ranges("1", 1);
  EXPECT_EQ(noisy, Ranges("1", 1));
  EXPECT_NE(noisy, Ranges("2", 1));
  EXPECT_NE(noisy, Ranges("1", 7)) << "the robot stands still, yet the next scan has other noise";
  double squares = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    squares += (noisy[i] - truth[i]) * (noisy[i] - truth[i]);
  }
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(truth.size())), 0.02, 0.002);
}

TEST(Noise, ABeamWithoutAHitHasNone) {
  Simulation simulation(scene::ParseScenario(
      R"({"robots": [{"laser": {"range": 0.3, "range_std": 0.02}}]})", "test.json"));
  simulation.Sense();
  const auto& ranges =
      dynamic_cast<LaserScanner*>(simulation.FindComponent("s1r.hokuyo"))->ranges();
  EXPECT_GT(std::count(ranges.begin(), ranges.end(), 0.3), 100);
  EXPECT_TRUE(std::all_of(ranges.begin(), ranges.end(), [](double range) { return range <= 0.3; }));
}

TEST(Noise, ThePoseIsNoisyWhenTheScenarioSaysSo) {
  Simulation simulation(scene::ParseScenario(
      R"({"robots": [{"pose_noise": {"pos_std": 0.1, "rot_std": 0.05}}]})", "test.json"));
  simulation.Sense();
  const Json data = Json::Parse(simulation.FindComponent("s1r.pose")->LocalData());
  const Pose2 pose = simulation.robots()[0]->pose();
  EXPECT_NE(data.Find("x")->AsDouble(), pose.x);
  EXPECT_NE(data.Find("y")->AsDouble(), pose.y);
  EXPECT_NE(data.Find("yaw")->AsDouble(), pose.yaw);
  EXPECT_NEAR(data.Find("x")->AsDouble(), pose.x, 0.6);
}

}  // namespace
}  // namespace ccmorse::sim
