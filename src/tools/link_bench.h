#pragma once

namespace ccmorse::tools {

/// What `ccmorse bench link` was asked for.
struct LinkArguments {
  double seconds = 2.0;  ///< wall-clock time of each measurement
  bool json = false;     ///< one JSON object instead of a table
};

/// `ccmorse bench link`: executes ccmorse-bench-link, which lies beside this program, in its place;
/// so it returns only by throwing. Throws Error when there is none.
[[noreturn]] void BenchLink(const LinkArguments& arguments);

}  // namespace ccmorse::tools
