#pragma once

#include <chrono>
#include <thread>

namespace ccmorse {

/// Whether it pays to stay awake for what will be there in some microseconds, as waking from sleep
/// takes tens of them. It does where a processor is idle. Where others want it, one that gives way
/// gets it back only after milliseconds, and it is better to sleep: who wakes goes first. One
/// thread.
class Wakefulness {
 public:
  using Clock = std::chrono::steady_clock;

  /// Is it worth it, as far as is known?
  bool Pays(Clock::time_point now) const { return now >= again_at_; }

  /// Gives way to others for a moment, and learns whether there are any.
  void GiveWay() {
    const auto before = Clock::now();
    std::this_thread::yield();
    const auto after = Clock::now();
    if (after - before > kOthers) again_at_ = after + kPatience;
  }

 private:
  // Nobody there: a microsecond. Somebody: at least a slice of the scheduler's time.
  static constexpr auto kOthers = std::chrono::microseconds(200);
  static constexpr auto kPatience = std::chrono::milliseconds(200);
  Clock::time_point again_at_{};
};

}  // namespace ccmorse
