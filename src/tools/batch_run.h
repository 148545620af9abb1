#pragma once

#include <poll.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "tools/batch_manifest.h"
#include "tools/bounded_log.h"
#include "tools/child_process.h"

namespace ccmorse::tools {

/// One job under way: a simulator as a process of its own on free ports, in lock-step, and beside
/// it the job's program, told of the ports by its arguments and environment; or the simulator
/// alone, as fast as it can. Whatever the program does, crash, hang or print without end, becomes
/// the job's result. The processes end with the object. Not thread safe.
class BatchRun {
 public:
  using Clock = std::chrono::steady_clock;

  struct Options {
    std::string simulator;    ///< path of the `ccmorse` program
    std::string start;        ///< folder in which the program starts: the manifest's
    std::string folder;       ///< the job's own, absolute; made when something is written there
    std::string log;          ///< how the result calls the log
    std::size_t longest_log;  ///< bytes
    int threads = 0;          ///< of the simulator; 0: as many as are sensible
    bool timing = false;      ///< put wall-clock times into the result
  };

  /// Starts the simulator. Throws Error when a folder or a process cannot be made: that is no fault
  /// of the job's.
  BatchRun(const BatchJob& job, const Options& options);
  ~BatchRun();
  BatchRun(const BatchRun&) = delete;
  BatchRun& operator=(const BatchRun&) = delete;

  const BatchJob& job() const { return job_; }

  /// Appends what to wait for; a process that ends is announced by SIGCHLD.
  void AddPolled(std::vector<pollfd>& polled) const;
  /// When to call Step() at the latest.
  Clock::time_point deadline() const { return deadline_; }

  /// Takes what the processes have printed, starts the program when the simulator listens, ends the
  /// simulator after the program, and both when their time is over. True when the job is over.
  bool Step();

  /// The job's line (docs/batch.md); after Step() said true.
  Json Result();

  /// Asks both processes to end, now. The job then has no result.
  void Abandon();

 private:
  void TakeOutput();
  void StartProgram(int port);
  void Fail(const std::string& error);
  void ReadReport(Json& line) const;

  BatchJob job_;
  Options options_;
  std::string report_;  // file of the simulator's report
  BoundedLog log_;
  std::unique_ptr<ChildProcess> simulator_;
  std::unique_ptr<ChildProcess> program_;
  std::string simulator_out_;  // until its port is known
  std::string simulator_err_;  // the last of it
  std::string program_err_;    // the last of it
  bool ending_ = false;        // the simulator was asked to end
  bool timed_out_ = false;
  std::string error_;  // why the job failed; "": it has not
  Clock::time_point started_;
  Clock::time_point deadline_;
  double wall_ = 0.0;  // s
};

}  // namespace ccmorse::tools
