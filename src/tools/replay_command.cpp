#include "tools/replay_command.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <thread>

#include "base/trig.h"
#include "servers/record/replay.h"
#include "servers/record/replay_server.h"
#include "tools/open_browser.h"
#include "tools/stop_signals.h"

namespace ccmorse::tools {
namespace {

using WallClock = std::chrono::steady_clock;

constexpr int kDiffers = 1;
constexpr int kNoUse = 2;
constexpr int kNotWhole = 3;                            // equal, but the record has no end
constexpr auto kFrame = std::chrono::milliseconds(40);  // wall time from one look to the next
constexpr std::size_t kMostShown = 3;                   // robots

double Seconds(std::uint64_t tick, const servers::Replay& replay) {
  return static_cast<double>(tick) / replay.info().scenario.time.frequency;
}

// What part of the simulation it is, in words.
std::string Describe(const servers::Difference& difference) {
  const std::string& component = difference.component;
  if (component.empty()) return "the state as a whole";
  const bool is_device = component.find('.') != std::string::npos;
  if (is_device || component == "canvas") return component;
  const std::string by =
      difference.driver.empty() ? "" : fmt::format(" (driven by {})", difference.driver);
  return component + ", its pose or speed" + by;
}

void PrintDifference(const servers::Replay& replay) {
  const servers::Difference& difference = *replay.difference();
  if (difference.first_tick == difference.last_tick) {
    fmt::print("differs in tick {} ({:.3f} s)", difference.first_tick,
               Seconds(difference.first_tick, replay));
  } else {
    fmt::print("differs between tick {} ({:.3f} s) and tick {}", difference.first_tick,
               Seconds(difference.first_tick, replay), difference.last_tick);
  }
  fmt::print(": {}: recorded {}, simulated {}", Describe(difference), difference.recorded,
             difference.simulated);
  if (difference.others > 0) {
    fmt::print("; {} other component{} as well", difference.others,
               difference.others == 1 ? "" : "s");
  }
  fmt::print("\n");
  if (replay.info().version != CCMORSE_VERSION) {
    fmt::print(
        "The record is of ccmorse {}, and this is {}: runs of different versions need not "
        "be equal.\n",
        replay.info().version, CCMORSE_VERSION);
  }
}

void PrintIfBrokenOff(const servers::Replay& replay) {
  if (replay.info().complete) return;
  fmt::print(
      "The record is not whole: its run was killed, or the file was cut. It can be replayed "
      "up to {:.3f} s.\n",
      replay.duration());
}

int Verify(servers::Replay& replay) {
  PrintIfBrokenOff(replay);
  while (replay.Step() && !replay.difference()) {
  }
  if (replay.difference()) {
    PrintDifference(replay);
    return kDiffers;
  }
  fmt::print("equal{}: {} ticks ({:.3f} s), hash {:016x}\n",
             replay.info().complete ? "" : " as far as it goes", replay.simulation().tick(),
             replay.simulation().time(), replay.simulation().Hash());
  return replay.info().complete ? 0 : kNotWhole;
}

// Time and robots in one line.
std::string StatusLine(const servers::Replay& replay) {
  const sim::Simulation& simulation = replay.simulation();
  std::string line = fmt::format("{:10.3f} / {:.3f} s", simulation.time(), replay.duration());
  const auto& robots = simulation.robots();
  for (std::size_t i = 0; i < robots.size() && i < kMostShown; ++i) {
    const Pose2& pose = robots[i]->pose();
    line += fmt::format("  {} ({:.3f}, {:.3f}, {:4.0f} deg)", robots[i]->name(), pose.x, pose.y,
                        Degrees(pose.yaw));
  }
  if (robots.size() > kMostShown) {
    line += fmt::format("  and {} more", robots.size() - kMostShown);
  }
  return line;
}

// Shows where the run is: in one line that changes on a terminal, a line a second elsewhere.
class ReplayProgress {
 public:
  explicit ReplayProgress(const servers::Replay& replay) : replay_(replay) {}

  void Show() {
    const double time = replay_.simulation().time();
    if (terminal_) {
      const auto now = WallClock::now();
      if (now < next_look_) return;
      next_look_ = now + kFrame;
      fmt::print("\r{}\x1b[K", StatusLine(replay_));
    } else {
      if (time < next_second_) return;
      next_second_ = std::floor(time) + 1.0;
      fmt::print("{}\n", StatusLine(replay_));
    }
    shown_tick_ = replay_.simulation().tick();
    std::fflush(stdout);
  }

  // Leaves the last line behind.
  void ShowLast() {
    if (terminal_) {
      fmt::print("\r{}\x1b[K\n", StatusLine(replay_));
    } else if (shown_tick_ != replay_.simulation().tick()) {
      fmt::print("{}\n", StatusLine(replay_));
    }
  }

 private:
  const servers::Replay& replay_;
  bool terminal_ = ::isatty(STDOUT_FILENO) == 1;
  WallClock::time_point next_look_{};
  double next_second_ = 0.0;  // s, simulated
  std::uint64_t shown_tick_ = std::numeric_limits<std::uint64_t>::max();
};

double SpeedFrom(const std::string& text) {
  double factor = std::numeric_limits<double>::infinity();
  if (text != "max") std::from_chars(text.data(), text.data() + text.size(), factor);
  return factor;
}

void RequireInRange(const ReplayArguments& arguments, double duration) {
  if (arguments.from > duration) {
    throw Error(
        fmt::format("--from {} is after the record's end at {:.3f} s", arguments.from, duration));
  }
  if (arguments.to && *arguments.to < arguments.from) {
    throw Error(fmt::format("--to {} is before --from {}", *arguments.to, arguments.from));
  }
}

int Show(const ReplayArguments& arguments) {
  const StopSignals signals;  // before the simulation's threads
  servers::ReplayServerOptions options;
  options.from = arguments.from;
  options.to = arguments.to;
  options.speed = SpeedFrom(arguments.speed);
  options.web.port = arguments.view_port;
  options.web.folder = servers::FindWebFolder();
  servers::ReplayServer server(arguments.file, options);
  RequireInRange(arguments, server.replay().duration());
  std::signal(SIGPIPE, SIG_IGN);
  const StopSignalWatch watch(signals, server.io(), [&server](int) { server.Stop(); });
  PrintIfBrokenOff(server.replay());
  fmt::print("Record {}: {}, {:.3f} s, by ccmorse {}\n", arguments.file,
             server.replay().info().scenario.name, server.replay().duration(),
             server.replay().info().version);
  fmt::print("View at {}\nCtrl-C ends it; --headless plays it here.\n", server.web().address());
  std::fflush(stdout);
  if (arguments.open) OpenBrowser(server.web().address());
  server.Run();
  if (!server.replay().difference()) return 0;
  fmt::print("What was shown is not what was recorded; it ");
  PrintDifference(server.replay());
  return kDiffers;
}

int Play(servers::Replay& replay, const ReplayArguments& arguments) {
  PrintIfBrokenOff(replay);
  RequireInRange(arguments, replay.duration());
  const double speed = SpeedFrom(arguments.speed);
  const double half_tick = 0.5 / replay.info().scenario.time.frequency;
  const double to = std::min(arguments.to.value_or(replay.duration()), replay.duration());
  replay.Seek(arguments.from);
  ReplayProgress progress(replay);
  progress.Show();
  const auto start = WallClock::now();
  const double first = replay.simulation().time();
  while (replay.simulation().time() < to - half_tick && replay.Step()) {
    if (std::isfinite(speed)) {
      std::this_thread::sleep_until(
          start + std::chrono::duration_cast<WallClock::duration>(
                      std::chrono::duration<double>((replay.simulation().time() - first) / speed)));
    }
    progress.Show();
  }
  // What came after the last tick belongs to the state at the end.
  if (to >= replay.duration()) replay.Step();
  progress.ShowLast();
  fmt::print("state hash   {:016x}\n", replay.simulation().Hash());
  if (!replay.difference()) return 0;
  fmt::print("What was shown is not what was recorded; it ");
  PrintDifference(replay);
  return kDiffers;
}

}  // namespace

int Replay(const ReplayArguments& arguments) {
  try {
    if (!arguments.verify && !arguments.headless) return Show(arguments);
    servers::Replay replay(arguments.file);
    const int status = arguments.verify ? Verify(replay) : Play(replay, arguments);
    std::fflush(stdout);
    return status;
  } catch (const servers::RecordError& error) {
    std::fflush(stdout);
    std::fprintf(stderr, "ccmorse: %s\n", error.what());
    return kNoUse;
  }
}

}  // namespace ccmorse::tools
