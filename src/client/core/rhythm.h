#pragma once

#include <chrono>

namespace CCMorse::core {

/// When the next of what comes at regular intervals is expected, from when the last came. What
/// comes is late by now and then and never early, so a time that is earlier than expected counts
/// wholly and a later one by a part; one that is far off begins anew. One thread at a time.
class Rhythm {
 public:
  using Clock = std::chrono::steady_clock;

  /// Something came at `now`.
  void Came(Clock::time_point now) {
    const auto off = now - next_;
    if (std::chrono::abs(off) > interval_ / kFarOff) {
      interval_ = last_ == Clock::time_point{} ? Clock::duration{} : now - last_;
      next_ = now + interval_;
    } else {
      next_ += interval_ + (off < Clock::duration{} ? off : off / kPart);
      interval_ += off / kSmallPart;
    }
    last_ = now;
  }

  /// A time in the past where nothing is known yet.
  Clock::time_point expected() const { return next_; }

 private:
  static constexpr int kFarOff = 4;  // one such part of the interval
  static constexpr int kPart = 16;
  static constexpr int kSmallPart = 128;
  Clock::duration interval_{};
  Clock::time_point last_{};
  Clock::time_point next_{};
};

}  // namespace CCMorse::core
