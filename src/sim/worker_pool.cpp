#include "sim/worker_pool.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace ccmorse::sim {
namespace {

constexpr std::uint32_t kStopBit = 1;
constexpr std::uint32_t kRound = 2;
// A round of a small fleet takes less time than it takes the system to wake a thread, so threads
// look for a while (some tens of microseconds) before they sleep.
constexpr int kLooks = 2000;

void Pause() {
#if defined(__x86_64__)
  _mm_pause();
#endif
}

// Returns the value once it differs from `old`.
std::uint32_t WaitForChange(const std::atomic<std::uint32_t>& value, std::uint32_t old) {
  for (int look = 0; look < kLooks; ++look) {
    const std::uint32_t now = value.load(std::memory_order_acquire);
    if (now != old) return now;
    Pause();
  }
  value.wait(old, std::memory_order_acquire);
  return value.load(std::memory_order_acquire);
}

}  // namespace

WorkerPool::WorkerPool(int threads) {
  for (int part = 1; part < threads; ++part) {
    workers_.emplace_back([this, part] { Serve(part); });
  }
}

WorkerPool::~WorkerPool() {
  round_.fetch_or(kStopBit, std::memory_order_release);
  round_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void WorkerPool::RunParts(const Task& task) {
  if (!workers_.empty()) {
    task_ = task;
    working_.store(static_cast<std::uint32_t>(workers_.size()), std::memory_order_relaxed);
    round_.fetch_add(kRound, std::memory_order_release);
    round_.notify_all();
  }
  task.call(task.object, 0);
  for (std::uint32_t left = working_.load(std::memory_order_acquire); left != 0;) {
    left = WaitForChange(working_, left);
  }
}

void WorkerPool::Serve(int part) {
  std::uint32_t round = 0;
  for (;;) {
    round = WaitForChange(round_, round);
    if ((round & kStopBit) != 0) return;
    task_.call(task_.object, part);
    if (working_.fetch_sub(1, std::memory_order_acq_rel) == 1) working_.notify_one();
  }
}

}  // namespace ccmorse::sim
