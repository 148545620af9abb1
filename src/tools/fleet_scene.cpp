#include "tools/fleet_scene.h"

#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "base/trig.h"
#include "scene/robots.h"

namespace ccmorse::tools {
namespace {

// The arena: 3.72 x 3.42 m inside, walls 5 cm thick, ten boxes of 0.30 m, five of them turned.
constexpr double kInsideX = 3.72;
constexpr double kInsideY = 3.42;
constexpr double kWall = 0.05;
constexpr double kPitchX = kInsideX + 2 * kWall;
constexpr double kPitchY = kInsideY + 2 * kWall;
constexpr double kHeight = 0.3;
constexpr double kBox = 0.30;
constexpr Pose2 kBoxes[] = {
    {0.60, 0.60, 0.0}, {1.85, 0.45, 0.5}, {3.10, 0.70, 0.0}, {0.50, 1.70, 0.7}, {3.20, 1.75, 0.3},
    {0.70, 2.80, 0.0}, {1.40, 3.05, 0.0}, {2.30, 2.90, 0.9}, {3.15, 2.75, 0.0}, {1.20, 1.10, 1.1}};

void AddArena(Vec2 corner, std::vector<scene::Box>& boxes) {
  const auto add = [&](Pose2 at, double size_x, double size_y) {
    scene::Box box;
    box.id = static_cast<int>(boxes.size()) + 1;
    box.kind = "static";
    box.pose = {corner.x + at.x, corner.y + at.y, at.yaw};
    box.size_x = size_x;
    box.size_y = size_y;
    box.height = kHeight;
    boxes.push_back(box);
  };
  add({kPitchX / 2, kWall / 2, 0}, kPitchX, kWall);
  add({kPitchX / 2, kPitchY - kWall / 2, 0}, kPitchX, kWall);
  add({kWall / 2, kPitchY / 2, 0}, kWall, kInsideY);
  add({kPitchX - kWall / 2, kPitchY / 2, 0}, kWall, kInsideY);
  for (const Pose2& box : kBoxes) add({box.x + kWall, box.y + kWall, box.yaw}, kBox, kBox);
}

}  // namespace

scene::Scenario MakeFleet(int robots) {
  scene::Scenario scenario;
  scenario.name = "fleet";
  const int columns = static_cast<int>(std::ceil(std::sqrt(robots)));
  for (int i = 0; i < robots; ++i) {
    const int row = i / columns;
    const Vec2 corner{i % columns * kPitchX, row * kPitchY};
    AddArena(corner, scenario.world.boxes);
    scene::RobotDef robot;
    robot.name = fmt::format("r{:05}", i);
    robot.type = "BoxRobot";
    robot.pose = {corner.x + kPitchX / 2, corner.y + kPitchY / 2,
                  NormalizeAngle(Radians(37.0 * i))};
    robot.laser = scene::FindRobotModel(robot.type).laser;
    scenario.robots.push_back(robot);
  }
  scenario.world.name = "fleet";
  scenario.world.size_x = columns * kPitchX;
  scenario.world.size_y = columns * kPitchY;
  scenario.canvas.width = scenario.canvas.height = 1;
  return scenario;
}

}  // namespace ccmorse::tools
