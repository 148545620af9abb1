#include "servers/idle_spinners.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <set>
#include <string>
#include <thread>

namespace ccmorse::servers {
namespace {

using std::chrono_literals::operator""ms;

std::set<int> Threads() {
  std::set<int> threads;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
    threads.insert(std::atoi(entry.path().filename().c_str()));
  }
  return threads;
}

std::chrono::duration<double> ProcessorTime() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

// Until `done` says so, and for 20 s at most, as the idle class may get next to no time.
template <typename Predicate>
bool Within20Seconds(Predicate done) {
  const auto limit = IdleSpinners::Clock::now() + std::chrono::seconds(20);
  while (!done()) {
    if (IdleSpinners::Clock::now() > limit) return false;
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

// Those that are there without spinners. The thread sanitizer starts one of its own beside the
// first that a program starts, and keeps it.
std::set<int> OtherThreads() {
  int first = 0;
  std::thread([&first] { first = ::gettid(); }).join();
  EXPECT_TRUE(Within20Seconds([first] { return Threads().count(first) == 0; }));
  return Threads();
}

TEST(IdleSpinners, NoThreadBeforeItIsNeededAndNoneAfterwards) {
  const auto before = OtherThreads();
  {
    IdleSpinners spinners;
    EXPECT_EQ(Threads(), before);
    spinners.SpinUntil(IdleSpinners::Clock::now() + 1ms);
    EXPECT_GT(Threads().size(), before.size());
  }
  EXPECT_TRUE(Within20Seconds([&] { return Threads() == before; }));
}

TEST(IdleSpinners, TheyBelongToTheIdleClassSoThatNobodyWaitsForThem) {
  const auto before = OtherThreads();
  IdleSpinners spinners;
  spinners.SpinUntil(IdleSpinners::Clock::now());
  for (const int thread : Threads()) {
    if (before.count(thread) > 0) continue;
    EXPECT_TRUE(Within20Seconds([&] { return ::sched_getscheduler(thread) == SCHED_IDLE; }));
  }
}

TEST(IdleSpinners, TheySpinUntilTheTimeAndSleepThen) {
  IdleSpinners spinners;
  const auto start = ProcessorTime();
  // As on a busy machine they may get no time before it is over: again, then.
  EXPECT_TRUE(Within20Seconds([&] {
    spinners.SpinUntil(IdleSpinners::Clock::now() + 20ms);
    std::this_thread::sleep_for(30ms);
    return ProcessorTime() - start > 10ms;
  }));
  const auto spun = ProcessorTime();
  std::this_thread::sleep_for(200ms);
  EXPECT_LT(ProcessorTime() - spun, 100ms);
}

TEST(IdleSpinners, TheEndDoesNotWaitForTheTime) {
  const auto start = IdleSpinners::Clock::now();
  {
    IdleSpinners spinners;
    spinners.SpinUntil(start + std::chrono::hours(1));
  }
  EXPECT_LT(IdleSpinners::Clock::now() - start, std::chrono::seconds(60));
}

}  // namespace
}  // namespace ccmorse::servers
