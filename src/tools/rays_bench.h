#pragma once

namespace ccmorse::tools {

struct RaysArguments {
  double seconds = 1.0;  ///< wall-clock time for each figure, > 0
  bool json = false;     ///< one JSON object instead of a table
};

/// `ccmorse bench rays`: what a scan of 682 beams costs on one core, in the full SyRoTek arena (all
/// 90 boxes up, 360 edges) and in the arena of `ccmorse bench fleet` (56 edges). Prints rays per
/// second. Returns the exit status.
int BenchRays(const RaysArguments& arguments);

}  // namespace ccmorse::tools
