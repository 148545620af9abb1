// The solutions of the planning task, one program each: CPlanner is what it is linked with.
#include "courses/par/planning/template/planner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

namespace {

using imr::CMapGrid;
using imr::CPlanner;
using imr::SCell;

const char kArena[] = CCMORSE_SOURCE_DIR "/courses/par/planning/maps/arena.txt";

// Whether a cell is farther from all that is no floor than the planner dilates, by the definition.
std::vector<std::uint8_t> FreeByDefinition(const CMapGrid& map) {
  std::vector<SCell> walls;
  for (int y = 0; y < map.getHeight(); ++y) {
    for (int x = 0; x < map.getWidth(); ++x) {
      if (map.getCell(x, y) != CMapGrid::FLOOR) walls.push_back({x, y});
    }
  }
  std::vector<std::uint8_t> free;
  for (int y = 0; y < map.getHeight(); ++y) {
    for (int x = 0; x < map.getWidth(); ++x) {
      bool is_free = true;
      for (const SCell wall : walls) {
        is_free &= std::hypot(wall.x - x, wall.y - y) > CPlanner::DILATION;
      }
      free.push_back(is_free ? 1 : 0);
    }
  }
  return free;
}

// The oracle knows neither heap nor order: it lowers every cell's cost by its neighbours' until
// nothing changes (Bellman and Ford). Numbers of steps are kept apart, so that nothing is summed
// up.
double ShortestByDefinition(const CPlanner& planner, SCell start, SCell goal) {
  struct Cost {
    int straight = 0;
    int diagonal = 0;
    double sum() const { return straight + diagonal * std::sqrt(2.0); }
  };
  const int width = planner.getWidth();
  const int height = planner.getHeight();
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  };
  std::vector<Cost> cost(at(0, height), {1 << 28, 0});
  if (!planner.isFree(start.x, start.y) || !planner.isFree(goal.x, goal.y)) return -1.0;
  cost[at(start.x, start.y)] = {};
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (!planner.isFree(x, y)) continue;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            if (!planner.isFree(x + dx, y + dy) || !planner.isFree(x + dx, y) ||
                !planner.isFree(x, y + dy)) {
              continue;
            }
            Cost by = cost[at(x + dx, y + dy)];
            if (dx != 0 && dy != 0) {
              ++by.diagonal;
            } else if (dx != 0 || dy != 0) {
              ++by.straight;
            }
            if (by.sum() < cost[at(x, y)].sum() - 1e-9) {
              cost[at(x, y)] = by;
              changed = true;
            }
          }
        }
      }
    }
  }
  const double sum = cost[at(goal.x, goal.y)].sum();
  return sum < (1 << 27) ? sum : -1.0;
}

// How deep the line between the middles of two cells comes into any cell that is not free: the
// largest length of it inside such a cell, worked out with real numbers.
double LengthInObstacles(const CPlanner& planner, SCell from, SCell to) {
  double most = 0.0;
  for (int y = std::min(from.y, to.y) - 1; y <= std::max(from.y, to.y) + 1; ++y) {
    for (int x = std::min(from.x, to.x) - 1; x <= std::max(from.x, to.x) + 1; ++x) {
      if (planner.isFree(x, y)) continue;
      double enter = 0.0;
      double leave = 1.0;
      const double lines[2][3] = {
          {static_cast<double>(from.x), static_cast<double>(to.x - from.x), static_cast<double>(x)},
          {static_cast<double>(from.y), static_cast<double>(to.y - from.y),
           static_cast<double>(y)}};
      for (const auto& [origin, direction, cell] : lines) {
        if (direction == 0.0) {
          if (std::fabs(origin - cell) > 0.5) leave = -1.0;
          continue;
        }
        const double a = (cell - 0.5 - origin) / direction;
        const double b = (cell + 0.5 - origin) / direction;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
      }
      most = std::max(most, (leave - enter) * std::hypot(to.x - from.x, to.y - from.y));
    }
  }
  return most;
}

void ExpectValid(const CPlanner& planner, SCell start, SCell goal) {
  const std::vector<SCell>& path = planner.getPath();
  const std::vector<SCell>& smooth = planner.getSmoothPath();
  ASSERT_FALSE(path.empty());
  ASSERT_FALSE(smooth.empty());
  EXPECT_EQ(path.front(), start);
  EXPECT_EQ(path.back(), goal);
  EXPECT_EQ(smooth.front(), start);
  EXPECT_EQ(smooth.back(), goal);
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_LE(std::abs(path[i].x - path[i - 1].x), 1);
    EXPECT_LE(std::abs(path[i].y - path[i - 1].y), 1);
    EXPECT_LT(LengthInObstacles(planner, path[i - 1], path[i]), 1e-9);
  }
  for (std::size_t i = 1; i < smooth.size(); ++i) {
    EXPECT_LT(LengthInObstacles(planner, smooth[i - 1], smooth[i]), 1e-9);
  }
  EXPECT_LE(CPlanner::lengthOf(smooth), CPlanner::lengthOf(path) + 1e-9);
}

CMapGrid RandomMap(std::mt19937& random, int width, int height, int walls) {
  CMapGrid map(width, height, 0.02);
  map.fill(CMapGrid::FLOOR);
  for (int i = 0; i < walls; ++i) {
    map.setCell(static_cast<int>(random() % static_cast<unsigned>(width)),
                static_cast<int>(random() % static_cast<unsigned>(height)),
                i % 5 == 0 ? CMapGrid::UNKNOWN : CMapGrid::WALL);
  }
  return map;
}

}  // namespace

TEST(T08, DilationIsADiscAroundAllThatIsNoFloor) {
  std::mt19937 random(1);
  for (int round = 0; round < 30; ++round) {
    const CMapGrid map = RandomMap(random, 50, 40, 10);
    CPlanner planner;
    planner.setMap(map);
    const std::vector<std::uint8_t> expected = FreeByDefinition(map);
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 50; ++x) {
        ASSERT_EQ(planner.isFree(x, y), expected[static_cast<std::size_t>(y * 50 + x)] != 0);
      }
    }
  }
}

TEST(T09, PathsAreAsShortAsTheOracleOn1000RandomMaps) {
  std::mt19937 random(2);
  int found = 0;
  for (int round = 0; round < 1000; ++round) {
    const int width = 20 + static_cast<int>(random() % 30);
    const int height = 20 + static_cast<int>(random() % 30);
    const CMapGrid map = RandomMap(random, width, height, width * height / 150);
    CPlanner planner;
    planner.setMap(map);
    std::vector<SCell> free;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (planner.isFree(x, y)) free.push_back({x, y});
      }
    }
    if (free.empty()) continue;
    const SCell start = free[random() % free.size()];
    const SCell goal = free[random() % free.size()];
    const double shortest = ShortestByDefinition(planner, start, goal);
    ASSERT_EQ(planner.plan(start.x, start.y, goal.x, goal.y), shortest >= 0.0) << round;
    if (shortest < 0.0) {
      EXPECT_TRUE(planner.getPath().empty());
      continue;
    }
    ++found;
    EXPECT_NEAR(CPlanner::lengthOf(planner.getPath()), shortest, 1e-9) << round;
    ExpectValid(planner, start, goal);
  }
  EXPECT_GT(found, 400);
}

TEST(T10, ArenaIsPlannedAndSmoothed) {
  const CMapGrid map(kArena);
  CPlanner planner;
  const auto begin = std::chrono::steady_clock::now();
  planner.setMap(map);
  ASSERT_TRUE(planner.plan(26, 172, 160, 10));
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  std::cout << "planned 171 x 186 cells in " << took.count() << " ms\n";
  ExpectValid(planner, {26, 172}, {160, 10});
  EXPECT_NEAR(CPlanner::lengthOf(planner.getPath()),
              ShortestByDefinition(planner, {26, 172}, {160, 10}), 1e-9);
  EXPECT_LT(CPlanner::lengthOf(planner.getSmoothPath()),
            CPlanner::lengthOf(planner.getPath()) - 10.0);
  EXPECT_LT(planner.getSmoothPath().size(), planner.getPath().size() / 4);
}

TEST(T09, NoWayIsSaidAndEndsInObstaclesAreRefused) {
  CMapGrid map(40, 40, 0.02);
  map.fill(CMapGrid::FLOOR);
  CPlanner planner;
  planner.setMap(map);
  EXPECT_TRUE(planner.plan(3, 3, 3, 3));
  EXPECT_EQ(planner.getPath().size(), 1U);
  EXPECT_FALSE(planner.plan(-1, 0, 10, 10));
  EXPECT_FALSE(planner.plan(0, 0, 40, 10));
  for (int y = 0; y < 40; ++y) map.setCell(20, y, CMapGrid::WALL);
  planner.setMap(map);
  EXPECT_FALSE(planner.plan(3, 3, 36, 3));
  EXPECT_TRUE(planner.getPath().empty());
  EXPECT_TRUE(planner.getSmoothPath().empty());
  EXPECT_FALSE(planner.plan(3, 3, 21, 3));
  EXPECT_TRUE(planner.plan(3, 3, 3, 36));
}
