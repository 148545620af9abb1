#pragma once

#include <memory>
#include <string>
#include <thread>

#include "scene/scenario.h"
#include "servers/runner.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// A simulation served on free ports by a thread of its own, for tests that talk to it over
/// sockets.
class ServedSimulation {
 public:
  explicit ServedSimulation(const std::string& scenario, Pace pace = Pace::kRealTime,
                            double seconds = 0.0, const MorseServerOptions& limits = {},
                            int clients = 1, double client_timeout = 10.0)
      : simulation_(scene::ParseScenario(scenario, "test.json")),
        runner_(simulation_, Options(pace, seconds, limits, clients, client_timeout)),
        port_(runner_.morse().port()),
        thread_([this] { summary_ = runner_.Run(); }) {}

  ~ServedSimulation() {
    runner_.Stop();
    Join();
  }

  int port() const { return port_; }

  /// Waits for the end of the run; the simulation may be looked at then.
  RunSummary Join() {
    if (thread_.joinable()) thread_.join();
    return summary_;
  }
  const sim::Simulation& simulation() const { return simulation_; }
  MorseServer& server() { return runner_.morse(); }

 private:
  static RunOptions Options(Pace pace, double seconds, MorseServerOptions limits, int clients,
                            double client_timeout) {
    limits.port = 0;
    limits.first_stream_port = 0;
    return {pace, 1.0, seconds, clients, limits, client_timeout};
  }

  sim::Simulation simulation_;
  Runner runner_;
  int port_;
  RunSummary summary_;
  std::thread thread_;
};

}  // namespace ccmorse::servers
