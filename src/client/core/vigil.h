#pragma once

#include <algorithm>
#include <chrono>

#include "base/wakefulness.h"

namespace CCMorse::core {

/// How one thread waits for bytes. Waking from sleep takes tens of microseconds, so it is awake
/// when something is likely to come: for a moment after the wait began, as answers may take
/// microseconds only, and around the time at which data are expected, as those of real time come at
/// regular intervals. One thread at a time.
class Vigil {
 public:
  using Clock = std::chrono::steady_clock;

  /// A wait begins, until `until`; nothing is expected at a time in the past.
  void Begin(Clock::time_point until, Clock::time_point expected) {
    const auto now = Clock::now();
    expected_ = expected;
    awake_until_ = wakefulness_.Pays(now) ? now + kAtFirst : now;
    sleep_until_ = until;
    if (now < expected - kBefore) {
      sleep_until_ = std::min(until, expected - kBefore);
    } else {
      awake_until_ = std::max(awake_until_, expected + kAfter);
    }
    awake_until_ = std::min(sleep_until_, awake_until_);
  }

  /// There is nothing yet: is it to be looked for again at once? If not, sleep. Leaves the
  /// processor to whoever wants it, but at the time at which data are expected.
  bool StaysAwake() {
    const auto now = Clock::now();
    if (now >= awake_until_) return false;
    if (now < expected_ - kBefore || now > expected_ + kAfter) wakefulness_.GiveWay();
    return true;
  }

  /// When the sleep ends, at the latest.
  Clock::time_point sleep_until() const { return sleep_until_; }

 private:
  static constexpr auto kAtFirst = std::chrono::microseconds(100);
  // A timer of an idle virtual machine rings 0.1 to 0.4 ms late.
  static constexpr auto kBefore = std::chrono::microseconds(500);
  static constexpr auto kAfter = std::chrono::microseconds(200);
  Clock::time_point expected_{};
  Clock::time_point awake_until_{};
  Clock::time_point sleep_until_{};
  ccmorse::Wakefulness wakefulness_;
};

}  // namespace CCMorse::core
