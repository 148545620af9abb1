#include "tools/bench_all.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "tools/child_process.h"

namespace ccmorse::tools {
namespace {

// A benchmark's figures by name; empty when this build has no such benchmark.
using Figures = Json;

Figures RunBenchmark(std::vector<std::string> words) {
  words.insert(words.begin(), {OwnProgram().string(), "bench"});
  words.emplace_back("--json");
  const FinishedProcess run = RunToEnd(words);
  if (!run.status.ok()) return Json::Object{};
  try {
    return Json::Parse(run.out);
  } catch (const JsonError&) {
    return Json::Object{};
  }
}

Figures Fleet(int robots, double stretch) {
  const auto run = [robots](double seconds) {
    return RunBenchmark({"fleet", "--robots", std::to_string(robots), "--seconds",
                         fmt::format("{:.1f}", std::clamp(seconds, 0.5, 1e6))});
  };
  const auto factor = [](const Figures& figures) {
    const Json* const value = figures.Find("sim_s_per_wall_s");
    return value != nullptr ? value->AsDouble() : 0.0;
  };
  // A short run tells how much fills the stretch; of three of that length the median counts.
  const double seconds = factor(run(std::min(stretch, 1.0) * 2000.0 / robots)) * stretch;
  std::vector<Figures> runs;
  for (int i = 0; i < 3; ++i) runs.push_back(run(seconds));
  std::sort(runs.begin(), runs.end(),
            [&](const Figures& a, const Figures& b) { return factor(a) < factor(b); });
  return runs[1];
}

// How each benchmark is run, for so many seconds of wall-clock time; a row names one.
using Benchmark = std::function<Figures(double seconds)>;

const std::map<std::string, Benchmark>& Benchmarks() {
  const auto timed = [](const char* name) {
    return [name](double seconds) {
      return RunBenchmark({name, "--seconds", fmt::format("{}", seconds / 2.0)});
    };
  };
  const auto fleet = [](int robots) {
    return [robots](double seconds) { return Fleet(robots, seconds); };
  };
  static const std::map<std::string, Benchmark> all = {
      {"fleet 1", fleet(1)},       {"fleet 10", fleet(10)},     {"fleet 100", fleet(100)},
      {"fleet 1000", fleet(1000)}, {"rays", timed("rays")},     {"embree", timed("embree")},
      {"link", timed("link")},     {"player", timed("player")},
  };
  return all;
}

// One line of the table.
struct Row {
  const char* what;
  const char* unit;
  double required;  // in the unit
  double aim;
  const char* benchmark;  // of Benchmarks()
  const char* figure;     // its name there
  double scale = 1.0;     // unit per unit of the figure
  bool less_is_more = false;
  const char* aim_of = nullptr;  // where set, the aim is that share of this figure
};

// In the order of the table. A row whose figure is not there is shown as not measured.
constexpr Row kRows[] = {
    {"fleet of 1 robot", "sim s / wall s", 5000, 20000, "fleet 1", "sim_s_per_wall_s"},
    {"fleet of 10 robots", "sim s / wall s", 1500, 3000, "fleet 10", "sim_s_per_wall_s"},
    {"fleet of 100 robots", "sim s / wall s", 150, 300, "fleet 100", "sim_s_per_wall_s"},
    {"fleet of 1000 robots", "sim s / wall s", 12, 30, "fleet 1000", "sim_s_per_wall_s"},
    {"memory, 1000 robots", "MB", 100, 50, "fleet 1000", "peak_rss_mb", 1.0, true},
    {"load time, 1000 robots", "s", 0.5, 0.2, "fleet 1000", "load_s", 1.0, true},
    {"planar rays, SyRoTek, one core", "M/s", 50, 150, "rays", "planar_full_arena_rays_per_s",
     1e-6},
    {"planar rays, peers' arena, one core", "M/s", 200, 400, "rays",
     "planar_peers_arena_rays_per_s", 1e-6},
    {"Embree rays, 1000 robots, one core", "M/s", 4, 0.8, "embree", "rays_per_s", 1e-6, false,
     "raw_rays_per_s"},
    {"client in lock-step", "sim s / wall s", 1000, 2500, "link", "lockstep_sim_s_per_wall_s"},
    {"Read() in real time, p50", "us", 100, 40, "link", "read_p50_us", 1.0, true},
    {"Read() in real time, p99", "us", 1000, 300, "link", "read_p99_us", 1.0, true},
    {"canvas, fast link against JSON", "times", 30, 100, "link", "canvas_ratio"},
    {"Player client in lock-step", "sim s / wall s", 1000, 2500, "player",
     "lockstep_sim_s_per_wall_s"},
    {"Player's Read() in real time, p50", "us", 100, 60, "player", "read_from_due_p50_us", 1.0,
     true},
    {"Player's Read() in real time, p99", "us", 1000, 300, "player", "read_from_due_p99_us", 1.0,
     true},
    {"100 Player clients, data missed", "rounds", 0, 0, "player", "fleet_missed", 1.0, true},
    {"100 Player clients, server's time", "% of a core", 50, 10, "player", "fleet_percent_of_core",
     1.0, true},
};

using FiguresByBenchmark = std::map<std::string, Figures>;

// A figure of the row's benchmark, in the row's unit.
std::optional<double> Get(const Row& row, const char* figure, const FiguresByBenchmark& figures) {
  const auto found = figures.find(row.benchmark);
  const Json* const value = found != figures.end() ? found->second.Find(figure) : nullptr;
  if (value == nullptr || !value->IsNumber()) return std::nullopt;
  return value->AsDouble() * row.scale;
}

std::optional<double> Measured(const Row& row, const FiguresByBenchmark& figures) {
  return Get(row, row.figure, figures);
}

std::optional<double> Aim(const Row& row, const FiguresByBenchmark& figures) {
  if (row.aim_of == nullptr) return row.aim;
  const auto whole = Get(row, row.aim_of, figures);
  return whole ? std::optional(row.aim * *whole) : std::nullopt;
}

bool Meets(const Row& row, double measured, double wanted) {
  return row.less_is_more ? measured <= wanted : measured >= wanted;
}

std::string Verdict(const Row& row, const FiguresByBenchmark& figures) {
  const auto measured = Measured(row, figures);
  const auto aim = Aim(row, figures);
  if (!measured) return "not measured";
  if (!Meets(row, *measured, row.required)) return "NO";
  return aim && Meets(row, *measured, *aim) ? "yes, and the aim" : "yes";
}

std::string NumberText(const std::optional<double>& value) {
  if (!value) return "-";
  return *value >= 1000.0 ? fmt::format("{:.0f}", *value) : fmt::format("{:.3g}", *value);
}

// "AMD EPYC ..., 2 cores": the machine that a table is of.
std::string Machine() {
  std::string model = "unknown processor";
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) model = line.substr(colon + 2);
    break;
  }
  return fmt::format("{}, {} cores", model, std::thread::hardware_concurrency());
}

void PrintTable(const FiguresByBenchmark& figures) {
  fmt::print("{}\n\n{:<36} {:<15} {:>9} {:>9} {:>9}  {}\n", Machine(), "", "unit", "required",
             "aim", "measured", "met?");
  for (const Row& row : kRows) {
    fmt::print("{:<36} {:<15} {:>9} {:>9} {:>9}  {}\n", row.what, row.unit,
               NumberText(row.required), NumberText(Aim(row, figures)),
               NumberText(Measured(row, figures)), Verdict(row, figures));
  }
}

void PrintJson(const FiguresByBenchmark& figures) {
  Json::Array rows;
  for (const Row& row : kRows) {
    const auto measured = Measured(row, figures);
    const auto aim = Aim(row, figures);
    rows.emplace_back(
        Json::Object{{"what", row.what},
                     {"unit", row.unit},
                     {"required", row.required},
                     {"aim", aim ? Json(*aim) : Json()},
                     {"measured", measured ? Json(*measured) : Json()},
                     {"met", measured ? Json(Meets(row, *measured, row.required)) : Json()},
                     {"aim_met", measured && aim ? Json(Meets(row, *measured, *aim)) : Json()}});
  }
  Json::Object benchmarks;
  for (const auto& [name, values] : figures) benchmarks.emplace_back(name, values);
  fmt::print("{}\n", Json(Json::Object{{"machine", Machine()},
                                       {"rows", std::move(rows)},
                                       {"benchmarks", std::move(benchmarks)}})
                         .Dump());
}

}  // namespace

int BenchAll(const BenchAllArguments& arguments) {
  FiguresByBenchmark figures;
  for (const Row& row : kRows) {
    if (figures.contains(row.benchmark)) continue;
    fmt::print(stderr, "measuring: {}\n", row.benchmark);
    figures[row.benchmark] = Benchmarks().at(row.benchmark)(arguments.seconds);
  }
  if (arguments.json) {
    PrintJson(figures);
  } else {
    PrintTable(figures);
  }
  return 0;
}

}  // namespace ccmorse::tools
