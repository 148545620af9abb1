#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "clearance.h"

namespace intro {

/// What a robot remembers of the ground, in cells of 5 cm around the place where it began: where it
/// was, and where else its middle could be.
class CMemory {
 public:
  /// Takes in what is seen now. The scan should be smooth.
  void remember(const imr::SSenses& senses) {
    here = {senses.pose.x, senses.pose.y};
    if (cells.empty()) {
      cells.resize(std::size_t{WIDTH} * WIDTH);
      middle = here;
    }
    now = senses.time;
    disc(here, 0.11, [](SCell& cell) { cell.covered = true; });
    for (double bearing = -2.2; bearing < 2.2; bearing += 0.1) {
      const double far = std::min(1.5, room(senses.scan, bearing));
      for (double d = 0.0; d < far; d += CELL / 2) {
        cell({here.x + d * std::cos(senses.pose.yaw + bearing),
              here.y + d * std::sin(senses.pose.yaw + bearing)})
            .free = true;
      }
    }
    SCell& at = cell(here);
    again = at.time >= 0.0 && now - at.time > RECENT && std::cos(at.yaw - senses.pose.yaw) > 0.5;
    at.time = now;
    at.yaw = senses.pose.yaw;
  }

  /// Whether it was here before, some time ago, on its way in about the same direction.
  bool isKnown() const { return again; }

  /// Whether the robot's body was at that point.
  bool isCovered(imr::SPoint point) { return cell(point).covered; }

  /// Looks for no new ground within a disc for so many seconds: it cannot be reached from here.
  void avoid(imr::SPoint around, double radius, double seconds) {
    disc(around, radius, [until = now + seconds](SCell& cell) { cell.avoided = until; });
  }

  /// Finds the nearest new ground, over all that was seen to be free, and a point on the way there
  /// about 0.15 m from here. False when there is none.
  bool findFresh(imr::SPoint& goal, imr::SPoint& next) const {
    std::vector<int> before(cells.size(), -1);
    std::vector<int> queue = {indexOf(here)};
    if (queue[0] < 0) return false;
    before[static_cast<std::size_t>(queue[0])] = queue[0];
    for (std::size_t i = 0; i < queue.size(); ++i) {
      int index = queue[i];
      if (isFresh(index)) {
        goal = middleOf(index);
        next = goal;
        while (index != queue[0] && std::hypot(next.x - here.x, next.y - here.y) > 0.15) {
          index = before[static_cast<std::size_t>(index)];
          next = middleOf(index);
        }
        return true;
      }
      for (const int step : {1, -1, WIDTH, -WIDTH, WIDTH + 1, WIDTH - 1, 1 - WIDTH, -1 - WIDTH}) {
        const int to = index + step;
        if (to < 0 || to >= WIDTH * WIDTH || !cells[static_cast<std::size_t>(to)].free ||
            before[static_cast<std::size_t>(to)] >= 0) {
          continue;
        }
        before[static_cast<std::size_t>(to)] = index;
        queue.push_back(to);
      }
    }
    return false;
  }

 private:
  static constexpr double CELL = 0.05;   // m
  static constexpr int WIDTH = 200;      // cells
  static constexpr double RECENT = 8.0;  // s: a younger track is the one that is being made

  struct SCell {
    double time = -1.0;    // when the robot was there, s; negative: never
    double yaw = 0.0;      // and where it looked, rad
    double avoided = 0.0;  // until when it is not looked for, s
    bool covered = false;  // the robot has been over it
    bool free = false;     // the robot's middle could be there
  };

  template <class Change>
  void disc(imr::SPoint around, double radius, Change change) {
    for (double dx = -radius; dx < radius + 0.01; dx += CELL / 2) {
      for (double dy = -radius; dy < radius + 0.01; dy += CELL / 2) {
        if (std::hypot(dx, dy) < radius) change(cell({around.x + dx, around.y + dy}));
      }
    }
  }

  // New ground is more than the edge of a track.
  bool isFresh(int index) const {
    int fresh = 0;
    for (int row = -2; row <= 2; ++row) {
      for (int column = -2; column <= 2; ++column) {
        const int i = index + row * WIDTH + column;
        if (i < 0 || i >= WIDTH * WIDTH) continue;
        const SCell& near = cells[static_cast<std::size_t>(i)];
        const bool is = near.free && !near.covered && near.avoided <= now;
        if (i == index && !is) return false;
        fresh += is ? 1 : 0;
      }
    }
    return fresh >= 9;
  }

  int indexOf(imr::SPoint point) const {
    const int column = WIDTH / 2 + static_cast<int>(std::floor((point.x - middle.x) / CELL));
    const int row = WIDTH / 2 + static_cast<int>(std::floor((point.y - middle.y) / CELL));
    const bool outside = column < 0 || column >= WIDTH || row < 0 || row >= WIDTH;
    return outside ? -1 : row * WIDTH + column;
  }
  imr::SPoint middleOf(int index) const {
    const int column = index % WIDTH - WIDTH / 2;
    const int row = index / WIDTH - WIDTH / 2;
    return {middle.x + (column + 0.5) * CELL, middle.y + (row + 0.5) * CELL};
  }
  SCell& cell(imr::SPoint point) {
    const int index = cells.empty() ? -1 : indexOf(point);
    return index < 0 ? nowhere : cells[static_cast<std::size_t>(index)];
  }

  std::vector<SCell> cells;  // WIDTH x WIDTH, row by row
  SCell nowhere;             // what lies outside
  imr::SPoint middle;        // of the cells, in the world
  imr::SPoint here;          // the robot
  double now = 0.0;          // s
  bool again = false;
};

}  // namespace intro
