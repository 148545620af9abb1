#include "tests/end_to_end/arena_floor.h"

#include <cmath>
#include <utility>

namespace ccmorse::testing {

Floor TrueWalls(const scene::World& world) {
  Floor walls;
  for (int y = 0; y < kFloorHeight; ++y) {
    for (int x = 0; x < kFloorWidth; ++x) {
      bool wall = false;
      for (const scene::Box& box : world.boxes) {
        if (!box.raised) continue;
        const double east = (x + 0.5) * kFloorCell - box.pose.x;
        const double north = (y + 0.5) * kFloorCell - box.pose.y;
        const double along = std::cos(box.pose.yaw) * east + std::sin(box.pose.yaw) * north;
        const double across = std::cos(box.pose.yaw) * north - std::sin(box.pose.yaw) * east;
        wall |= std::fabs(along) <= box.size_x / 2 && std::fabs(across) <= box.size_y / 2;
      }
      walls.push_back(wall ? 1 : 0);
    }
  }
  return walls;
}

Floor Grown(const Floor& cells, int radius) {
  Floor grown(cells.size(), 0);
  for (int y = 0; y < kFloorHeight; ++y) {
    for (int x = 0; x < kFloorWidth; ++x) {
      if (cells[FloorAt(x, y)] == 0) continue;
      for (int dy = -radius; dy <= radius; ++dy) {
        for (int dx = -radius; dx <= radius; ++dx) {
          if (dx * dx + dy * dy <= radius * radius && OnFloor(x + dx, y + dy)) {
            grown[FloorAt(x + dx, y + dy)] = 1;
          }
        }
      }
    }
  }
  return grown;
}

Floor ReachableMiddles(const scene::World& world) {
  const Floor blocked = Grown(TrueWalls(world), 5);
  Floor middles(blocked.size(), 0);
  std::vector<std::pair<int, int>> next = {{60, 100}};
  middles[FloorAt(60, 100)] = 1;
  while (!next.empty()) {
    const auto [x, y] = next.back();
    next.pop_back();
    for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      if (!OnFloor(x + dx, y + dy) || blocked[FloorAt(x + dx, y + dy)] != 0) continue;
      if (middles[FloorAt(x + dx, y + dy)] != 0) continue;
      middles[FloorAt(x + dx, y + dy)] = 1;
      next.emplace_back(x + dx, y + dy);
    }
  }
  return middles;
}

Floor Reachable(const scene::World& world) { return Grown(ReachableMiddles(world), 5); }

}  // namespace ccmorse::testing
