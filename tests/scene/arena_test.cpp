// The SyRoTek arena against what the thesis and the measured map say of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/polygon.h"
#include "base/trig.h"
#include "scene/robots.h"
#include "scene/scenario.h"
#include "scene/world_folders.h"

namespace ccmorse::scene {
namespace {

World Arena() { return ParseScenario("{}", "test.json").world; }

Scenario Named(const std::string& name) { return LoadScenario(FindScenario(name)); }

TEST(W01, ArenaIs342By372) {
  const World arena = Arena();
  EXPECT_DOUBLE_EQ(arena.size_x, 3.42);
  EXPECT_DOUBLE_EQ(arena.size_y, 3.72);
  // The border's outer faces coincide with the floor's edges.
  double left = 1e9;
  double right = -1e9;
  double bottom = 1e9;
  double top = -1e9;
  for (const Box& box : arena.boxes) {
    for (const Vec2 corner : BoxCorners(box.pose, box.size_x, box.size_y)) {
      left = std::min(left, corner.x);
      right = std::max(right, corner.x);
      bottom = std::min(bottom, corner.y);
      top = std::max(top, corner.y);
    }
  }
  EXPECT_NEAR(left, 0.0, 1e-9);
  EXPECT_NEAR(right, 3.42, 1e-9);
  EXPECT_NEAR(bottom, 0.0, 1e-9);
  EXPECT_NEAR(top, 3.72, 1e-9);
}

TEST(W02, ObstaclesAreAbout16CmHigh) {
  for (const Box& box : Arena().boxes) {
    if (box.kind == "dock_separator") {
      EXPECT_DOUBLE_EQ(box.height, 0.13) << box.id;
    } else {
      EXPECT_DOUBLE_EQ(box.height, 0.16) << box.id;
    }
  }
}

TEST(W03, FloorIsWhiteWithItsCornerAtTheOrigin) {
  const World arena = Arena();
  EXPECT_EQ(arena.floor, (Color{255, 255, 255}));
  for (const Box& box : arena.boxes) {
    for (const Vec2 corner : BoxCorners(box.pose, box.size_x, box.size_y)) {
      EXPECT_GE(corner.x, -1e-9) << box.id;
      EXPECT_GE(corner.y, -1e-9) << box.id;
    }
  }
}

TEST(W04, BordersAndDockSeparatorsAreBrown) {
  for (const Box& box : Arena().boxes) {
    if (box.kind != "border" && box.kind != "dock_separator") continue;
    EXPECT_GT(box.color.r, box.color.g + 20) << box.id;  // a dark orange is brown
    EXPECT_GT(box.color.g, box.color.b + 20) << box.id;
    EXPECT_LT(box.color.r, 170) << box.id;
    EXPECT_FALSE(box.dynamic) << box.id;
  }
}

TEST(W05, StaticObstaclesAreLightGrey) {
  for (const Box& box : Arena().boxes) {
    if (box.kind != "static") continue;
    EXPECT_EQ(box.color.r, box.color.g);
    EXPECT_EQ(box.color.g, box.color.b);
    EXPECT_GT(box.color.r, 128);
    EXPECT_LT(box.color.r, 230);
    EXPECT_FALSE(box.dynamic) << box.id;
    EXPECT_TRUE(box.raised) << box.id;
  }
}

TEST(W06, DynamicObstaclesAreRedAndAllRetracted) {
  int dynamic = 0;
  for (const Scenario& scenario : {ParseScenario("{}", "test.json"), Named("syrotek")}) {
    for (const Box& box : scenario.world.boxes) {
      EXPECT_EQ(box.dynamic, box.kind.starts_with("dynamic_")) << box.id;
      if (!box.dynamic) continue;
      ++dynamic;
      EXPECT_GT(box.color.r, 180) << box.id;
      EXPECT_LT(box.color.g, 80) << box.id;
      EXPECT_LT(box.color.b, 80) << box.id;
      EXPECT_FALSE(box.raised) << box.id;
    }
  }
  EXPECT_EQ(dynamic, 2 * 38);
}

TEST(W07, FourSpotlightsAndASunWithShadows) {
  int spots = 0;
  int suns = 0;
  const World arena = Arena();
  for (const Light& light : arena.lights) {
    EXPECT_GT(light.position.z, 0.0);
    EXPECT_GT(light.energy, 0.0);
    if (light.kind == "spot") {
      ++spots;
      EXPECT_FALSE(light.shadows);
      EXPECT_GT(light.position.x, 0.0);
      EXPECT_LT(light.position.x, arena.size_x);
      EXPECT_GT(light.position.y, 0.0);
      EXPECT_LT(light.position.y, arena.size_y);
    } else if (light.kind == "sun") {
      ++suns;
      EXPECT_TRUE(light.shadows);
    }
  }
  EXPECT_EQ(spots, 4);
  EXPECT_EQ(suns, 1);
}

TEST(W08, NinetyBoxesOfFiveKinds) {
  const World arena = Arena();
  std::map<std::string, int> count;
  std::map<std::string, double> area;
  for (std::size_t i = 0; i < arena.boxes.size(); ++i) {
    const Box& box = arena.boxes[i];
    EXPECT_EQ(box.id, static_cast<int>(i) + 1);
    ++count[box.kind];
    area[box.kind] += box.size_x * box.size_y;
  }
  EXPECT_EQ(arena.boxes.size(), 90U);
  const std::map<std::string, int> expected = {{"border", 4},
                                               {"dock_separator", 14},
                                               {"static", 34},
                                               {"dynamic_slab", 30},
                                               {"dynamic_pillar", 8}};
  EXPECT_EQ(count, expected);
  // From the listed lengths: 17 x 0.32, 11 x 0.36, 0.04, 0.24, 0.42, 0.54, 0.72 and 2.78, 0.04
  // wide.
  EXPECT_NEAR(area["static"],
              0.04 * (17 * 0.32 + 11 * 0.36 + 0.04 + 0.24 + 0.42 + 0.54 + 0.72 + 2.78), 1e-9);
  EXPECT_NEAR(area["dynamic_slab"], 30 * 0.04 * 0.28, 1e-9);
  EXPECT_NEAR(area["dynamic_pillar"], 8 * 0.16 * 0.16, 1e-9);
  EXPECT_NEAR(area["dock_separator"], (12 * 0.08 + 2 * 0.02) * 0.18, 1e-9);
  const auto turned = std::count_if(arena.boxes.begin(), arena.boxes.end(), [](const Box& box) {
    return box.kind == "dynamic_pillar" && std::abs(box.pose.yaw - kPi / 4.0) < 1e-12;
  });
  EXPECT_EQ(turned, 4);
}

TEST(W08, MazeWallsStandOnTheirGrid) {
  // Spot checks of single boxes against the measured map.
  const World arena = Arena();
  const auto box = [&arena](int id) { return arena.boxes[static_cast<std::size_t>(id) - 1]; };
  EXPECT_DOUBLE_EQ(box(59).pose.x, 0.18);  // the gates of the dock strip
  EXPECT_DOUBLE_EQ(box(61).pose.x, 3.24);
  EXPECT_DOUBLE_EQ(box(59).pose.y, 3.18);
  EXPECT_DOUBLE_EQ(box(60).size_y, 2.78);
  EXPECT_DOUBLE_EQ(box(25).pose.x, 1.74);
  EXPECT_DOUBLE_EQ(box(67).pose.yaw, Radians(45.0));
  // The vertical walls of the maze stand at 0.02 + 0.32 k.
  for (const Box& wall : arena.boxes) {
    if (wall.kind != "static" || wall.pose.yaw != 0.0 || wall.pose.y > 1.7) continue;
    const double pitch = (wall.pose.x - 0.02) / 0.32;
    // All but the wall of box 51, which stands half a cell off.
    if (wall.id != 51) {
      EXPECT_NEAR(pitch, std::round(pitch), 1e-9) << wall.id;
    }
  }
}

TEST(W09, ArenaIsAFileOfItsOwnInTheWorldsFolder) {
  const std::filesystem::path file = FindWorldFile("syrotek");
  EXPECT_EQ(file.filename(), "arena.json");
  EXPECT_EQ(file.parent_path().filename(), "models");
  EXPECT_TRUE(std::filesystem::is_regular_file(std::string(CCMORSE_SOURCE_DIR) +
                                               "/worlds/syrotek/models/arena.json"));
}

TEST(W11, ThirteenDocksAlongTheTopBorder) {
  const World arena = Arena();
  ASSERT_EQ(arena.docks.size(), 13U);
  for (std::size_t k = 0; k < arena.docks.size(); ++k) {
    EXPECT_NEAR(arena.docks[k].x, 0.15 + 0.26 * static_cast<double>(k), 1e-9);
    EXPECT_GT(arena.docks[k].y, 3.50);
    EXPECT_LT(arena.docks[k].y, 3.68);
    EXPECT_NEAR(arena.docks[k].yaw, -kPi / 2.0, 1e-12);
    // 0.18 m of free bay between the separators.
    for (const Box& box : arena.boxes) {
      const Pose2 bay{arena.docks[k].x, 3.59, 0.0};
      EXPECT_FALSE(box.raised && ConvexOverlap(BoxCorners(bay, 0.18 - 1e-6, 0.18 - 1e-6),
                                               BoxCorners(box.pose, box.size_x, box.size_y)))
          << "dock " << k << ", box " << box.id;
    }
  }
}

TEST(W11, ThirteenRobotsParkInThirteenDocks) {
  const Scenario docks = Named("docks");
  ASSERT_EQ(docks.robots.size(), 13U);
  std::set<std::string> names;
  std::set<std::array<int, 3>> colors;
  std::set<int> indexes;
  for (std::size_t k = 0; k < 13; ++k) {
    const RobotDef& robot = docks.robots[k];
    EXPECT_EQ(robot.name, "s1r_" + std::to_string(k + 1));
    EXPECT_NEAR(robot.pose.x, docks.world.docks[k].x, 1e-9);
    EXPECT_NEAR(robot.pose.y, docks.world.docks[k].y, 1e-9);
    EXPECT_NEAR(robot.pose.yaw, docks.world.docks[k].yaw, 1e-12);
    names.insert(robot.name);
    colors.insert({robot.color.r, robot.color.g, robot.color.b});
    for (const auto& [index, device] : robot.proxies.at("position2d")) {
      EXPECT_TRUE(indexes.insert(index).second) << index;
    }
  }
  EXPECT_EQ(names.size(), 13U);
  EXPECT_EQ(colors.size(), 13U);
}

TEST(W11, MapOfTheCourseHas17ObstaclesUp) {
  std::vector<int> up;
  for (const Box& box : Named("course_map").world.boxes) {
    if (box.dynamic && box.raised) up.push_back(box.id);
  }
  EXPECT_EQ(up,
            (std::vector<int>{5, 10, 19, 22, 23, 61, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76}));
}

// The course's map of the arena: 171 x 186 cells of 2 cm, row 0 at the top.
class CourseMap {
 public:
  static constexpr int kWidth = 171;
  static constexpr int kHeight = 186;

  // Walls come out one cell wider than the boxes, as in the course's own map; it leaves out the
  // dock separators (specs: syrotek.md B).
  explicit CourseMap(const World& world) : wall_(kWidth * kHeight, false) {
    constexpr double kCell = 0.02;
    constexpr double kGrown = kCell + 2e-6;  // cell centres on the edge belong to the wall
    for (const Box& box : world.boxes) {
      if (!box.raised || box.kind == "dock_separator") continue;
      const auto outline = BoxCorners(box.pose, box.size_x + kGrown, box.size_y + kGrown);
      for (int row = 0; row < kHeight; ++row) {
        for (int x = 0; x < kWidth; ++x) {
          const Vec2 centre{(x + 0.5) * kCell, (kHeight - row - 0.5) * kCell};
          if (Contains(outline, centre)) wall_[Cell(x, row)] = true;
        }
      }
    }
  }

  void Dilate(int radius) {
    const std::vector<bool> before = wall_;
    for (int row = 0; row < kHeight; ++row) {
      for (int x = 0; x < kWidth; ++x) {
        if (!before[Cell(x, row)]) continue;
        for (int dy = -radius; dy <= radius; ++dy) {
          for (int dx = -radius; dx <= radius; ++dx) {
            const bool inside =
                x + dx >= 0 && x + dx < kWidth && row + dy >= 0 && row + dy < kHeight;
            if (inside && dx * dx + dy * dy <= radius * radius)
              wall_[Cell(x + dx, row + dy)] = true;
          }
        }
      }
    }
  }

  // Free cells that can be reached from (x, row) over eight neighbours.
  std::set<std::size_t> Reachable(int x, int row) const {
    std::set<std::size_t> reached;
    if (wall_[Cell(x, row)]) return reached;
    std::deque<std::pair<int, int>> open = {{x, row}};
    reached.insert(Cell(x, row));
    while (!open.empty()) {
      const auto [cx, cy] = open.front();
      open.pop_front();
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const int nx = cx + dx;
          const int ny = cy + dy;
          if (nx < 0 || ny < 0 || nx >= kWidth || ny >= kHeight || wall_[Cell(nx, ny)]) continue;
          if (reached.insert(Cell(nx, ny)).second) open.emplace_back(nx, ny);
        }
      }
    }
    return reached;
  }

  std::size_t FreeCells() const {
    return static_cast<std::size_t>(std::count(wall_.begin(), wall_.end(), false));
  }

  static std::size_t Cell(int x, int row) { return static_cast<std::size_t>(row * kWidth + x); }

 private:
  std::vector<bool> wall_;
};

TEST(W08, CourseMapKeepsItsWaysUntilItIsDilatedBySixCells) {
  const World world = Named("course_map").world;
  const std::size_t goal = CourseMap::Cell(160, 175);
  for (const int radius : {0, 1, 2, 3, 4, 5}) {
    CourseMap map(world);
    map.Dilate(radius);
    EXPECT_TRUE(map.Reachable(26, 13).contains(goal)) << radius;
    if (radius == 4 || radius == 5) {
      EXPECT_EQ(map.Reachable(26, 13).size(), map.FreeCells()) << radius;
    }
  }
  CourseMap map(world);
  map.Dilate(6);
  EXPECT_FALSE(map.Reachable(26, 13).contains(goal));
}

TEST(W11, DynamicObstaclesDivideTheArena) {
  // With every door shut the hall is cut off from the docks; with all of them open it is not.
  const std::string shut = R"({"obstacles": {"up": [18, 19, 56, 57, 63, 65]}, "robots": []})";
  const auto joined = [](const std::string& text) {
    CourseMap map(ParseScenario(text, "test.json").world);
    map.Dilate(4);
    return map.Reachable(26, 13).contains(CourseMap::Cell(60, 86));
  };
  EXPECT_FALSE(joined(shut));
  EXPECT_TRUE(joined(R"({"robots": []})"));
}

}  // namespace
}  // namespace ccmorse::scene
