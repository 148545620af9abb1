// The path planner: this file is the task. It compiles and starts as it is, and finds nothing.
//
// Write the four functions in this order; after each, `make run` shows what you have:
//   1. inflateMap    the light blue around the walls
//   2. dijkstra      the dark blue path; CHeap in imr-h/dijkstra_heap.h is the queue for it
//   3. bresenham     nothing to see yet, but the next one needs it
//   4. smooth_path   the orange path
// You may add classes, functions and files (OBJS in the Makefile) as you like.

#include "planner.h"

#include "imr-h/dijkstra_heap.h"

namespace imr {

void CPlanner::inflateMap(const CMapGrid& map) {
  // TASK 1: set free[at({x, y})] = 1 for each cell that is farther than DILATION cells from every
  // cell that is not CMapGrid::FLOOR, middle to middle.
  (void)map;
}

bool CPlanner::dijkstra(SCell start, SCell goal) {
  // TASK 2: find the cheapest path through free cells, and append its cells to `path`, the start
  // first, the goal last. Return whether there is one.
  (void)start;
  (void)goal;
  return false;
}

bool CPlanner::bresenham(SCell from, SCell to) const {
  // TASK 3: return whether all cells that the line from `from` to `to` meets are free.
  (void)from;
  (void)to;
  return false;
}

void CPlanner::smooth_path() {
  // TASK 4: append the corners of a smoother path to `smooth`, the start first, the goal last.
}

}  // namespace imr
