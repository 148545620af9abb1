#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/pose.h"

namespace ccmorse::sim {

/// A running 64-bit hash of simulated state: not cryptographic, but any changed bit changes it.
/// Doubles count by their bits, so equal hashes mean equal runs, bit for bit.
class StateHash {
 public:
  StateHash() = default;
  /// As it was when its value() was this one: it goes on from there.
  static StateHash From(std::uint64_t value) {
    StateHash hash;
    hash.value_ = value;
    return hash;
  }

  void Add(std::uint64_t word) {
    value_ ^= word;
    value_ *= 0x9FB21C651E98DF25ULL;
    value_ ^= value_ >> 32;
  }
  void Add(double number) { Add(std::bit_cast<std::uint64_t>(number)); }
  void Add(const Vec3& v) {
    Add(v.x);
    Add(v.y);
    Add(v.z);
  }
  /// In four independent lanes, as a chain of multiplications would take longer than the scan.
  void Add(std::span<const double> numbers) {
    std::array<StateHash, 4> lanes;
    std::size_t i = 0;
    for (; i + lanes.size() <= numbers.size(); i += lanes.size()) {
      for (std::size_t lane = 0; lane < lanes.size(); ++lane) lanes[lane].Add(numbers[i + lane]);
    }
    for (; i < numbers.size(); ++i) lanes[0].Add(numbers[i]);
    for (const StateHash& lane : lanes) Add(lane.value());
  }
  void Add(std::string_view text) {
    Add(static_cast<std::uint64_t>(text.size()));
    for (const char c : text) Add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0x2545F4914F6CDD1DULL;
};

}  // namespace ccmorse::sim
