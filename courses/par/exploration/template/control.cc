// Gathering data and driving: the first part of the task, with map_grid.cc. Compiles and starts as
// it is; the robot then stands and sees nothing.

#include "control.h"

namespace imr {

void CControl::updateMap() {
  // TASK 1: for each beam of `laser`, work out where it ends in the world, and hand it on to
  // map.updateCells(). The laser sits laser->GetPose().px m before the robot's middle. Then `make
  // run` shows white and black in the grey.
}

void CControl::followPath(double& v, double& w) {
  // TASK 4: `next` counts the corners of plan.path that have been reached; it is 0 with a new plan.
  // Turn towards the next corner, and go there. Without a path, stand.
  v = 0.0;
  w = 0.0;
}

}  // namespace imr
