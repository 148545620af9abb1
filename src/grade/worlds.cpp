#include "grade/worlds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/philox.h"
#include "base/trig.h"

namespace ccmorse::grade {
namespace {

using scene::Box;
using scene::Scenario;

// Draws one after the other from the counter-based generator; `purpose` keeps them apart.
class Draws {
 public:
  Draws(std::uint64_t seed, std::uint32_t purpose, std::uint32_t attempt)
      : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)},
        purpose_(purpose),
        attempt_(attempt) {}
  /// In (0, 1).
  double Share() {
    const auto bits = Philox({count_++, purpose_, attempt_, 0x67726164U}, key_);
    return OpenUniform(bits[0], bits[1]);
  }
  /// In [0, count).
  int Below(int count) { return std::min(static_cast<int>(Share() * count), count - 1); }

 private:
  std::array<std::uint32_t, 2> key_;
  std::uint32_t purpose_;
  std::uint32_t attempt_;
  std::uint32_t count_ = 0;
};

enum Purpose : std::uint32_t { kWorld = 1, kGoal = 2 };

constexpr std::uint32_t kMostTries = 400;
constexpr double kLeastReach = 1.0 / 3.0;  // of the free floor
constexpr int kRoom = 8;                   // cells from a drawn start to the nearest wall
constexpr double kFarGoal = 1.5;           // m, as the crow flies
constexpr double kMazePitch = 0.6;         // m, about, from one passage to the next
constexpr double kMazeWall = 0.04;         // m

Box Wall(int id, double x, double y, double size_x, double size_y) {
  Box box;
  box.id = id;
  box.kind = "static";
  box.pose = {x, y, 0.0};
  box.size_x = size_x;
  box.size_y = size_y;
  box.height = 0.16;
  box.color = {120, 120, 128};
  return box;
}

// A maze of rooms on a grid: a tree drawn by depth first search, and some more walls taken away, so
// that there are loops.
void BuildMaze(scene::World& world, Draws& draws) {
  std::erase_if(world.boxes, [](const Box& box) { return box.kind != "border"; });
  world.docks.clear();
  const int columns = std::max(2, static_cast<int>(std::lround(world.size_x / kMazePitch)));
  const int rows = std::max(2, static_cast<int>(std::lround(world.size_y / kMazePitch)));
  const double room_x = world.size_x / columns;
  const double room_y = world.size_y / rows;
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(x);
  };
  std::vector<char> seen(static_cast<std::size_t>(columns * rows), 0);
  std::vector<char> east(seen.size(), 1);   // wall to the right of a room
  std::vector<char> north(seen.size(), 1);  // wall above it
  std::vector<std::pair<int, int>> way = {{draws.Below(columns), draws.Below(rows)}};
  seen[at(way[0].first, way[0].second)] = 1;
  while (!way.empty()) {
    const auto [x, y] = way.back();
    std::vector<std::pair<int, int>> to;
    for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      const bool inside = x + dx >= 0 && x + dx < columns && y + dy >= 0 && y + dy < rows;
      if (inside && seen[at(x + dx, y + dy)] == 0) to.emplace_back(x + dx, y + dy);
    }
    if (to.empty()) {
      way.pop_back();
      continue;
    }
    const auto [nx, ny] = to[static_cast<std::size_t>(draws.Below(static_cast<int>(to.size())))];
    if (ny == y) {
      east[at(std::min(x, nx), y)] = 0;
    } else {
      north[at(x, std::min(y, ny))] = 0;
    }
    seen[at(nx, ny)] = 1;
    way.emplace_back(nx, ny);
  }
  int id = 0;
  for (const Box& box : world.boxes) id = std::max(id, box.id);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      constexpr double kOpened = 0.15;
      const bool open_east = draws.Share() < kOpened;
      const bool open_north = draws.Share() < kOpened;
      if (x + 1 < columns && east[at(x, y)] != 0 && !open_east) {
        world.boxes.push_back(
            Wall(++id, (x + 1) * room_x, (y + 0.5) * room_y, kMazeWall, room_y + kMazeWall));
      }
      if (y + 1 < rows && north[at(x, y)] != 0 && !open_north) {
        world.boxes.push_back(
            Wall(++id, (x + 0.5) * room_x, (y + 1) * room_y, room_x + kMazeWall, kMazeWall));
      }
    }
  }
}

// Somewhere with room around it; false where there is no such place.
bool DrawStart(const Grid& roomy, Draws& draws, Pose2& pose) {
  std::vector<Cell> cells;
  for (int y = 0; y < roomy.height; ++y) {
    for (int x = 0; x < roomy.width; ++x) {
      if (roomy.Has({x, y})) cells.push_back({x, y});
    }
  }
  if (cells.empty()) return false;
  const Vec2 at =
      MiddleOf(cells[static_cast<std::size_t>(draws.Below(static_cast<int>(cells.size())))]);
  pose = {at.x, at.y, NormalizeAngle(2.0 * kPi * draws.Share())};
  return true;
}

Grid Free(const scene::World& world) { return Inverted(Grown(PlannersMap(world), kDilation)); }

// Does every robot stand free, with a good part of the floor to go to?
bool IsFair(const Scenario& scenario, const Grid& free) {
  for (const std::string& problem : scene::PlaceProblems(scenario)) {
    if (!problem.empty()) return false;
  }
  const int all = free.Count();
  return std::all_of(scenario.robots.begin(), scenario.robots.end(), [&](const auto& robot) {
    const Grid reached = Connected(free, CellOf({robot.pose.x, robot.pose.y}));
    return reached.Count() >= kLeastReach * all;
  });
}

bool TryWorld(const WorldDef& def, Draws draws, Scenario& scenario) {
  scene::World& world = scenario.world;
  if (def.maze) BuildMaze(world, draws);
  if (def.random_presets) {
    const double share = 0.2 + 0.3 * draws.Share();
    for (Box& box : world.boxes) {
      if (box.dynamic) box.raised = draws.Share() < share;
    }
  }
  if (def.random_start) {
    const Grid roomy = Inverted(Grown(PlannersMap(world), kRoom));
    for (scene::RobotDef& robot : scenario.robots) {
      if (!DrawStart(roomy, draws, robot.pose)) return false;
    }
  }
  if (!def.maze && !def.random_presets && !def.random_start) return true;  // as the teacher has it
  return IsFair(scenario, Free(world));
}

}  // namespace

Scenario MakeWorld(const Rubric& rubric, std::uint64_t seed) {
  const WorldDef& def = rubric.worlds[seed % rubric.worlds.size()];
  Scenario given = scene::LoadScenario(def.scenario);
  given.seed = seed;
  if (def.maze) given.obstacles = {};
  if (def.range_std > 0.0) {
    for (scene::RobotDef& robot : given.robots) robot.laser.range_std = def.range_std;
  }
  for (std::uint32_t attempt = 0; attempt < kMostTries; ++attempt) {
    Scenario scenario = given;
    if (TryWorld(def, Draws(seed, kWorld, attempt), scenario)) return scenario;
  }
  throw Error(fmt::format("{}: no world with room for its robots was found for seed {}",
                          def.scenario, seed));
}

std::optional<Route> DrawRoute(const Scenario& scenario) {
  const auto first = std::min_element(scenario.robots.begin(), scenario.robots.end(),
                                      [](const auto& a, const auto& b) { return a.name < b.name; });
  if (first == scenario.robots.end()) return std::nullopt;
  Route route;
  route.start = CellOf({first->pose.x, first->pose.y});
  const Grid reached = Connected(Free(scenario.world), route.start);
  std::vector<Cell> far;
  std::vector<Cell> all;
  for (int y = 0; y < reached.height; ++y) {
    for (int x = 0; x < reached.width; ++x) {
      if (!reached.Has({x, y}) || Cell{x, y} == route.start) continue;
      all.push_back({x, y});
      const double way = std::hypot(x - route.start.x, y - route.start.y) * kCell;
      if (way >= kFarGoal) far.push_back({x, y});
    }
  }
  const std::vector<Cell>& goals = far.empty() ? all : far;
  if (goals.empty()) return std::nullopt;
  Draws draws(scenario.seed, kGoal, 0);
  route.goal = goals[static_cast<std::size_t>(draws.Below(static_cast<int>(goals.size())))];
  return route;
}

Grid PlannersMap(const scene::World& world) { return Walls(world, kCell / 2.0); }

std::string MapText(const Grid& map) {
  std::string text = fmt::format("{}\n", map.height);
  for (int y = map.height - 1; y >= 0; --y) {
    for (int x = 0; x < map.width; ++x) text += map.Has({x, y}) ? 'O' : '.';
    text += '\n';
  }
  return text;
}

}  // namespace ccmorse::grade
