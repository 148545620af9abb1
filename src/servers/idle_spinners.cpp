#include "servers/idle_spinners.h"

#include <pthread.h>
#include <sched.h>

#include <system_error>

#include "base/log.h"

namespace ccmorse::servers {
namespace {

// More would cost more than they bring: on a large machine nobody knows who will run where.
constexpr std::size_t kMostThreads = 4;

// The processors that this process may use, the first of them. Each gets a thread of its own: the
// scheduler would put two on one while the other sleeps.
std::vector<std::size_t> Processors() {
  std::vector<std::size_t> found;
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return found;
  for (std::size_t i = 0; i < CPU_SETSIZE && found.size() < kMostThreads; ++i) {
    if (CPU_ISSET(i, &allowed)) found.push_back(i);
  }
  return found;
}

// A thread that took time from others would do harm: false where it is not so.
bool BecomeIdleThreadOf(std::size_t processor) {
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(processor, &only);
  const sched_param none{};
  return pthread_setschedparam(pthread_self(), SCHED_IDLE, &none) == 0 &&
         pthread_setaffinity_np(pthread_self(), sizeof only, &only) == 0;
}

}  // namespace

IdleSpinners::~IdleSpinners() {
  over_ = true;
  until_ = Clock::time_point{};
  ++calls_;
  calls_.notify_all();
  for (auto& thread : threads_) thread.join();
}

void IdleSpinners::SpinUntil(Clock::time_point until) {
  until_ = until;
  if (++calls_ > 1) return calls_.notify_all();
  try {
    for (const std::size_t processor : Processors()) {
      threads_.emplace_back([this, processor] { Run(processor); });
    }
  } catch (const std::system_error& error) {
    LogDebug("no thread to keep processors awake: {}", error.what());
  }
}

void IdleSpinners::Run(std::size_t processor) {
  if (!BecomeIdleThreadOf(processor)) return;
  while (!over_) {
    const auto seen = calls_.load();
    while (Clock::now() < until_.load()) {
    }
    calls_.wait(seen);
  }
}

}  // namespace ccmorse::servers
