#include "grade/worlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "base/error.h"
#include "base/philox.h"

namespace ccmorse::grade {
namespace {

Rubric Worlds(bool presets, bool start, bool maze) {
  Rubric rubric;
  rubric.worlds = {{std::string(CCMORSE_SOURCE_DIR) + "/tests/grade/task/scenario.json", presets,
                    start, 0.01, maze}};
  return rubric;
}

TEST(Worlds, AreAFunctionOfTheSeed) {
  const Rubric rubric = Worlds(true, true, false);
  std::set<std::string> all;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::string text = scene::ToJson(MakeWorld(rubric, seed)).Dump();
    EXPECT_EQ(scene::ToJson(MakeWorld(rubric, seed)).Dump(), text);
    all.insert(text);
  }
  EXPECT_EQ(all.size(), 20U);
}

TEST(Worlds, RobotsStandFreeAndGoalsCanBeReached) {
  for (const bool maze : {false, true}) {
    const Rubric rubric = Worlds(!maze, true, maze);
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const scene::Scenario scenario = MakeWorld(rubric, seed);
      for (const std::string& problem : scene::PlaceProblems(scenario)) EXPECT_EQ(problem, "");
      EXPECT_EQ(scenario.robots[0].laser.range_std, 0.01);
      const auto route = DrawRoute(scenario);
      ASSERT_TRUE(route) << seed;
      const Grid free = Inverted(Grown(PlannersMap(scenario.world), kDilation));
      EXPECT_LT(ShortestWay(free, route->start, route->goal), 1e4) << seed;
      // What the simulator reads is what was made.
      const std::string text = scene::ToJson(scenario).Dump();
      EXPECT_EQ(scene::ToJson(scene::ParseScenario(text, scenario.name + ".json")).Dump(), text);
    }
  }
}

TEST(Worlds, WithoutAnythingAtRandomTheWorldIsTheTeachers) {
  Rubric rubric = Worlds(false, false, false);
  rubric.worlds[0].range_std = 0.0;
  scene::Scenario given = scene::LoadScenario(rubric.worlds[0].scenario);
  given.seed = 7;
  EXPECT_EQ(scene::ToJson(MakeWorld(rubric, 7)).Dump(), scene::ToJson(given).Dump());
}

TEST(Worlds, TheMapForPlannersIsTheCourses) {
  // courses/par/planning/maps/arena.txt leaves the docks' separators and one box out.
  scene::Scenario scenario =
      scene::LoadScenario(std::string(CCMORSE_SOURCE_DIR) + "/courses/par/planning/scenario.json");
  std::erase_if(scenario.world.boxes,
                [](const scene::Box& box) { return box.kind == "dock_separator"; });
  EXPECT_EQ(MapText(PlannersMap(scenario.world)),
            ReadFile(std::string(CCMORSE_SOURCE_DIR) + "/courses/par/planning/maps/arena.txt"));
}

// The oracle against Bellman and Ford's way, which needs no queue: relax until nothing changes.
double SlowWay(const Grid& free, Cell start, Cell goal) {
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> cost(free.cells.size(), infinity);
  if (free.Has(start)) cost[free.At(start)] = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < free.height; ++y) {
      for (int x = 0; x < free.width; ++x) {
        if (!free.Has({x, y})) continue;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            if (!free.Has({x + dx, y + dy})) continue;
            if (!free.Has({x + dx, y}) || !free.Has({x, y + dy})) continue;
            const double through = cost[free.At({x + dx, y + dy})] + std::hypot(dx, dy);
            if (through < cost[free.At({x, y})] - 1e-12) {
              cost[free.At({x, y})] = through;
              changed = true;
            }
          }
        }
      }
    }
  }
  return free.Has(goal) ? cost[free.At(goal)] : infinity;
}

TEST(Oracle, FindsTheShortestWayOnRandomMaps) {
  int reached = 0;
  for (std::uint32_t map = 0; map < 300; ++map) {
    Grid free(15, 13);
    for (std::size_t i = 0; i < free.cells.size(); ++i) {
      const auto bits = Philox({static_cast<std::uint32_t>(i), map, 0, 0}, {1, 2});
      free.cells[i] = OpenUniform(bits[0], bits[1]) < 0.7 ? 1 : 0;
    }
    const double slow = SlowWay(free, {0, 0}, {14, 12});
    const double fast = ShortestWay(free, {0, 0}, {14, 12});
    if (std::isinf(slow)) {
      EXPECT_TRUE(std::isinf(fast)) << map;
    } else {
      EXPECT_NEAR(fast, slow, 1e-9) << map;
      ++reached;
    }
  }
  EXPECT_GT(reached, 60);
}

}  // namespace
}  // namespace ccmorse::grade
