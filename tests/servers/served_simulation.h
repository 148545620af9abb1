#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "scene/scenario.h"
#include "servers/record/recorder.h"
#include "servers/record/replay.h"
#include "servers/runner.h"
#include "sim/simulation.h"
#include "tests/support/process.h"

namespace ccmorse::servers {

/// A simulation served on free ports by a thread of its own, for tests that talk to it over
/// sockets. Each run is recorded, and must come out the same when it is replayed at the end.
class ServedSimulation {
 public:
  explicit ServedSimulation(const std::string& scenario, Pace pace = Pace::kRealTime,
                            double seconds = 0.0, const MorseServerOptions& limits = {},
                            int clients = 1, const RecordOptions& record = {},
                            double client_timeout = 10.0,
                            std::vector<player::PortSetup> player = {},
                            const std::function<void(Runner&)>& prepare = {})
      : simulation_(scene::ParseScenario(scenario, "test.json")),
        recorder_(simulation_, folder_.path() + "/run.mcap", record),
        runner_(simulation_, Options(pace, seconds, limits, clients, client_timeout,
                                     std::move(player), simulation_.scenario().time.sync_port)),
        port_(runner_.morse().port()),
        sync_port_(runner_.sync_port()),
        thread_([this, prepare] {
          if (prepare) prepare(runner_);
          runner_.AddWatcher(recorder_);
          summary_ = runner_.Run();
        }) {}

  ~ServedSimulation() {
    runner_.Stop();
    Join();
    Replay replay(recorder_.file());
    while (replay.Step()) {
    }
    EXPECT_TRUE(replay.info().complete);
    EXPECT_EQ(replay.simulation().tick(), simulation_.tick());
    EXPECT_EQ(replay.simulation().Hash(), simulation_.Hash());
    EXPECT_FALSE(replay.difference())
        << replay.difference()->component << " in tick " << replay.difference()->first_tick;
  }

  int port() const { return port_; }
  /// Of MORSE's time synchronisation.
  int sync_port() const { return sync_port_; }

  /// Waits for the end of the run; the simulation and the record may be looked at then.
  RunSummary Join() {
    if (thread_.joinable()) thread_.join();
    return summary_;
  }
  const sim::Simulation& simulation() const { return simulation_; }
  const std::string& record() const { return recorder_.file(); }
  MorseServer& server() { return runner_.morse(); }
  /// Player's port of the n-th robot.
  int player_port(std::size_t n = 0) { return runner_.player()->ports().at(n).port; }

 private:
  static RunOptions Options(Pace pace, double seconds, MorseServerOptions limits, int clients,
                            double client_timeout, std::vector<player::PortSetup> setup,
                            int sync_port) {
    limits.port = 0;
    limits.first_stream_port = 0;
    player::PlayerServerOptions player;
    player.port = 0;
    player.setup = std::move(setup);
    RunOptions options{pace, 1.0, seconds, clients, limits, client_timeout, player};
    if (sync_port != 0) options.sync_port = 0;
    return options;
  }

  testing::TemporaryFolder folder_;
  sim::Simulation simulation_;
  Recorder recorder_;
  Runner runner_;
  int port_;
  int sync_port_;
  RunSummary summary_;
  std::thread thread_;
};

}  // namespace ccmorse::servers
