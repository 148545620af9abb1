#pragma once

#include <vector>

#include "sim/service.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// The services of `arena`, which raise, lower and move dynamic boxes (thesis 5.1, N01 to N04;
/// docs/protocols/ccmorse-services.md). The simulation outlives them.
std::vector<sim::Service> ArenaServices(sim::Simulation& simulation);

}  // namespace ccmorse::servers
