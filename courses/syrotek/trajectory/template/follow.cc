// Trajectory following: this file is the task. It compiles and starts as it is: the robot goes as
// fast as it should and turns as it should, and never looks where it is. It began 20 cm beside the
// trajectory, and stays there.
//
// Make the robot correct its error.

#include "trajectory.h"

imr::SSpeed follow(const imr::SPose& pose, const SWanted& wanted) {
  // TASK 1: express the error wanted.pose - pose in the robot's frame: how far the wanted pose is
  // ahead of the robot, how far to its left, and by what angle it is turned.
  (void)pose;
  // TASK 2: add to the speeds what makes the errors smaller.
  return {wanted.v, wanted.w};
}
