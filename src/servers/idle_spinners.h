#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace ccmorse::servers {

/// Keeps processors awake for a moment. A virtual processor that has slept is slow for the first
/// millisecond after it wakes: whoever waits for data in real time gets them 100 us later than from
/// a processor that was busy (docs/performance.md). These threads are busy in its stead, with
/// time that nobody else wants: they belong to Linux' idle class (sched(7), SCHED_IDLE). Where the
/// system does not let them they do nothing, and no error is one. One thread calls.
class IdleSpinners {
 public:
  using Clock = std::chrono::steady_clock;

  IdleSpinners() = default;
  ~IdleSpinners();
  IdleSpinners(const IdleSpinners&) = delete;
  IdleSpinners& operator=(const IdleSpinners&) = delete;

  /// From now until `until`, or until the next call, the processors are awake if they have nothing
  /// better to do: those that this process may use, the first four. The first call starts the
  /// threads.
  void SpinUntil(Clock::time_point until);

 private:
  void Run(std::size_t processor);

  // No lock is shared with the threads: one that gets no time would keep it.
  std::atomic<std::uint32_t> calls_ = 0;  // of SpinUntil(), and the end
  std::atomic<Clock::time_point> until_{};
  std::atomic<bool> over_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace ccmorse::servers
