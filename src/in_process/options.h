#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/log.h"
#include "servers/runner.h"

namespace ccmorse::in_process {

/// What the address of a simulation within the program asks for, "sim:" taken off: a scenario as
/// `ccmorse run` takes it, and options after '?', as of a URI. What is not set comes from the
/// scenario.
struct Options {
  std::string scenario;  ///< name or path
  std::optional<servers::Pace> pace;
  std::optional<double> factor;       ///< simulated s per wall-clock s in real time, > 0
  std::optional<std::uint64_t> seed;  ///< of all random numbers
  int threads = 0;                    ///< that share the work; 0: as many as are sensible
  double seconds = 0.0;               ///< "for": simulated time to run, s; 0: until closed
  int clients = 1;                    ///< lock-step: time starts when so many read
  std::string out = ".";              ///< folder for pictures that clients save
  std::string record;                 ///< MCAP file; "": none
  std::string report;                 ///< JSON file; "": none
  std::optional<LogLevel> log;        ///< lines on stderr, of all simulations of the program
  std::string name;                   ///< tells simulations of one scenario apart
};

/// Reads "SCENARIO?option=value&option=value". "%3F" stands for '?', and so on. Throws Error that
/// names the option and what it may be.
Options ParseOptions(std::string_view text);

}  // namespace ccmorse::in_process
