#include "servers/record/component_hashes.h"

namespace ccmorse::servers {

const std::vector<ComponentHash>& ComponentHasher::Take() {
  hashes_.clear();
  for (const sim::Sensor* sensor : simulation_.sampled()) {
    sim::StateHash hash;
    sensor->AddToHash(hash);
    hashes_.push_back({sensor->full_name(), hash.value()});
  }
  // The canvas has thousands of cells and changes seldom.
  const sim::Canvas& canvas = simulation_.canvas();
  if (canvas_revision_ != canvas.revision()) {
    sim::StateHash hash;
    canvas.AddToHash(hash);
    canvas_ = hash.value();
    canvas_revision_ = canvas.revision();
  }
  hashes_.push_back({"canvas", canvas_});
  for (const auto& robot : simulation_.robots()) {
    hashes_.push_back({robot->name(), robot->hash().value()});
  }
  return hashes_;
}

}  // namespace ccmorse::servers
