#pragma once

namespace ccmorse::tools {

/// What `ccmorse bench fleet` was asked for.
struct FleetArguments {
  int robots = 100;       ///< 1..10000
  double seconds = 10.0;  ///< simulated, > 0
  int threads = 0;        ///< that share the work; 0: all the machine has
  bool json = false;      ///< one JSON object instead of a table
};

/// `ccmorse bench fleet`: many robots, each in an arena of its own, with a laser and a controller
/// in process; the scenario with which other simulators were measured. Prints simulated seconds per
/// wall second, rays per second, memory, load time and the state hash. Returns the exit status.
int BenchFleet(const FleetArguments& arguments);

}  // namespace ccmorse::tools
