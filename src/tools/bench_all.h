#pragma once

namespace ccmorse::tools {

struct BenchAllArguments {
  double seconds = 4.0;  ///< wall-clock time of each measurement of a fleet, > 0
  bool json = false;     ///< one JSON object instead of a table
};

/// `ccmorse bench all`: the figures of docs/performance.md as one table: what is required, what is
/// aimed at, what this machine does. Runs the other benchmarks as processes of their own, one after
/// the other; under 3 minutes with the seconds of the default. Returns the exit status: 0 when it
/// could measure, met or not.
int BenchAll(const BenchAllArguments& arguments);

}  // namespace ccmorse::tools
