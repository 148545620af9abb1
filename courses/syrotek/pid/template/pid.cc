// The PID controller: this file is the task. It compiles and starts as it is, with a P controller
// that is much too weak: the robot pulls to the right, and leaves its line.
//
// Find the three gains. Begin with P alone, and look at the picture each time.

#include "pid.h"

double CPid::control(double error, double dt) {
  constexpr double P = 0.5;
  // TASK 1: D damps: it takes the change of the error, (error - last) / dt, into account.
  // TASK 2: I removes what remains: it takes the error summed up over time into account. Limit the
  // sum, or it takes long to get over a large error.
  (void)dt;
  (void)sum;
  (void)last;
  return P * error;
}
