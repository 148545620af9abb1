#include "servers/run_report.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "sim/sensors/laser_scanner.h"

namespace ccmorse::servers {

LaserUse CountScans(const sim::Robot& robot, const MorseServer& server) {
  LaserUse use;
  for (const sim::Sensor* sensor : robot.sensors()) {
    if (dynamic_cast<const sim::LaserScanner*>(sensor) == nullptr) continue;
    use.scans += sensor->samples();
    use.used += server.SamplesUsed(sensor->full_name());
  }
  return use;
}

Json ReportJson(const sim::Simulation& simulation, const MorseServer& server,
                const RunSummary& summary, Pace pace) {
  Json robots(Json::Object{});
  for (const auto& robot : simulation.robots()) {
    const LaserUse use = CountScans(*robot, server);
    const Pose2& pose = robot->pose();
    robots.Set(robot->name(),
               Json::Object{{"distance", robot->tally().distance},
                            {"contacts", static_cast<std::int64_t>(robot->tally().contacts)},
                            {"stalled", robot->tally().stalled},
                            {"scans", static_cast<std::int64_t>(use.scans)},
                            {"scans_used", static_cast<std::int64_t>(use.used)},
                            {"pose", Json::Array{pose.x, pose.y, pose.yaw}}});
  }
  return Json(Json::Object{
      {"scenario", simulation.scenario().name},
      {"pace", PaceName(pace)},
      {"ticks", static_cast<std::int64_t>(simulation.tick())},
      {"simulated_s", summary.simulated},
      {"wall_s", summary.wall},
      {"real_time_factor", summary.wall > 0.0 ? summary.simulated / summary.wall : 0.0},
      {"hash", fmt::format("{:016x}", simulation.Hash())},
      {"robots", std::move(robots)}});
}

void WriteReport(const Json& report, const std::string& file) {
  std::ofstream out(file);
  if (!(out << report.Dump() << "\n") || !out.flush()) {
    throw Error("cannot write " + file + ": " + std::strerror(errno));
  }
}

void PrepareFile(const std::string& file) {
  if (file.empty()) return;
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::error_code failed;
  if (!folder.empty()) std::filesystem::create_directories(folder, failed);
  if (failed) throw Error("cannot make the folder for " + file + ": " + failed.message());
  const bool existed = std::filesystem::exists(file, failed);
  errno = 0;
  if (!std::ofstream(file, std::ios::app)) {
    throw Error("cannot write " + file + ": " + std::strerror(errno));
  }
  if (!existed) std::filesystem::remove(file, failed);
}

}  // namespace ccmorse::servers
