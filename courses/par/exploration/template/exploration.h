#pragma once

#include <cstdint>
#include <vector>

#include "control.h"
#include "imr-h/map_grid.h"
#include "imr-h/thread.h"
#include "plan.h"

namespace imr {

/// The thread that plans (thesis 4.3.3): takes a copy of the map from CControl, dilates its
/// obstacles, finds the frontiers, plans to one of them and hands the plan back; B. Yamauchi, "A
/// frontier-based approach for autonomous exploration", 1997.
class CExploration : public imr::concurrent::CThread {
 public:
  /// Obstacles are dilated by so many cells. One more than in the planning task: the map is what
  /// the laser saw, and its walls begin at their surfaces.
  static constexpr int DILATION = 6;

  /// `source`, where the maps come from, outlives the object.
  explicit CExploration(CControl& source) : control(source) {}
  /// Stops the control with it, which is what the thread waits for.
  ~CExploration() override {
    stop();
    join();
  }
  void stop() override { control.stop(); }

  /// The plan for a map and a position. Without a frontier that can be reached, it is done.
  SPlan plan(const CMapGrid& seen, const SPosition& position);

 protected:
  void threadBody() override;

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(map.getWidth()) +
           static_cast<std::size_t>(x);
  }

  // --- What a student writes, in exploration.cc

  /// Writes into `free` where the robot's middle may be, and into made.inflated what is dilated.
  void inflateMap(SPlan& made);
  /// Appends the cells at the border of the unknown to made.frontiers.
  void detectFrontiers(SPlan& made);
  /// Writes the costs of the ways from `start` into `cost` and `previous`.
  void dijkstra(SCell start);
  /// Which of `frontiers` to go to; -1 when none can be reached.
  int chooseFrontier(const std::vector<SCell>& frontiers);
  /// The corners of a smoothed path.
  std::vector<SCell> smooth(const std::vector<SCell>& path) const;
  /// The free cell nearest to the robot, where it is in none.
  SCell freeCellNear(SCell cell) const;

  CControl& control;
  CMapGrid map{1, 1, MAP_CELL_SIZE};
  // height x width, row by row from the bottom.
  std::vector<std::uint8_t> free;  // 1: seen, free and not dilated
  std::vector<double> cost;        // cells to go; infinite where there is no way
  std::vector<int> previous;       // index of the cell before on the way; -1 at the start
  int without = 0;                 // plans in a row without a frontier that can be reached
};

}  // namespace imr
