#pragma once

#include <cstdint>
#include <string>

#include "base/json.h"
#include "servers/runner.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// Samples of a robot's laser scanners: how many there were, and how many of them clients fetched.
struct LaserUse {
  std::uint64_t scans = 0;
  std::uint64_t used = 0;
};
LaserUse CountScans(const sim::Robot& robot, const MorseServer& server);

/// What `ccmorse run --report` writes: scenario, pace, ticks, times, the state hash and each
/// robot's way (docs/scenario.md).
Json ReportJson(const sim::Simulation& simulation, const MorseServer& server,
                const RunSummary& summary, Pace pace);

/// Writes a report. Throws Error.
void WriteReport(const Json& report, const std::string& file);

/// Makes the folder that a file is to be written into and tries to write there, so that a long run
/// cannot fail at its end. Nothing for "". Throws Error.
void PrepareFile(const std::string& file);

}  // namespace ccmorse::servers
