// What a scan tells of cells: the first part of the task. imr-h/map_grid.h says what these two are
// to do.

#include "imr-h/map_grid.h"

namespace imr {

void CMapGrid::updateCell(int x, int y, double occupied) {
  // TASK 1: move the value of the cell towards `occupied`, by as much as one measurement is worth.
  (void)x;
  (void)y;
  (void)occupied;
}

void CMapGrid::updateCells(int rx, int ry, int cx, int cy, double dist) {
  // TASK 1: updateCell() for all cells on the line.
  (void)rx;
  (void)ry;
  (void)cx;
  (void)cy;
  (void)dist;
}

}  // namespace imr
