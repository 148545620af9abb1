#include "sim/sensors/laser_scanner.h"

#include <algorithm>

#include "sim/rays/range_engine.h"
#include "sim/robots/robot.h"
#include "sim/world.h"

namespace ccmorse::sim {

LaserScanner::LaserScanner(Robot& robot, const std::string& name, const scene::LaserDef& def,
                           const World& world)
    : Sensor(robot, name, "LaserScanner", def.frequency),
      def_(def),
      world_(world),
      fan_(def),
      ranges_(fan_.count(), def.range) {}

void LaserScanner::Sample(const Instant& now) {
  world_.rays().Scan(fan_, robot().pose(), robot().model().origin_height, robot().index(), ranges_);
  DataChanged(now.time);
}

void LaserScanner::Reset() {
  Sensor::Reset();
  std::fill(ranges_.begin(), ranges_.end(), def_.range);
}

void LaserScanner::AddToHash(StateHash& hash) const {
  for (const double range : ranges_) hash.Add(range);
}

Json LaserScanner::Configurations() const {
  return Json(Json::Object{{"laser_range", def_.range},
                           {"resolution", def_.resolution_deg},
                           {"scan_window", def_.scan_window_deg},
                           {"Visible_arc", def_.visible_arc},
                           {"layers", def_.layers},
                           {"layer_separation", def_.layer_separation},
                           {"layer_offset", def_.layer_offset},
                           {"frequency", def_.frequency}});
}

void LaserScanner::AppendFields(std::string& out) const {
  out += ", \"point_list\": [";
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    out += i == 0 ? "[" : ", [";
    const bool hit = ranges_[i] < def_.range;
    const Vec3 point = hit ? ranges_[i] * fan_.Direction(i) : Vec3{};
    AppendJson(out, point.x);
    out += ", ";
    AppendJson(out, point.y);
    out += ", ";
    AppendJson(out, point.z);
    out += ']';
  }
  out += "], \"range_list\": [";
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    if (i > 0) out += ", ";
    AppendJson(out, ranges_[i]);
  }
  out += ']';
}

}  // namespace ccmorse::sim
