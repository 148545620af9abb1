#pragma once

#include <poll.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "grade/report.h"
#include "grade/rubric.h"
#include "tools/child_process.h"
#include "tools/sandbox.h"
#include "tools/submission.h"

namespace ccmorse::tools {

/// One run of a submission in the world of a seed: the simulator as a process of its own, in
/// lock-step and as a contest, which writes a record; and the program, in a sandbox whose only way
/// out is the socket on which the simulator listens. Whatever the program does becomes the run's
/// report. All processes end with the object. Not thread safe.
class GradeRun {
 public:
  using Clock = std::chrono::steady_clock;

  struct Options {
    std::string simulator;  ///< path of the `ccmorse` program
    std::string folder;     ///< the run's own, absolute; made
    std::string record;     ///< file that the record goes to
    bool sandbox = true;
  };

  /// Starts it. Throws Error when the world cannot be made or a process not be started.
  GradeRun(const grade::Rubric& rubric, std::uint64_t seed, const Submission& submission,
           const Options& options);
  GradeRun(const GradeRun&) = delete;
  GradeRun& operator=(const GradeRun&) = delete;

  void AddPolled(std::vector<pollfd>& polled) const;
  /// Does what is to be done now; true when the run is over.
  bool Step();
  /// After Step() said true: judges the record. `record` in it is empty.
  grade::RunReport Report();

 private:
  void StartSandbox();
  void StartSimulator(int listener);
  void StartProgram(int port);
  void TakeOutput();
  void Fail(const std::string& why);
  void LookAtProgram();
  ChildProcess* Program() const;

  const grade::Rubric& rubric_;
  std::uint64_t seed_;
  const Submission& submission_;
  Options options_;
  std::vector<std::string> arguments_;
  std::string world_;  // file
  std::unique_ptr<Sandbox> sandbox_;
  std::unique_ptr<ChildProcess> program_;  // without a sandbox
  std::unique_ptr<ChildProcess> simulator_;
  std::string simulator_out_;
  std::string simulator_err_;
  std::string program_words_;
  double printed_ = 0.0;  // bytes
  bool started_ = false;
  bool program_over_ = false;
  bool ending_ = false;  // the simulator was asked to end
  bool grace_ = false;   // simulated time is over, the program has a moment
  bool simulator_over_ = false;
  std::string failure_;
  std::string note_;
  double cpu_s_ = 0.0;
  double memory_mb_ = 0.0;
  Clock::time_point deadline_;  // of what is waited for
  Clock::time_point next_look_;
};

}  // namespace ccmorse::tools
