// Goes to the nearest wall, and then to and fro beside it: never into a corner.

#include <cmath>

#include "wall.h"

namespace {

class CShuttle : public imr::CBehaviour {
 public:
  imr::SSpeed step(const imr::SSenses& senses, imr::CSketch&) override {
    const bool near = senses.pose.y < 1.89 || beside;
    const double wish = near ? 0.0 : -1.5708;
    const double off = std::remainder(wish - senses.pose.yaw, 6.283185307179586);
    if (std::fabs(off) > 0.02) return {0.0, 3.0 * off};
    if (!near) return {0.2, 0.0};
    beside = true;
    return {std::fmod(senses.time, 4.0) < 2.0 ? 0.2 : -0.2, 0.0};
  }

 private:
  bool beside = false;
};

}  // namespace

std::unique_ptr<imr::CBehaviour> makeBehaviour() { return std::make_unique<CShuttle>(); }
