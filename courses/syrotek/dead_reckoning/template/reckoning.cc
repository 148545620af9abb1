// Dead reckoning: this file is the task. It compiles and starts as it is: the robot takes itself to
// be at the start all the time, calibrates, and gives up.

#include "reckoning.h"

void CReckoning::advance(const imr::SPose& last, const imr::SPose& now) {
  // TASK 1: work out how far the odometry went and by how much it turned, and move `pose` by as
  // much: on an arc whose chord has the direction in the middle of the turn. The odometry's frame
  // is not the world's.
  (void)last;
  (void)now;
}

void CReckoning::calibrateTurn(const imr::SScan& before, const imr::SScan& after, double counted) {
  // TASK 2: set turnFactor. After exactly one turn both scans would be equal; by how many beams is
  // one turned against the other?
  (void)before;
  (void)after;
  (void)counted;
}

void CReckoning::calibrateWay(const imr::SScan& before, const imr::SScan& after, double counted) {
  // TASK 3: set wayFactor. By how much has the wall ahead come nearer?
  (void)before;
  (void)after;
  (void)counted;
}
