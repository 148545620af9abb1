// A round over the fast link needs no memory, at either end: simulator and client in one program
// whose operator new counts.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <string>
#include <thread>

#include "libCCMorse/CCMorse.h"
#include "servers/runner.h"

namespace {

std::atomic<std::size_t> allocations{0};

void* Counted(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return Counted(size); }
void* operator new[](std::size_t size) { return Counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

struct ServerThread {
  explicit ServerThread(ccmorse::servers::Runner& runner_in)
      : runner(runner_in), thread([this] { runner.Run(); }) {}
  ~ServerThread() {
    runner.Stop();
    thread.join();
  }
  ccmorse::servers::Runner& runner;
  std::thread thread;
};

TEST(N05, ARoundNeedsNoMemory) {
  if (std::string(CCMORSE_SANITIZE) != "")
    GTEST_SKIP() << "sanitizers have allocators of their own";
  ccmorse::sim::Simulation simulation(ccmorse::scene::ParseScenario("{}", "test.json"));
  ccmorse::servers::RunOptions options;
  options.pace = ccmorse::servers::Pace::kLockstep;
  options.morse.port = options.morse.first_stream_port = 0;
  ccmorse::servers::Runner runner(simulation, options);
  const ServerThread server(runner);
  CCMorse::PlayerClient client("127.0.0.1", runner.morse().port());
  CCMorse::Position2dProxy position(&client, 0);
  CCMorse::LaserProxy laser(&client, 0);
  ASSERT_EQ(CCMorse::MorseClient::GetInstance().GetLink(), "fast");
  double sum = 0.0;
  const auto rounds = [&](int count) {
    for (int i = 0; i < count; ++i) {
      client.Read();
      sum += laser[340] + position.GetXPos() + position.GetXSpeed();
      position.SetSpeed(0.1, i % 2 == 0 ? 0.5 : -0.5);
    }
  };
  rounds(100);
  const std::size_t before = allocations;
  rounds(500);
  EXPECT_EQ(allocations - before, 0U);
  EXPECT_GT(sum, 0.0);
}

}  // namespace
