// No allocation in a tick after warm-up (issue "Fleet"): this program counts every one.

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "scene/scenario.h"
#include "sim/actuators/motion_vw.h"
#include "sim/simulation.h"

namespace {

std::atomic<std::uint64_t> allocations = 0;

void* Allocate(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* const memory =
      alignment <= alignof(std::max_align_t)
          ? std::malloc(size == 0 ? 1 : size)
          : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return Allocate(size, 0); }
void* operator new[](std::size_t size) { return Allocate(size, 0); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return Allocate(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return Allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace ccmorse::sim {
namespace {

constexpr int kRobots = 100;

// A hundred robots among boxes, close enough to meet, with noisy lasers.
scene::Scenario Crowd() {
  std::string boxes;
  std::string robots;
  for (int i = 0; i < kRobots; ++i) {
    const char* const comma = i == 0 ? "" : ", ";
    const int column = i % 10;
    const int row = i / 10;
    boxes += fmt::format(
        R"({}{{"id": {}, "kind": "static", "x": {}, "y": {}, "yaw": {}, "size": [0.3, 0.2]}})",
        comma, i + 1, 1.0 + column, 1.0 + row, 0.1 * i);
    robots += fmt::format(
        R"({}{{"name": "r{:02}", "pose": {{"x": {}, "y": {}, "yaw": {}}}, "laser": {{"range_std": 0.01}}}})",
        comma, i, 1.5 + column, 1.5 + row, 0.5 * i);
  }
  return scene::ParseScenario(fmt::format(R"({{"world": {{"name": "crowd", "size": [12, 12],
        "kinds": {{"static": {{"height": 0.3, "color": "#808080"}}}}, "boxes": [{}]}},
        "robots": [{}]}})",
                                          boxes, robots),
                              "crowd.json");
}

class Allocation : public testing::TestWithParam<int> {};

TEST_P(Allocation, ATickAllocatesNothingAfterWarmUp) {
  Simulation simulation(Crowd(), GetParam(), true);
  std::vector<MotionVW*> motions;
  for (const auto& robot : simulation.robots()) {
    motions.push_back(dynamic_cast<MotionVW*>(simulation.FindComponent(robot->name() + ".motion")));
  }
  const auto run = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      simulation.Sense();
      for (int k = 0; k < kRobots; ++k) {
        motions[static_cast<std::size_t>(k)]->SetSpeed(
            {0.3, std::remainder(0.05 * static_cast<double>(simulation.tick()) + k, 2.0)});
      }
      simulation.Act();
    }
  };
  run(600);
  const std::uint64_t before = allocations;
  EXPECT_GT(before, 1000U) << "the counter does not count";
  run(600);
  EXPECT_EQ(allocations - before, 0U);
  std::uint64_t contacts = 0;
  for (const auto& robot : simulation.robots()) contacts += robot->tally().contacts;
  EXPECT_GT(contacts, 10U) << "nobody met anything, so little was tried";
}

INSTANTIATE_TEST_SUITE_P(Threads, Allocation, testing::Values(1, 2, 8));

}  // namespace
}  // namespace ccmorse::sim
