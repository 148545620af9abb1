#include "sim/sensors/laser_scanner.h"

#include <algorithm>

#include "base/polygon.h"
#include "base/trig.h"
#include "sim/robots/robot.h"
#include "sim/world.h"

namespace ccmorse::sim {

LaserScanner::LaserScanner(Robot& robot, const std::string& name, const scene::LaserDef& def,
                           const World& world)
    : Sensor(robot, name, "LaserScanner", def.frequency),
      def_(def),
      world_(world),
      scanner_(def.samples, -Radians(def.scan_window_deg) / 2.0, Radians(def.resolution_deg),
               def.range),
      ranges_(static_cast<std::size_t>(def.samples), def.range) {}

void LaserScanner::Sample(const Instant& now) {
  const Pose2& base = robot().pose();
  const Vec2 at = Transform(base, {def_.position.x, def_.position.y});
  const double height = robot().model().origin_height + def_.position.z;
  scanner_.Scan({at.x, at.y, base.yaw + def_.yaw}, world_.BoxesAt(height), world_.RobotsAt(height),
                robot().index(), ranges_);
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
                           {"layers", 1},
                           {"layer_separation", 0.8},
                           {"layer_offset", def_.layer_offset},
                           {"frequency", def_.frequency}});
}

void LaserScanner::AppendNumbers(std::vector<double>& out) const {
  out.insert(out.end(), ranges_.begin(), ranges_.end());
}

void LaserScanner::AppendFields(std::string& out) const {
  out += ", \"point_list\": [";
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    out += i == 0 ? "[" : ", [";
    const bool hit = ranges_[i] < def_.range;
    const Vec2 point = (hit ? ranges_[i] : 0.0) * scanner_.Direction(static_cast<int>(i));
    AppendJson(out, hit ? point.x : 0.0);
    out += ", ";
    AppendJson(out, hit ? point.y : 0.0);
    out += ", 0.0]";
  }
  out += "], \"range_list\": [";
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    if (i > 0) out += ", ";
    AppendJson(out, ranges_[i]);
  }
  out += ']';
}

}  // namespace ccmorse::sim
