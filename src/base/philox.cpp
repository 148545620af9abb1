#include "base/philox.h"

#include <cmath>

#include "base/trig.h"

namespace ccmorse {
namespace {

std::uint32_t Low(std::uint64_t x) { return static_cast<std::uint32_t>(x); }
std::uint32_t High(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }

}  // namespace

std::array<std::uint32_t, 4> Philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {High(b) ^ counter[1] ^ key[0], Low(b), High(a) ^ counter[3] ^ key[1], Low(a)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return counter;
}

double OpenUniform(std::uint32_t high, std::uint32_t low) {
  const std::uint64_t bits = static_cast<std::uint64_t>(high) << 32 | low;
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

std::array<double, 2> GaussianPair(const std::array<std::uint32_t, 4>& bits) {
  const double radius = std::sqrt(-2.0 * Log(OpenUniform(bits[0], bits[1])));
  const auto [sine, cosine] = SinCos(2.0 * kPi * OpenUniform(bits[2], bits[3]));
  return {radius * cosine, radius * sine};
}

}  // namespace ccmorse
