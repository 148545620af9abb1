// Wall following: this file is the task. It compiles and starts as it is: the robot drives straight
// on, slowly, and stops before the wall.
//
// Write step(), so that the robot keeps the wall on its right at WALL_DISTANCE.

#include "wall.h"

namespace {

class CStudent : public imr::CBehaviour {
 public:
  imr::SSpeed step(const imr::SSenses& senses, imr::CSketch& sketch) override {
    (void)sketch;
    const imr::SScan& scan = senses.scan;
    // TASK 1: find the nearest point of the wall on the right: scan.nearest(from, to) is its beam,
    // scan.bearing(beam) where it is, rad, and scan.point(beam) where it is from the robot's
    // middle.
    // TASK 2: from the error of the distance, its change (senses.since, s), and the angle of the
    // nearest point, which should be -90 degrees, make a turn rate: a PD controller.
    // TASK 3: in front of a wall, turn left.
    return {scan.nearestRange(-0.7, 0.7) > 0.3 ? 0.1 : 0.0, 0.0};
  }
};

}  // namespace

std::unique_ptr<imr::CBehaviour> makeBehaviour() { return std::make_unique<CStudent>(); }
