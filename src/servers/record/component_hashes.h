#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/simulation.h"

namespace ccmorse::servers {

/// The state of one part of a simulation as 64 bits.
struct ComponentHash {
  std::string name;  ///< "s1r.hokuyo" a sensor, "canvas", "s1r" a robot
  std::uint64_t value = 0;
};

/// Hashes the parts of a simulation, so that two runs can be told apart by tick and component. It
/// works from outside: a simulation that nobody hashes so pays nothing. Not thread safe.
class ComponentHasher {
 public:
  explicit ComponentHasher(const sim::Simulation& simulation) : simulation_(simulation) {}

  /// To be called after Act(), in the order of a tick: each sensor that took a sample in it, the
  /// sample; the canvas as it is; each robot, everything that it was and sensed up to now. Valid
  /// until the next call.
  const std::vector<ComponentHash>& Take();

 private:
  const sim::Simulation& simulation_;
  std::vector<ComponentHash> hashes_;
  std::uint64_t canvas_ = 0;
  std::uint64_t canvas_revision_ = 0;  // that canvas_ is of; 0: none yet
};

}  // namespace ccmorse::servers
