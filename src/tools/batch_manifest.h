#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ccmorse::tools {

/// One job of a manifest: a scenario, simulated once, with or without a program that drives in it.
struct BatchJob {
  int index = 0;         ///< place in the manifest, from 0
  std::string name;      ///< no two alike; 1 to 100 letters, digits and _ - . (not first)
  std::string scenario;  ///< as the manifest has it: a name or a path
  std::string program;   ///< as the manifest has it; "": the scenario alone
  std::vector<std::string> args;
  double seconds = 0.0;              ///< simulated, s; 0: until the program ends
  double timeout = 600.0;            ///< wall-clock time limit, s, > 0
  std::optional<std::int64_t> seed;  ///< >= 0; ResolveJobs fills in the scenario's own
  int scenario_line = 0;             ///< where the manifest names the scenario
  int program_line = 0;              ///< where it names the program

  // Filled in by ResolveJobs.
  std::string scenario_file;  ///< absolute
  std::string program_file;   ///< absolute; "": none
};

/// Reads and checks a manifest (docs/batch.md), without a look at the files that it names: first
/// the "jobs" in their order, then "scenarios" x "seeds" x "programs", the last varying fastest.
/// `file` names it in messages. Throws Error "FILE:LINE: ..." with the nearest known key.
std::vector<BatchJob> ParseManifest(const std::string& text, const std::string& file);

/// ParseManifest of a file; then finds each job's scenario and program, relative paths starting at
/// the manifest's folder, and reads each scenario once, so that no mistake in one is found only
/// after hours. Throws Error "FILE:LINE: ...".
std::vector<BatchJob> LoadManifest(const std::string& file);

}  // namespace ccmorse::tools
