#pragma once

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

namespace ccmorse::bench {

using Clock = std::chrono::steady_clock;

/// Wall-clock time since `start`, s.
double Since(Clock::time_point start);

/// The value below which that share (0..1) of the values lies; `values` is not empty.
double Quantile(std::vector<double> values, double share);

/// A scenario's JSON with data 60 times a second: many of them in a short time.
inline constexpr const char* kFrequent = R"({"time": {"read_frequency": 60}})";

/// A scenario in a file that goes with the object.
class ScenarioFile {
 public:
  /// Throws std::runtime_error.
  explicit ScenarioFile(const std::string& json);
  ~ScenarioFile();
  ScenarioFile(const ScenarioFile&) = delete;
  ScenarioFile& operator=(const ScenarioFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// `ccmorse run` as a child process, on free ports; killed with the object.
class Simulator {
 public:
  /// Whether it serves the live view.
  enum class View { kNone, kServed };

  /// Returns when it listens. `ccmorse`: the program's path; `pace`: real, lockstep; `player_port`:
  /// of the first robot, those of the others follow; 0: any free ones; a served view has one thread
  /// simulate, so that processor time tells how far it came. Throws std::runtime_error when it does
  /// not start.
  Simulator(const std::string& ccmorse, const std::string& scenario, const std::string& pace,
            int player_port = 0, View view = View::kNone);
  ~Simulator();
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  int port() const { return port_; }                ///< MORSE's services
  int player_port() const { return player_port_; }  ///< Player's protocol, the first robot's
  int view_port() const { return view_port_; }      ///< the live view; 0: none
  /// Processor time that it has used, s; in steps of 10 ms.
  double ProcessorTime() const;

 private:
  int child_ = -1;
  std::FILE* output_ = nullptr;
  int port_ = 0;
  int player_port_ = 0;
  int view_port_ = 0;
};

}  // namespace ccmorse::bench
