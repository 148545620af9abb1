#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ccmorse::sim {

/// The noise of one component. It has no state: a number depends on (seed, component, tick, sample)
/// alone, so it is the same whoever asks, in whatever order (design: Determinism). Thread safe.
class Noise {
 public:
  Noise(std::uint64_t seed, std::string_view component);

  /// Adds to each of `count` numbers a normally distributed one of that standard deviation; number
  /// i is the tick's sample `first` + i. `first` is even.
  void AddGaussian(std::uint64_t tick, double deviation, double* numbers, std::size_t count,
                   std::uint32_t first = 0) const;

  /// Three numbers of (0, 1) that a run draws once, independent of those of AddGaussian.
  std::array<double, 3> Shares() const;

 private:
  std::array<std::uint32_t, 2> key_;
};

}  // namespace ccmorse::sim
