// The robot's behaviour: this file is the task. It compiles and starts as it is: the robot drives
// straight on, slowly, and stops before the first obstacle.
//
// Write step(), so that the robot drives around the arena, touches nothing and comes everywhere:
//   - like a Braitenberg vehicle: what is near on one side slows the wheel on the other;
//   - or along the wall, at a distance that you choose.
// You may add members, classes and files (OBJS in the Makefile) as you like.

#include "behaviour.h"

namespace {

class CStudent : public imr::CBehaviour {
 public:
  imr::SSpeed step(const imr::SSenses& senses, imr::CSketch& sketch) override {
    (void)sketch;  // sketch.line(...) draws what your robot thinks
    // TASK 1: look at both sides; senses.scan.nearestRange(from, to) is the range of the nearest
    // obstacle between two bearings, rad, counter-clockwise from straight ahead.
    const double ahead = senses.scan.nearestRange(-0.7, 0.7);
    // TASK 2: turn away from what is near. {v, w}: m/s forward, rad/s counter-clockwise.
    return {ahead > 0.3 ? 0.1 : 0.0, 0.0};
  }
};

}  // namespace

std::unique_ptr<imr::CBehaviour> makeBehaviour() { return std::make_unique<CStudent>(); }
