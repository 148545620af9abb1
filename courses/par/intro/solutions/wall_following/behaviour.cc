// Wall following: keeps the wall on the right, and crosses over to new ground where it has been.

#include "behaviour.h"

#include <vector>

#include "clearance.h"

namespace {

using intro::PI;

constexpr double FASTEST = 0.4;       // m/s
constexpr double FASTEST_TURN = 2.5;  // rad/s
constexpr double AHEAD = 0.12;        // m that have to be free in a direction to take it
constexpr double RADIUS = 0.12;       // m, of the turn around the end of a wall
constexpr double WALL = 0.35;         // m to the laser: as near is a wall to follow
constexpr double FRESH = 15.0;        // s: a track that is younger is the one that is being made

class CWallFollower : public imr::CBehaviour {
 public:
  imr::SSpeed step(const imr::SSenses& senses, imr::CSketch& sketch) override {
    remember(senses);
    const double direction = choose(senses);
    sketch.clear(WAY);
    sketch.line(WAY, at(senses.pose, 0.0, 0.0), at(senses.pose, direction, 0.3));
    const double straight = std::max(0.0, std::cos(direction));
    double v = FASTEST * straight * straight;
    double w = std::clamp(5.0 * direction, -FASTEST_TURN, FASTEST_TURN);
    if (!crossing && w < 0.0) {
      // Around the end of a wall, and not on the spot: beside the robot and behind it the laser
      // sees too little to turn there.
      v = std::max(v, 0.15);
      w = std::max(w, -v / RADIUS);
    }
    return intro::careful(senses.scan, {v, w});
  }

 private:
  static constexpr imr::CSketch::SInk WAY = {"direction", 255, 165, 0};
  static constexpr int SIZE = 100;      // cells of the memory to either side of where it began
  static constexpr double CELL = 0.05;  // m

  // A point in the world, by bearing and distance from the robot.
  static imr::SPoint at(const imr::SPose& pose, double bearing, double distance) {
    return {pose.x + distance * std::cos(pose.yaw + bearing),
            pose.y + distance * std::sin(pose.yaw + bearing)};
  }

  // The bearing to go to.
  double choose(const imr::SSenses& senses) {
    const imr::SScan& scan = senses.scan;
    const bool wall = scan.nearestRange(-2.4, 0.5) < WALL;
    if (crossing && (senses.time - moved > 2.0 || cell(goal).covered)) {
      cell(goal).covered = true;  // arrived, or it cannot be reached
      crossing = false;
      since = senses.time;
    }
    if (!crossing && (known(senses) || !wall) && senses.time - since > 2.0) crossing = true;
    if (crossing) {
      imr::SPoint next;
      if (findFresh(senses, next)) {
        return std::remainder(
            std::atan2(next.y - senses.pose.y, next.x - senses.pose.x) - senses.pose.yaw, 2 * PI);
      }
      crossing = false;
      since = senses.time;
    }
    // Out of a corner: on the spot, to the left, until there is room ahead.
    if (corner && intro::room(scan, 0.0) < AHEAD) return 1.6;
    corner = false;
    // The right-most direction that is free; without a wall, straight on.
    for (double bearing = wall ? -1.3 : 0.0; bearing < 0.8; bearing += 0.05) {
      if (intro::room(scan, bearing) >= AHEAD) return bearing;
    }
    corner = true;
    return 1.6;
  }

  // Whether the robot was here before, some time ago, on its way in about the same direction.
  bool known(const imr::SSenses& senses) {
    const SCell& here = cell(at(senses.pose, 0.0, 0.0));
    return here.time >= 0.0 && senses.time - here.time > FRESH &&
           std::cos(here.yaw - senses.pose.yaw) > 0.5;
  }

  // Finds the nearest new ground, over all that was seen to be free, and a point on the way there.
  bool findFresh(const imr::SSenses& senses, imr::SPoint& next) {
    std::vector<int> before(memory.size(), -1);
    std::vector<int> queue = {indexOf(at(senses.pose, 0.0, 0.0))};
    if (queue[0] < 0) return false;
    before[static_cast<std::size_t>(queue[0])] = queue[0];
    for (std::size_t i = 0; i < queue.size(); ++i) {
      int index = queue[i];
      if (isFresh(index)) {
        goal = middleOf(index);
        // Back along the way, to about 0.15 m from here.
        while (before[static_cast<std::size_t>(index)] != queue[0] && index != queue[0]) {
          next = middleOf(index);
          if (std::hypot(next.x - senses.pose.x, next.y - senses.pose.y) < 0.15) return true;
          index = before[static_cast<std::size_t>(index)];
        }
        next = middleOf(index);
        return true;
      }
      for (const int step : {1, -1, 2 * SIZE, -2 * SIZE, 2 * SIZE + 1, 2 * SIZE - 1, 1 - 2 * SIZE,
                             -1 - 2 * SIZE}) {
        const int to = index + step;
        if (to < 0 || to >= 4 * SIZE * SIZE || !memory[static_cast<std::size_t>(to)].free ||
            before[static_cast<std::size_t>(to)] >= 0) {
          continue;
        }
        before[static_cast<std::size_t>(to)] = index;
        queue.push_back(to);
      }
    }
    return false;
  }

  // New ground is more than one cell.
  bool isFresh(int index) const {
    int fresh = 0;
    for (int row = -1; row <= 1; ++row) {
      for (int column = -1; column <= 1; ++column) {
        const int i = index + row * 2 * SIZE + column;
        if (i < 0 || i >= 4 * SIZE * SIZE) continue;
        const SCell& near = memory[static_cast<std::size_t>(i)];
        if (near.free && !near.covered) ++fresh;
        if (i == index && (!near.free || near.covered)) return false;
      }
    }
    return fresh >= 3;
  }

  void remember(const imr::SSenses& senses) {
    const imr::SPoint here = at(senses.pose, 0.0, 0.0);
    if (memory.empty()) {
      memory.resize(static_cast<std::size_t>(4 * SIZE * SIZE));
      middle = here;
    }
    for (double dx = -0.1; dx < 0.11; dx += CELL) {
      for (double dy = -0.1; dy < 0.11; dy += CELL) {
        if (std::hypot(dx, dy) < 0.11) cell({here.x + dx, here.y + dy}).covered = true;
      }
    }
    for (double bearing = -2.2; bearing < 2.2; bearing += 0.1) {
      const double far = std::min(1.5, intro::room(senses.scan, bearing));
      for (double d = 0.0; d < far; d += CELL / 2) cell(at(senses.pose, bearing, d)).free = true;
    }
    SCell& now = cell(here);
    now.time = senses.time;
    now.yaw = senses.pose.yaw;
    if (std::hypot(here.x - last.x, here.y - last.y) > 0.05 || !crossing) {
      last = here;
      moved = senses.time;
    }
  }

  struct SCell {
    double time = -1.0;    // when the robot was there, s; negative: never
    double yaw = 0.0;      // and where it looked, rad
    bool covered = false;  // the robot has been over it
    bool free = false;     // the robot's middle could be there
  };

  int indexOf(imr::SPoint point) const {
    const int column = SIZE + static_cast<int>(std::floor((point.x - middle.x) / CELL));
    const int row = SIZE + static_cast<int>(std::floor((point.y - middle.y) / CELL));
    const bool outside = column < 0 || column >= 2 * SIZE || row < 0 || row >= 2 * SIZE;
    return outside ? -1 : row * 2 * SIZE + column;
  }
  imr::SPoint middleOf(int index) const {
    return {middle.x + (index % (2 * SIZE) - SIZE + 0.5) * CELL,
            middle.y + (index / (2 * SIZE) - SIZE + 0.5) * CELL};
  }
  SCell& cell(imr::SPoint point) {
    const int index = memory.empty() ? -1 : indexOf(point);
    return index < 0 ? nowhere : memory[static_cast<std::size_t>(index)];
  }

  std::vector<SCell> memory;  // 2 SIZE x 2 SIZE, row by row
  SCell nowhere;              // what lies outside
  imr::SPoint middle;         // where the memory's middle is in the world
  imr::SPoint goal;           // of the crossing
  imr::SPoint last;           // where the robot was when it last moved on
  double moved = 0.0;         // and when, s
  double since = 0.0;         // the end of the last crossing, s
  bool crossing = false;
  bool corner = false;
};

}  // namespace

std::unique_ptr<imr::CBehaviour> makeBehaviour() { return std::make_unique<CWallFollower>(); }
