// `ccmorse bench link`: what the fast link and JSON cost, measured over TCP between two processes,
// the simulator as users start it and this program, which is a program of libCCMorse like any
// other. It is a program of its own, which `ccmorse` executes, so that the simulator never needs
// the client library.

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/json.h"
#include "bench/simulator.h"
#include "libCCMorse/CCMorse.h"

namespace {

using namespace CCMorse;         // NOLINT(google-build-using-namespace): as users write it
using namespace ccmorse::bench;  // NOLINT(google-build-using-namespace): a program of one file

constexpr int kWidth = 172;  // the course's canvas
constexpr int kHeight = 186;
constexpr int kWarmUp = 200;  // reads before those that count

/// A client with the proxies of one robot, over the link asked for.
struct Rig {
  Rig(const std::string& ccmorse, const std::string& scenario, const std::string& pace, bool json)
      : simulator(ccmorse, scenario, pace) {
    if (json) {
      ::setenv("CCMORSE_LINK", "json", 1);
    } else {
      ::unsetenv("CCMORSE_LINK");
    }
    client = std::make_unique<PlayerClient>("127.0.0.1", simulator.port());
    position = std::make_unique<Position2dProxy>(client.get(), 0);
    laser = std::make_unique<LaserProxy>(client.get(), 0);
    position->SetMotorEnable(true);
    MorseClient& morse = MorseClient::GetInstance();
    if (morse.GetLink() != (json ? "json" : "fast")) {
      throw std::runtime_error("the link is " + morse.GetLink());
    }
    pen = morse.GetRobots().front()->FindDevice<MorsePen>();
    pen->ResizeCanvas(kWidth, kHeight);
  }

  Simulator simulator;
  std::unique_ptr<PlayerClient> client;
  std::unique_ptr<Position2dProxy> position;
  std::unique_ptr<LaserProxy> laser;
  MorsePen* pen = nullptr;
};

// Read() + SetSpeed() with a look at laser and position: simulated seconds a wall second.
double Lockstep(Rig& rig, double seconds) {
  double nearest = 0.0;
  const auto round = [&](int i) {
    rig.client->Read();
    nearest = std::min((*rig.laser)[340], rig.position->GetXPos());
    rig.position->SetSpeed(0.1, i % 20 < 10 ? 0.5 : -0.5 + 1e-3 * nearest);
  };
  for (int i = 0; i < kWarmUp; ++i) round(i);
  const double from = rig.laser->GetDataTime();
  const auto start = Clock::now();
  for (int i = 0; Since(start) < seconds; ++i) round(i);
  return (rig.laser->GetDataTime() - from) / Since(start);
}

// How long a Read() that waits for data takes from when they are there to its return, by the
// machine's clock: since the simulator began to send them, and since they were due.
struct Delays {
  std::vector<double> sent;  // s, one for each Read()
  std::vector<double> due;
};

Delays RealTime(Rig& rig, double seconds) {
  MorseClient& morse = MorseClient::GetInstance();
  Delays delays;
  for (int i = 0; i < 10; ++i) rig.client->Read();
  const auto start = Clock::now();
  while (delays.due.size() < 10 || Since(start) < seconds) {
    rig.client->Read();
    const double now = std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
    const MorseValue clock = morse.Request("ccmorse", "clock");
    delays.sent.push_back(now - clock.GetDouble("sent"));
    delays.due.push_back(now - clock.GetDouble("due") + clock.GetDouble("time") - morse.GetTime());
    rig.position->SetSpeed(0.0, 0.5);
  }
  return delays;
}

// Every cell gets a new colour, none like its neighbours: nothing to compress. Seconds, one for
// each update, from the call to the answer to a request behind it.
std::vector<double> CanvasUpdates(Rig& rig, double seconds) {
  std::vector<double> times;
  std::vector<Color_t> image(static_cast<std::size_t>(kWidth) * kHeight);
  std::uint32_t state = 1;
  const auto start = Clock::now();
  while (times.size() < 5 || Since(start) < seconds) {
    for (Color_t& color : image) {
      state = state * 1664525U + 1013904223U;
      color = {static_cast<unsigned char>(state >> 24U), static_cast<unsigned char>(state >> 16U),
               static_cast<unsigned char>(state >> 8U)};
    }
    const auto asked = Clock::now();
    rig.pen->SetImageData(image);
    const Color_t corner = rig.pen->GetPixel(kWidth - 1, kHeight - 1);
    times.push_back(Since(asked));
    if (!(corner == image.back())) throw std::runtime_error("the canvas is not what was sent");
  }
  return times;
}

int Run(const std::string& ccmorse, double seconds, bool as_json) {
  double lockstep[2];
  double canvas[2];
  for (const bool json : {false, true}) {
    Rig rig(ccmorse, "syrotek", "lockstep", json);
    lockstep[json ? 1 : 0] = Lockstep(rig, seconds);
    canvas[json ? 1 : 0] = Quantile(CanvasUpdates(rig, seconds / 2), 0.5);
  }
  Delays delays[2];
  const ScenarioFile scenario(kFrequent);
  for (const bool json : {false, true}) {
    Rig rig(ccmorse, scenario.path(), "real", json);
    delays[json ? 1 : 0] = RealTime(rig, seconds * 2);
  }
  constexpr double kMicro = 1e6;
  const double ratio = canvas[1] / canvas[0];
  if (as_json) {
    using ccmorse::Json;
    fmt::print("{}\n",
               Json(Json::Object{{"lockstep_sim_s_per_wall_s", lockstep[0]},
                                 {"lockstep_json_sim_s_per_wall_s", lockstep[1]},
                                 {"read_p50_us", Quantile(delays[0].sent, 0.5) * kMicro},
                                 {"read_p99_us", Quantile(delays[0].sent, 0.99) * kMicro},
                                 {"read_json_p50_us", Quantile(delays[1].sent, 0.5) * kMicro},
                                 {"read_json_p99_us", Quantile(delays[1].sent, 0.99) * kMicro},
                                 {"read_from_due_p50_us", Quantile(delays[0].due, 0.5) * kMicro},
                                 {"read_from_due_p99_us", Quantile(delays[0].due, 0.99) * kMicro},
                                 {"canvas_update_us", canvas[0] * kMicro},
                                 {"canvas_json_update_us", canvas[1] * kMicro},
                                 {"canvas_ratio", ratio}})
                   .Dump());
    return 0;
  }
  fmt::print("{:<58} {:>10} {:>10}\n", "one robot, laser and position, one client over TCP", "fast",
             "JSON");
  fmt::print("{:<58} {:>10.0f} {:>10.0f}\n",
             "lock-step Read() + SetSpeed(), simulated s per wall s", lockstep[0], lockstep[1]);
  const auto row = [&](const std::string& what, std::vector<double> Delays::*since, double share) {
    fmt::print("{:<58} {:>10.1f} {:>10.1f}\n", what, Quantile(delays[0].*since, share) * kMicro,
               Quantile(delays[1].*since, share) * kMicro);
  };
  row("Read() in real time, since data were sent, p50, us", &Delays::sent, 0.5);
  row(fmt::format("  the same, p99 of {}, us", delays[0].sent.size()), &Delays::sent, 0.99);
  row("  since they were due, p50, us", &Delays::due, 0.5);
  row("  the same, p99, us", &Delays::due, 0.99);
  fmt::print("{:<58} {:>10.1f} {:>10.1f}\n",
             fmt::format("all {} x {} cells of the canvas new, us", kWidth, kHeight),
             canvas[0] * kMicro, canvas[1] * kMicro);
  fmt::print("{:<58} {:>10.1f}\n", "  the fast link is so many times faster", ratio);
  return 0;
}

}  // namespace

// Arguments, as `ccmorse bench link` passes them on: path of ccmorse, seconds, "json" or "table".
int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: ccmorse bench link\n");
    return 2;
  }
  try {
    return Run(argv[1], std::atof(argv[2]), std::string(argv[3]) == "json");
  } catch (const MorseError& error) {
    std::fprintf(stderr, "ccmorse bench link: %s\n", error.GetErrorStr().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ccmorse bench link: %s\n", error.what());
  }
  return 1;
}
