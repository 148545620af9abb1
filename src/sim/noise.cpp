#include "sim/noise.h"

#include <cmath>

#include "base/philox.h"
#include "base/trig.h"
#include "sim/state_hash.h"

namespace ccmorse::sim {
namespace {

std::uint32_t Low(std::uint64_t x) { return static_cast<std::uint32_t>(x); }
std::uint32_t High(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }

}  // namespace

Noise::Noise(std::uint64_t seed, std::string_view component) {
  StateHash hash;
  hash.Add(seed);
  hash.Add(component);
  key_ = {Low(hash.value()), High(hash.value())};
}

void Noise::AddGaussian(std::uint64_t tick, double deviation, double* numbers, std::size_t count,
                        std::uint32_t first) const {
  for (std::size_t i = 0; i < count; i += 2) {
    const auto sample = first + static_cast<std::uint32_t>(i);
    const auto bits = Philox({Low(tick), High(tick), sample, 0}, key_);
    // A pair by Box and Muller's transform.
    const double radius = deviation * std::sqrt(-2.0 * Log(OpenUniform(bits[0], bits[1])));
    const auto [sine, cosine] = SinCos(2.0 * kPi * OpenUniform(bits[2], bits[3]));
    numbers[i] += radius * cosine;
    if (i + 1 < count) numbers[i + 1] += radius * sine;
  }
}

std::array<double, 3> Noise::Shares() const {
  std::array<double, 3> shares{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    // The last word is 0 in what AddGaussian draws.
    const auto bits = Philox({i, 0, 0, 1}, key_);
    shares[i] = OpenUniform(bits[0], bits[1]);
  }
  return shares;
}

}  // namespace ccmorse::sim
