#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "in_process/options.h"
#include "servers/record/recorder.h"
#include "servers/runner.h"
#include "sim/simulation.h"

namespace ccmorse::in_process {

/// A simulation with a thread of its own, for clients within the program: what `ccmorse run` does,
/// but that no port is opened and nothing is printed. The thread takes no signals: those are the
/// program's. Any thread may call it, but for the end.
class SimulationThread {
 public:
  /// Reads the scenario and builds the simulation; its time does not run yet. Throws Error.
  explicit SimulationThread(Options options);
  /// Ends at once, unless Finish() came before.
  ~SimulationThread();
  SimulationThread(const SimulationThread&) = delete;
  SimulationThread& operator=(const SimulationThread&) = delete;

  /// A client's end of a connection; see MorseServer::Connect() and PlayerServer::Connect(). Starts
  /// the thread with the first one. Throws Error.
  int ConnectMorse();
  int ConnectPlayer(const std::string& robot);

  /// Ends the run when what clients have sent is done, and waits for that; see
  /// Runner::StopAfterClients(). Then record and report are complete.
  void Finish();

 private:
  void Start();
  void Run() noexcept;
  void Join();

  const Options options_;
  std::optional<sim::Simulation> simulation_;
  std::optional<servers::Runner> runner_;
  std::optional<servers::Recorder> recorder_;
  servers::Pace pace_ = servers::Pace::kRealTime;
  std::mutex mutex_;  // thread_
  std::thread thread_;
};

}  // namespace ccmorse::in_process
