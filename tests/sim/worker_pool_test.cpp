#include "sim/worker_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <thread>
#include <vector>

namespace ccmorse::sim {
namespace {

TEST(WorkerPool, EachPartIsDoneOnceInEachRound) {
  for (const int threads : {1, 2, 3, 8}) {
    WorkerPool pool(threads);
    EXPECT_EQ(pool.threads(), threads);
    std::vector<int> done(static_cast<std::size_t>(threads));
    for (int round = 1; round <= 1000; ++round) {
      pool.Run([&done](int part) { ++done[static_cast<std::size_t>(part)]; });
      for (const int times : done) ASSERT_EQ(times, round);
    }
  }
}

TEST(WorkerPool, PartsRunAtTheSameTime) {
  // Each part waits for the others: it would not end if one thread did two of them.
  WorkerPool pool(4);
  std::atomic<int> here = 0;
  pool.Run([&here](int) {
    ++here;
    while (here < 4) std::this_thread::yield();
  });
  EXPECT_EQ(here, 4);
}

TEST(WorkerPool, APoolThatNeverWorkedEnds) { WorkerPool pool(3); }

}  // namespace
}  // namespace ccmorse::sim
