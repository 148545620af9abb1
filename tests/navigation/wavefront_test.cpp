// Planning on a map (specs: player.md G.4).

#include "navigation/wavefront.h"

#include "base/error.h"
#include "navigation/snd.h"
#include "tests/navigation/rig.h"

namespace ccmorse::navigation {
namespace {

OccupancyGrid RandomMap(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  OccupancyGrid map(24, 18, 0.1, {-0.5, 0.3});
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      map.Set({x, y}, Draw(random, 0.0, 1.0) < 0.05 ? Cell::kOccupied : Cell::kFree);
    }
  }
  return map;
}

// Distance from the nearest occupied cell by looking at all.
double BruteDistance(const OccupancyGrid& map, CellIndex cell) {
  double nearest = 1e9;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (map.At({x, y}) != Cell::kOccupied) continue;
      nearest = std::min(nearest, map.scale() * std::hypot(x - cell.x, y - cell.y));
    }
  }
  return nearest;
}

TEST(OccupancyGrid, DistancesAreThoseOfBruteForce) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const OccupancyGrid map = RandomMap(seed);
    const std::vector<double> distances = map.ObstacleDistances(0.5);
    const OccupancyGrid inflated = map.Inflated(0.2);
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        const double distance = BruteDistance(map, {x, y});
        ASSERT_NEAR(distances[map.IndexOf({x, y})], std::min(0.5, distance), 1e-12) << seed;
        ASSERT_EQ(inflated.At({x, y}) == Cell::kOccupied, distance <= 0.2 + 1e-9) << seed;
      }
    }
  }
  const OccupancyGrid empty(3, 3, 0.1);
  for (const double distance : empty.ObstacleDistances(2.0)) EXPECT_EQ(distance, 2.0);
}

TEST(OccupancyGrid, DarkPixelsAreOccupiedAndTheTopRowIsLast) {
  const Image image{2, 2, {{0, 0, 0}, {255, 255, 255}, {128, 128, 128}, {250, 250, 250}}};
  const OccupancyGrid map = OccupancyGrid::FromImage(image, 0.5, false, {-1.0, 2.0});
  EXPECT_EQ(map.At({0, 1}), Cell::kOccupied);
  EXPECT_EQ(map.At({1, 1}), Cell::kFree);
  EXPECT_EQ(map.At({0, 0}), Cell::kUnknown);
  EXPECT_EQ(map.At({1, 0}), Cell::kFree);
  EXPECT_EQ(map.At({2, 0}), Cell::kUnknown);  // outside
  EXPECT_EQ(OccupancyGrid::FromImage(image, 0.5, true).At({1, 1}), Cell::kOccupied);
  EXPECT_EQ(map.CellOf({-0.9, 2.6}), (CellIndex{0, 1}));
  EXPECT_EQ(map.CentreOf({1, 0}).x, -0.25);
  EXPECT_THROW(OccupancyGrid(0, 1, 0.1), Error);
  EXPECT_THROW(OccupancyGrid(1, 1, 0.0), Error);
}

TEST(OccupancyGrid, RaysEndWhereTheyEnterAnOccupiedCell) {
  OccupancyGrid map(10, 10, 0.1);
  map.Set({7, 5}, Cell::kOccupied);
  EXPECT_NEAR(map.CastRay({0.05, 0.55}, 0.0, 5.0), 0.65, 1e-12);
  EXPECT_NEAR(map.CastRay({0.95, 0.55}, kPi, 5.0), 0.15, 1e-12);
  EXPECT_EQ(map.CastRay({0.05, 0.55}, 0.0, 0.5), 0.5);
  EXPECT_EQ(map.CastRay({0.05, 0.55}, kPi / 2, 5.0), 5.0);
  // Diagonally into the lower edge of the cell, y = 0.5.
  EXPECT_NEAR(map.CastRay({0.45, 0.2}, Radians(45.0), 5.0), 0.3 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(map.CastRay({-0.3, 0.55}, 0.0, 5.0), 1.0, 1e-12);  // from outside
}

WavefrontOptions WavefrontDefaults() {
  WavefrontOptions options;
  options.safety_dist = 0.15;
  options.max_radius = 0.4;
  options.dist_penalty = 2.0;
  options.distance_epsilon = 0.1;
  options.replan_dist_thresh = 0.5;
  return options;
}

TEST(Wavefront, CostsAndPathAreThoseOfBruteForceDijkstra) {
  int planned = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    const OccupancyGrid map = RandomMap(seed);
    Wavefront planner(map, WavefrontDefaults());
    std::mt19937_64 random(seed + 1000);
    const auto point = [&] {
      return Pose2{Draw(random, -0.5, 1.9), Draw(random, 0.3, 2.1), Draw(random, -3.0, 3.0)};
    };
    const Pose2 start = point();
    const Pose2 goal = point();
    const CellIndex from = map.CellOf({start.x, start.y});
    const CellIndex to = map.CellOf({goal.x, goal.y});

    // Relaxes all cells until nothing changes.
    std::vector<double> rooms;
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) rooms.push_back(BruteDistance(map, {x, y}));
    }
    const auto open = [&](CellIndex cell) {
      return map.Contains(cell) && rooms[map.IndexOf(cell)] > 0.15;
    };
    std::vector<double> best(map.cells().size(), 1e300);
    if (open(to)) best[map.IndexOf(to)] = 0.0;
    for (bool changed = true; changed;) {
      changed = false;
      for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
          if (!open({x, y})) continue;
          for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
              const CellIndex next{x + dx, y + dy};
              if ((dx == 0 && dy == 0) || !open(next)) continue;
              if (!open({x + dx, y}) || !open({x, y + dy})) continue;  // no cut corners
              if (best[map.IndexOf(next)] >= 1e300) continue;
              const double room = std::min(0.4, rooms[map.IndexOf(next)]);
              const double cost =
                  0.1 * std::hypot(dx, dy) * (1.0 + 2.0 * (0.4 - room) / (0.4 - 0.15));
              // Two ways that are equal but for rounding are one.
              if (best[map.IndexOf(next)] + cost < best[map.IndexOf({x, y})] - 1e-12) {
                best[map.IndexOf({x, y})] = best[map.IndexOf(next)] + cost;
                changed = true;
              }
            }
          }
        }
      }
    }

    planner.SetGoal(goal);
    const bool found = planner.Plan(start);
    if (!open(from)) continue;  // the way out is another test's
    ASSERT_EQ(found, open(to) && best[map.IndexOf(from)] < 1e300) << seed;
    if (!found) continue;
    ++planned;
    for (std::size_t i = 0; i < best.size(); ++i) {
      if (best[i] < 1e300) {
        ASSERT_NEAR(planner.costs()[i], best[i], 1e-9);
      } else {
        ASSERT_GE(planner.costs()[i], Wavefront::kUnreachable);
      }
    }
    // The path is a chain of neighbours whose steps cost what the plan says, with room all along.
    ASSERT_EQ(planner.path().front(), from);
    ASSERT_EQ(planner.path().back(), to);
    double cost = 0.0;
    for (std::size_t i = 0; i < planner.path().size(); ++i) {
      const CellIndex cell = planner.path()[i];
      ASSERT_TRUE(open(cell));
      if (i == 0) continue;
      const CellIndex before = planner.path()[i - 1];
      ASSERT_LE(std::max(std::abs(cell.x - before.x), std::abs(cell.y - before.y)), 1);
      cost += planner.StepCost(cell, 0.1 * std::hypot(cell.x - before.x, cell.y - before.y));
    }
    ASSERT_NEAR(cost, best[map.IndexOf(from)], 1e-9);
    // So have the straight lines between the waypoints.
    Vec2 last{start.x, start.y};
    for (const Pose2& waypoint : planner.waypoints()) {
      const Vec2 way{waypoint.x - last.x, waypoint.y - last.y};
      for (int k = 0; k <= 200; ++k) {
        ASSERT_TRUE(open(map.CellOf(last + (k / 200.0) * way))) << seed;
      }
      last = {waypoint.x, waypoint.y};
    }
    EXPECT_EQ(planner.waypoints().back().yaw, goal.yaw);
    EXPECT_LE(planner.waypoints().size(), planner.path().size() + 2);
  }
  EXPECT_GT(planned, 30);
}

// A wall at x = 0.95..1.05 with a door at the top.
OccupancyGrid Wall() {
  OccupancyGrid map(20, 20, 0.1);
  for (int y = 0; y < 15; ++y) map.Set({10, y}, Cell::kOccupied);
  return map;
}

TEST(Wavefront, ShortcutsLeaveOnlyTheCorners) {
  WavefrontOptions options = WavefrontDefaults();
  options.dist_penalty = 0.0;
  Wavefront planner(Wall(), options);
  planner.SetGoal({1.75, 0.25, 1.0});
  ASSERT_TRUE(planner.Plan({0.25, 0.25, 0.0}));
  EXPECT_GT(planner.path().size(), 25U);
  EXPECT_LE(planner.waypoints().size(), 5U);
  planner.SetGoal({0.25, 1.75, 1.0});
  ASSERT_TRUE(planner.Plan({0.25, 0.25, 0.0}));
  EXPECT_EQ(planner.waypoints().size(), 1U);
}

TEST(Wavefront, NoWayIsSaid) {
  OccupancyGrid map = Wall();
  for (int y = 15; y < 20; ++y) map.Set({10, y}, Cell::kOccupied);
  Wavefront planner(map, WavefrontDefaults());
  planner.SetGoal({1.75, 0.25, 0.0});
  EXPECT_FALSE(planner.Plan({0.25, 0.25, 0.0}));
  EXPECT_FALSE(planner.Step({0.25, 0.25, 0.0}, 1.0).valid);
  planner.SetGoal({1.05, 0.25, 0.0});  // in the wall
  EXPECT_FALSE(planner.Plan({0.25, 0.25, 0.0}));
  planner.SetGoal({7.0, 0.25, 0.0});  // beside the map
  EXPECT_FALSE(planner.Plan({0.25, 0.25, 0.0}));
  EXPECT_THROW(planner.SetGoal({std::nan(""), 0.0, 0.0}), Error);
  WavefrontOptions wrong;
  wrong.safety_dist = -1.0;
  EXPECT_THROW(Wavefront(map, wrong), Error);
}

TEST(Wavefront, AStartTooNearAnObstacleFirstGoesWhereThereIsRoom) {
  Wavefront planner(Wall(), WavefrontDefaults());
  planner.SetGoal({0.25, 1.75, 0.0});
  ASSERT_TRUE(planner.Plan({0.95, 0.25, 0.0}));
  EXPECT_GT(BruteDistance(planner.map(), planner.path().front()), 0.15);
}

TEST(Wavefront, WaypointsComeOneAfterTheOther) {
  WavefrontOptions options = WavefrontDefaults();
  options.add_rotational_waypoints = false;
  Wavefront planner(Wall(), options);
  EXPECT_FALSE(planner.Step({0.25, 0.25, 0.0}, 0.0).valid);  // no goal
  planner.SetGoal({1.75, 0.25, 1.0});
  Pose2 pose{0.25, 0.25, 0.0};
  WavefrontStatus status = planner.Step(pose, 0.0);
  EXPECT_TRUE(status.planned);
  EXPECT_EQ(status.current, 0);
  const auto waypoints = planner.waypoints();
  ASSERT_GE(waypoints.size(), 3U);
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    pose = {waypoints[i].x + 0.09, waypoints[i].y, 0.0};
    status = planner.Step(pose, 0.1);
    EXPECT_FALSE(status.planned);
    EXPECT_EQ(status.current, static_cast<int>(i) + 1);
    EXPECT_FALSE(status.done);
  }
  // At the goal the heading counts as well.
  EXPECT_FALSE(planner.Step({1.75, 0.25, 2.0}, 0.2).done);
  EXPECT_TRUE(planner.Step({1.75, 0.25, 1.1}, 0.3).done);
  EXPECT_TRUE(planner.Step({1.2, 0.25, 1.1}, 9.0).done);  // until the next goal
}

TEST(Wavefront, RotationalWaypointsTurnOnTheSpot) {
  Wavefront planner(Wall(), WavefrontDefaults());
  planner.SetGoal({1.75, 0.25, 1.0});
  planner.Step({0.25, 0.25, 0.0}, 0.0);
  const Pose2 first = planner.waypoints()[0];
  const Pose2 there{first.x, first.y, first.yaw + 1.0};
  const WavefrontStatus turning = planner.Step(there, 0.1);
  EXPECT_EQ(turning.current, 0);
  EXPECT_EQ(turning.waypoint->x, there.x);
  EXPECT_EQ(turning.waypoint->yaw, first.yaw);
  EXPECT_EQ(planner.Step({there.x, there.y, first.yaw}, 0.2).current, 1);
}

TEST(Wavefront, PlansAnewFarFromThePathAndNotTooOften) {
  Wavefront planner(Wall(), WavefrontDefaults());
  planner.SetGoal({0.25, 1.75, 1.0});
  EXPECT_TRUE(planner.Step({0.25, 0.25, 0.0}, 10.0).planned);
  EXPECT_FALSE(planner.Step({0.8, 0.9, 0.0}, 11.0).planned);   // 0.55 m off, but 1 s ago
  EXPECT_FALSE(planner.Step({0.70, 0.9, 0.0}, 13.0).planned);  // 0.45 m off
  EXPECT_TRUE(planner.Step({0.8, 0.9, 0.0}, 13.0).planned);
  WavefrontOptions never = WavefrontDefaults();
  never.replan_min_time = -1.0;
  Wavefront stubborn(Wall(), never);
  stubborn.SetGoal({0.25, 1.75, 1.0});
  EXPECT_TRUE(stubborn.Step({0.25, 0.25, 0.0}, 10.0).planned);
  EXPECT_FALSE(stubborn.Step({0.8, 0.9, 0.0}, 99.0).planned);
}

}  // namespace
}  // namespace ccmorse::navigation
