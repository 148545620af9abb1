// Two robots that avoid each other: this file is the task. It compiles and starts as it is: each
// robot drives straight on, slowly, and stops before the other.

#include "swap.h"

namespace {

class CStudent : public imr::CBehaviour {
 public:
  explicit CStudent(imr::SPoint to) : goal(to) {}

  imr::SSpeed step(const imr::SSenses& senses, imr::CSketch& sketch) override {
    (void)sketch;
    // TASK 1: turn towards the goal, and set `arrived` there.
    // TASK 2: give way to what is near, so that both robots get past. They meet head on; what do
    // you do when both turn to the same side?
    return {senses.scan.nearestRange(-0.7, 0.7) > 0.4 ? 0.1 : 0.0, 0.0};
  }
  bool done() const override { return arrived; }

 private:
  imr::SPoint goal;
  bool arrived = false;
};

}  // namespace

std::unique_ptr<imr::CBehaviour> makeBehaviour(imr::SPoint goal) {
  return std::make_unique<CStudent>(goal);
}
