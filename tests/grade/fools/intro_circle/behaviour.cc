// Looks at nothing, and drives in a small circle for five minutes: that touches nothing, hardly
// ever, and is no avoidance.

#include "behaviour.h"

namespace {

class CCircle : public imr::CBehaviour {
 public:
  imr::SSpeed step(const imr::SSenses&, imr::CSketch&) override { return {0.15, 1.8}; }
};

}  // namespace

std::unique_ptr<imr::CBehaviour> makeBehaviour() { return std::make_unique<CCircle>(); }
