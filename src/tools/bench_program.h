#pragma once

#include <string>

namespace ccmorse::tools {

/// What a benchmark in a program of its own was asked for.
struct BenchProgramArguments {
  double seconds = 2.0;  ///< wall-clock time of each measurement
  bool json = false;     ///< one JSON object instead of a table
};

/// Executes ccmorse-bench-NAME, which lies beside this program, in its place; so it returns only by
/// throwing. Throws Error when there is none.
[[noreturn]] void ExecuteBench(const std::string& name, const BenchProgramArguments& arguments);

}  // namespace ccmorse::tools
