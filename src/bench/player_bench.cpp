// `ccmorse bench player`: what Player's protocol costs, measured over TCP between two processes:
// the simulator as users start it, and this program of libplayerc++.

#include <fmt/core.h>
#include <libplayerc++/playerc++.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/json.h"
#include "bench/simulator.h"
#include "libCCMorse/CCMorse.h"

namespace {

using namespace ccmorse::bench;  // NOLINT(google-build-using-namespace): a program of one file

constexpr int kWarmUp = 200;  // rounds before those that count
constexpr int kFleet = 100;   // robots, each with a client

/// A client in the mode PULL with the proxies of one robot.
struct Robot {
  explicit Robot(int port)
      : client("player://127.0.0.1", static_cast<std::uint32_t>(port)),
        position(&client, 0),
        laser(&client, 0) {
    client.SetDataMode(PLAYER_DATAMODE_PULL);
    client.SetReplaceRule(true, PLAYER_MSGTYPE_DATA, -1, -1);
    position.SetMotorEnable(true);
  }

  PlayerCc::PlayerClient client;
  PlayerCc::Position2dProxy position;
  PlayerCc::LaserProxy laser;
};

// Read() + SetSpeed() with a look at laser and position: simulated seconds a wall second.
double Lockstep(const std::string& ccmorse, double seconds) {
  const Simulator simulator(ccmorse, "syrotek", "lockstep");
  Robot robot(simulator.player_port());
  double nearest = 0.0;
  const auto round = [&](int i) {
    robot.client.Read();
    nearest = std::min(robot.laser[340], robot.position.GetXPos());
    robot.position.SetSpeed(0.1, i % 20 < 10 ? 0.5 : -0.5 + 1e-3 * nearest);
  };
  for (int i = 0; i < kWarmUp; ++i) round(i);
  const double from = robot.position.GetDataTime();
  const auto start = Clock::now();
  for (int i = 0; Since(start) < seconds; ++i) round(i);
  return (robot.position.GetDataTime() - from) / Since(start);
}

// By how much the return of a Read() is later than the moment at which its data were due, by the
// machine's clock, s: the tick, the scan, and the way here.
std::vector<double> RealTime(const std::string& ccmorse, double seconds) {
  const ScenarioFile scenario(kFrequent);
  const Simulator simulator(ccmorse, scenario.path(), "real");
  Robot robot(simulator.player_port());
  // It only tells when what was due.
  const std::shared_ptr<CCMorse::MorseClient> morse =
      CCMorse::MorseClient::Share("127.0.0.1", simulator.port());
  std::vector<double> delays;
  for (int i = 0; i < 10; ++i) robot.client.Read();
  const auto start = Clock::now();
  while (delays.size() < 10 || Since(start) < seconds) {
    robot.client.Read();
    const double now = std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
    const CCMorse::MorseValue clock = morse->Request("ccmorse", "clock");
    delays.push_back(now - clock.GetDouble("due") + clock.GetDouble("time") -
                     robot.position.GetDataTime());
    robot.position.SetSpeed(0.0, 0.5);
  }
  return delays;
}

struct FleetFigures {
  std::size_t rounds = 0;
  std::size_t missed = 0;  // data that a client did not get
  double processor = 0.0;  // of the simulator, share of one core
};

// A simulator with as many free ports in a row as there are robots: it is tried out.
std::unique_ptr<Simulator> OnFreePorts(const std::string& ccmorse, const std::string& scenario) {
  for (int first = 23000;; first += kFleet) {
    try {
      return std::make_unique<Simulator>(ccmorse, scenario, "real", first);
    } catch (const std::runtime_error&) {
      if (first > 30000) throw;
    }
  }
}

// A client for each of many robots, with position and laser ten times a second.
FleetFigures Fleet(const std::string& ccmorse, double seconds) {
  std::string robots;
  for (int i = 0; i < kFleet; ++i) {
    robots += fmt::format(R"({}{{"name": "r{:03}", "pose": {{"x": {}, "y": {}}}}})",
                          i > 0 ? ", " : "", i, 2 + 4 * (i % 10), 2 + 4 * (i / 10));
  }
  const ScenarioFile scenario(fmt::format(
      R"({{"world": {{"name": "hall", "size": [40, 40], "boxes": []}}, "robots": [{}]}})", robots));
  const std::unique_ptr<Simulator> simulator = OnFreePorts(ccmorse, scenario.path());
  std::vector<std::unique_ptr<Robot>> fleet;
  for (int i = 0; i < kFleet; ++i) {
    fleet.push_back(std::make_unique<Robot>(simulator->player_port() + i));
  }
  constexpr double kPeriod = 0.1;  // s of simulated time, the scanner's and the odometry's
  std::vector<double> times(kFleet, 0.0);
  FleetFigures figures;
  const auto round = [&](bool counts) {
    for (std::size_t i = 0; i < fleet.size(); ++i) {
      fleet[i]->client.Read();
      const double time = fleet[i]->position.GetDataTime();
      if (counts) {
        ++figures.rounds;
        figures.missed += static_cast<std::size_t>(std::lround((time - times[i]) / kPeriod)) - 1;
      }
      times[i] = time;
      fleet[i]->position.SetSpeed(0.1, 0.5);
    }
  };
  for (int i = 0; i < 10; ++i) round(false);
  const double processor = simulator->ProcessorTime();
  const auto start = Clock::now();
  while (Since(start) < seconds) round(true);
  figures.processor = (simulator->ProcessorTime() - processor) / Since(start);
  return figures;
}

int Run(const std::string& ccmorse, double seconds, bool as_json) {
  const double lockstep = Lockstep(ccmorse, seconds);
  const std::vector<double> delays = RealTime(ccmorse, 2.0 * seconds);
  const FleetFigures fleet = Fleet(ccmorse, 2.0 * seconds);
  constexpr double kMicro = 1e6;
  if (as_json) {
    using ccmorse::Json;
    fmt::print("{}\n", Json(Json::Object{{"lockstep_sim_s_per_wall_s", lockstep},
                                         {"read_from_due_p50_us", Quantile(delays, 0.5) * kMicro},
                                         {"read_from_due_p99_us", Quantile(delays, 0.99) * kMicro},
                                         {"fleet_rounds", static_cast<double>(fleet.rounds)},
                                         {"fleet_missed", static_cast<double>(fleet.missed)},
                                         {"fleet_percent_of_core", 100.0 * fleet.processor}})
                           .Dump());
    return 0;
  }
  const auto row = [](const std::string& what, double figure, int digits) {
    fmt::print("{:<66} {:>10.{}f}\n", what, figure, digits);
  };
  fmt::print("Player's protocol, PULL: position, laser and commands over TCP\n");
  row("lock-step Read() + SetSpeed(), simulated s per wall s", lockstep, 0);
  row("Read() in real time, since its data were due, p50, us", Quantile(delays, 0.5) * kMicro, 1);
  row(fmt::format("  the same, p99 of {}, us", delays.size()), Quantile(delays, 0.99) * kMicro, 1);
  row(fmt::format("{} clients on {} robots at 10 Hz: data missed of {}", kFleet, kFleet,
                  fleet.rounds),
      static_cast<double>(fleet.missed), 0);
  row("  the simulator's processor time, % of a core", 100.0 * fleet.processor, 1);
  return 0;
}

}  // namespace

// Arguments, as `ccmorse bench player` passes them on: path of ccmorse, seconds, "json" or "table".
int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: ccmorse bench player\n");
    return 2;
  }
  try {
    return Run(argv[1], std::atof(argv[2]), std::string(argv[3]) == "json");
  } catch (const PlayerCc::PlayerError& error) {
    std::fprintf(stderr, "ccmorse bench player: %s\n", error.GetErrorStr().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ccmorse bench player: %s\n", error.what());
  }
  return 1;
}
