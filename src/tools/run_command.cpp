#include "tools/run_command.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/log.h"
#include "scene/player/import.h"
#include "scene/scenario.h"
#include "servers/own/own_components.h"
#include "servers/own/plugin_host.h"
#include "servers/player/mirror.h"
#include "servers/record/recorder.h"
#include "servers/run_report.h"
#include "servers/runner.h"
#include "servers/web/web_server.h"
#include "tools/builder_script.h"
#include "tools/child_process.h"
#include "tools/open_browser.h"
#include "tools/stop_signals.h"
#include "tools/top_view.h"

namespace ccmorse::tools {
namespace {

servers::Pace PaceFrom(const RunArguments& arguments, const scene::Scenario& scenario) {
  const std::string& name = arguments.pace ? *arguments.pace : scenario.time.strategy;
  if (name == "lockstep") return servers::Pace::kLockstep;
  if (name == "max") return servers::Pace::kMax;
  return servers::Pace::kRealTime;
}

// Each file would be written over by the next.
void RequireDifferent(const std::vector<std::string>& files) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (files[i].empty() || std::filesystem::weakly_canonical(files[i]) !=
                                  std::filesystem::weakly_canonical(files[k])) {
        continue;
      }
      throw Error("picture, report and record are files of their own, but two are called " +
                  files[i]);
    }
  }
}

// The live view, unless it is not wanted or not safe.
std::unique_ptr<servers::WebServer> ServeView(const RunArguments& arguments,
                                              const sim::Simulation& simulation,
                                              servers::Runner& runner) {
  if (arguments.headless) return nullptr;
  servers::WebServerOptions options;
  options.bind = arguments.bind;
  // Where any port will do for the services, any will do for the view.
  const bool any = arguments.port == 0 && arguments.view_port == RunArguments{}.view_port;
  options.port = any ? 0 : arguments.view_port;
  options.token = arguments.token;
  options.read_only = arguments.view_read_only;
  options.folder = servers::FindWebFolder();
  if (!servers::IsLoopback(options.bind) && options.token.empty()) {
    LogWarning(
        "no live view: with --bind {} whoever saw it could drive the robots; give it a "
        "--token WORD",
        options.bind);
    return nullptr;
  }
  return std::make_unique<servers::WebServer>(runner.io(), simulation, runner.directory(), options);
}

void PrintReport(const sim::Simulation& simulation, const servers::MorseServer& server,
                 const servers::RunSummary& summary) {
  fmt::print("\nSimulated {:.3f} s in {:.3f} s", summary.simulated, summary.wall);
  if (summary.wall > 0.0) {
    fmt::print(" of wall time: {:.1f} times real time", summary.simulated / summary.wall);
  }
  fmt::print("\n{:<12} {:>10} {:>9} {:>10} {:>12}\n", "robot", "driven", "contacts", "stalled",
             "scans used");
  for (const auto& robot : simulation.robots()) {
    const servers::LaserUse use = servers::CountScans(*robot, server);
    fmt::print("{:<12} {:>8.3f} m {:>9} {:>8.2f} s {:>6}/{}\n", robot->name(),
               robot->tally().distance, robot->tally().contacts, robot->tally().stalled, use.used,
               use.scans);
  }
  fmt::print("state hash   {:016x}\n", simulation.Hash());
}

void WritePicture(const sim::Simulation& simulation, const std::string& path) {
  TopView view;
  view.world = &simulation.world().scene();
  // A world of MORSE's is many times as large as an arena: a coarser picture is better than none.
  constexpr double kFinest = 8192.0;  // pixels a side
  constexpr double kCoarse = 2048.0;
  const double side = std::max(view.world->size_x, view.world->size_y) + 2.0 * view.margin;
  if (side * view.pixels_per_metre > kFinest)
    view.pixels_per_metre = std::max(10.0, kCoarse / side);
  for (const auto& robot : simulation.robots()) {
    view.robots.push_back({&robot->model(), robot->pose(), robot->def().color, {}, {}});
  }
  const sim::Canvas& canvas = simulation.canvas();
  view.canvas.width = canvas.width();
  view.canvas.height = canvas.height();
  view.canvas.cell_size = canvas.cell_size();
  for (int y = 0; y < canvas.height(); ++y) {
    for (int x = 0; x < canvas.width(); ++x) {
      view.canvas.colors.push_back(canvas.GetPixel(x, y));
      view.canvas.alpha.push_back(canvas.IsDrawn(x, y) ? 255 : 0);
    }
  }
  WritePng(RenderTopView(view), path);
}

std::optional<servers::player::PlayerServerOptions> PlayerOptions(const RunArguments& arguments) {
  if (arguments.no_player) return std::nullopt;
  servers::player::PlayerServerOptions options;
  options.bind = arguments.bind;
  if (arguments.player_port) {
    options.port = *arguments.player_port;
  } else if (arguments.port == 0) {
    options.port = 0;
  } else {
    options.may_be_taken = true;
  }
  return options;
}

void PrintPlayerPorts(const std::string& bind, const servers::player::PlayerServer* server) {
  if (server == nullptr) return;
  const auto ports = server->ports();
  constexpr std::size_t kShown = 16;
  for (std::size_t i = 0; i < ports.size() && i < kShown; ++i) {
    // A port of a .cfg may have drivers and no robot.
    fmt::print("Player on {} port {} ({})\n", bind, ports[i].port,
               ports[i].robot.empty() ? "no robot" : "robot " + ports[i].robot);
  }
  if (ports.size() > kShown) {
    fmt::print("... and on ports up to {} for the {} others\n", ports.back().port,
               ports.size() - kShown);
  }
}

// Which node of its scene this run is; "" when it is none, so that all robots are simulated here.
// As MORSE has it: --name and MORSE_NODE name the node, else the machine's name does.
std::string NodeOf(const scene::Scenario& scenario) {
  if (!scenario.multinode) return "";
  const char* const given = std::getenv("MORSE_NODE");
  std::string name = given != nullptr ? given : "";
  if (name.empty()) {
    std::array<char, 256> machine{};
    if (::gethostname(machine.data(), machine.size() - 1) == 0) name = machine.data();
  }
  if (scenario.multinode->nodes.count(name) != 0) return name;
  LogWarning(
      "'{}' is none of the scene's nodes: all robots are on this one; --name NODE says which "
      "of them this is",
      name);
  return "";
}

// Prints the state hash every so many ticks.
class HashPrinter : public servers::RunWatcher {
 public:
  HashPrinter(const sim::Simulation& simulation, std::uint64_t every)
      : simulation_(simulation), every_(every) {}
  void Acted() override {
    if (simulation_.tick() % every_ != 0) return;
    fmt::print("tick {:>9}  time {:>12.3f} s  hash {:016x}\n", simulation_.tick(),
               simulation_.time(), simulation_.Hash());
    std::fflush(stdout);
  }

 private:
  const sim::Simulation& simulation_;
  std::uint64_t every_;
};

}  // namespace

int Run(const RunArguments& arguments) {
  if (arguments.quiet) SetLogLevel(LogLevel::kError);
  scene::ImportedScenario imported = ImportScene(arguments.scenario, arguments.script_arguments);
  for (const scene::FileNote& note : imported.notes) {
    if (note.matters) LogWarning("{}: {}", note.at.Text(), note.text);
  }
  scene::Scenario scenario = std::move(imported.scenario);
  if (!arguments.name.empty()) scenario.name = arguments.name;
  if (!std::isfinite(arguments.seconds)) throw Error("--for must be a number of seconds");
  if (arguments.seed) scenario.seed = static_cast<std::uint64_t>(*arguments.seed);

  servers::RunOptions options;
  options.pace = PaceFrom(arguments, scenario);
  options.factor = scenario.time.factor;
  options.seconds = arguments.seconds > 0.0 ? arguments.seconds : scenario.time.end;
  options.clients = arguments.clients;
  options.client_timeout = arguments.client_timeout;
  options.morse.bind = arguments.bind;
  options.morse.port = arguments.port;
  options.morse.listen_socket = arguments.listen_socket;
  options.morse.first_stream_port = arguments.stream_port;
  options.player = PlayerOptions(arguments);
  // Where any port will do for the services, any will do for this one.
  if (scenario.time.sync_port != 0) {
    options.sync_port = arguments.port == 0 ? 0 : scenario.time.sync_port;
  }
  options.node = NodeOf(scenario);
  if (!options.node.empty() && !arguments.record.empty()) {
    throw Error("a run that several nodes share cannot be recorded; leave --record out");
  }
  if (arguments.player_port && *arguments.player_port != 0 && scenario.player) {
    LogWarning("--player-port has no effect: {} says on which ports its devices are",
               arguments.scenario);
  }
  RequireDifferent({arguments.picture, arguments.report, arguments.record});
  servers::PrepareFile(arguments.picture);
  servers::PrepareFile(arguments.report);
  servers::PrepareFile(arguments.record);
  std::error_code failed;
  std::filesystem::create_directories(arguments.out, failed);
  if (failed) throw Error("cannot make the folder " + arguments.out + ": " + failed.message());

  if (arguments.threads > static_cast<int>(std::thread::hardware_concurrency())) {
    LogWarning("{} threads are more than this machine's {} processors and only cost time",
               arguments.threads, std::thread::hardware_concurrency());
  }
  servers::DescribePlugins(scenario);
  const StopSignals signals;  // before the simulation's threads
  sim::Simulation simulation(std::move(scenario), arguments.threads);
  simulation.canvas().set_picture_folder(arguments.out);
  servers::Runner runner(simulation, options);
  runner.directory().set_contest(arguments.contest);
  std::optional<HashPrinter> printer;
  if (arguments.hash_every && !arguments.quiet) {
    runner.AddWatcher(printer.emplace(simulation, *arguments.hash_every));
  }
  std::optional<servers::Recorder> recorder;
  if (!arguments.record.empty()) {
    const servers::RecordOptions record{arguments.record_data, arguments.hash_every,
                                        arguments.contest};
    runner.AddWatcher(recorder.emplace(simulation, arguments.record, record));
  }

  std::optional<servers::OwnComponents> own;
  if (servers::OwnComponents::AreThere(simulation.scenario())) {
    servers::OwnOptions own_options;
    own_options.python = FindInPath("python3");
    own_options.python_folder = FindPythonFolder();
    own_options.time_limit = arguments.component_timeout;
    runner.AddParticipant(own.emplace(simulation, runner.directory(), own_options));
  }

  const std::unique_ptr<servers::WebServer> view = ServeView(arguments, simulation, runner);
  if (view) runner.AddWatcher(*view);

  std::vector<std::unique_ptr<servers::Mirror>> mirrors;
  for (const std::string& target : arguments.mirrors) {
    mirrors.push_back(std::make_unique<servers::Mirror>(runner.io(), simulation, runner.directory(),
                                                        servers::MirrorTarget::Parse(target)));
  }

  // Whoever reads our output may stop reading (`| head`); the run and its record go on.
  std::signal(SIGPIPE, SIG_IGN);
  const StopSignalWatch watch(signals, runner.io(), [&runner](int signal) {
    if (signal == SIGTERM) {
      runner.StopAfterClients();
    } else {
      runner.Stop();
    }
  });

  if (!arguments.quiet) {
    fmt::print("PID: {}\n", ::getpid());
    fmt::print("Scenario {}: {} robot{}, seed {}, pace {}\n", simulation.scenario().name,
               simulation.robots().size(), simulation.robots().size() == 1 ? "" : "s",
               simulation.scenario().seed, servers::PaceName(options.pace));
    fmt::print("MORSE services on {} port {}\n", arguments.bind, runner.morse().port());
    const auto [first_stream, last_stream] = runner.morse().stream_ports();
    if (first_stream != 0) fmt::print("Streams on ports {} to {}\n", first_stream, last_stream);
    PrintPlayerPorts(arguments.bind, runner.player());
    if (runner.sync_port() != 0) {
      fmt::print("Time synchronisation on {} port {}\n", arguments.bind, runner.sync_port());
    }
    if (!options.node.empty()) {
      fmt::print("Node {} of {}\n", options.node, simulation.scenario().multinode->nodes.size());
    }
    if (options.pace == servers::Pace::kLockstep) {
      fmt::print("Lock-step: time starts when {}\n",
                 options.clients == 1 ? "a client reads"
                                      : fmt::format("{} clients read", options.clients));
    }
    if (view) fmt::print("View at {}\n", view->address());
    fmt::print("SCENE INITIALIZED\n");
    std::fflush(stdout);
  }
  if (view && arguments.open) OpenBrowser(view->address());
  const servers::RunSummary summary = runner.Run();
  if (view) view->Close();
  runner.CloseServers();  // the ports are free while the picture is made

  if (!arguments.quiet) PrintReport(simulation, runner.morse(), summary);
  if (!arguments.report.empty()) {
    servers::WriteReport(servers::ReportJson(simulation, runner.morse(), summary, options.pace),
                         arguments.report);
  }
  if (!arguments.picture.empty()) {
    WritePicture(simulation, arguments.picture);
    if (!arguments.quiet) fmt::print("picture      {}\n", arguments.picture);
  }
  if (recorder && recorder->failure().empty() && !arguments.quiet) {
    fmt::print("record       {}, {:.1f} MB\n", recorder->file(),
               static_cast<double>(recorder->bytes()) * 1e-6);
  }
  if (!arguments.quiet) fmt::print("EXITING SIMULATION\n");
  std::fflush(stdout);
  if (recorder && !recorder->failure().empty()) throw Error(recorder->failure());
  return 0;
}

int Convert(const ConvertArguments& arguments) {
  const scene::ImportedScenario imported = ImportScene(arguments.file, {});
  for (const scene::FileNote& note : imported.notes) {
    fmt::print(stderr, "{}: {}{}\n", note.at.Text(), note.matters ? "" : "(no matter) ", note.text);
  }
  const std::string text = scene::ToJson(imported.scenario).Dump() + "\n";
  if (arguments.out.empty()) {
    fmt::print("{}", text);
    return 0;
  }
  servers::PrepareFile(arguments.out);
  std::ofstream file(arguments.out);
  if (!(file << text) || !file.flush()) {
    throw Error("cannot write " + arguments.out + ": " + std::strerror(errno));
  }
  return 0;
}

}  // namespace ccmorse::tools
