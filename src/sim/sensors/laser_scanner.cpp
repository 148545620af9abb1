#include "sim/sensors/laser_scanner.h"

#include <algorithm>
#include <array>

#include "base/polygon.h"
#include "base/trig.h"
#include "sim/robots/robot.h"
#include "sim/world.h"

namespace ccmorse::sim {

LaserScanner::LaserScanner(Robot& robot, const std::string& name, const scene::LaserDef& def,
                           const World& world, std::uint64_t seed)
    : Sensor(robot, name, "LaserScanner", def.frequency),
      def_(def),
      world_(world),
      scanner_(def.samples, -Radians(def.scan_window_deg) / 2.0, Radians(def.resolution_deg),
               def.range),
      noise_(seed, full_name()),
      ranges_(static_cast<std::size_t>(def.samples), def.range) {
  world_.PrepareCut(Height());
}

double LaserScanner::Height() const { return robot().model().origin_height + def_.position.z; }

void LaserScanner::Sample(const Instant& now) {
  const Pose2& base = robot().pose();
  const Vec2 at = Transform(base, {def_.position.x, def_.position.y});
  scanner_.Scan({at.x, at.y, base.yaw + def_.yaw}, world_.BoxesAt(Height()),
                world_.RobotsAt(Height()), robot().index(), ranges_);
  if (def_.range_std > 0.0) AddNoise(now.tick);
  DataChanged(now.time);
}

void LaserScanner::AddNoise(std::uint64_t tick) {
  // Two at a time, as they are made, so that no scratch is needed.
  for (std::size_t i = 0; i < ranges_.size(); i += 2) {
    std::array<double, 2> off{};
    noise_.AddGaussian(tick, def_.range_std, off.data(), 2, static_cast<std::uint32_t>(i));
    for (std::size_t k = i; k < std::min(i + 2, ranges_.size()); ++k) {
      // A beam without a hit has no range to be wrong about.
      if (ranges_[k] < def_.range)
        ranges_[k] = std::clamp(ranges_[k] + off[k - i], 0.0, def_.range);
    }
  }
}

void LaserScanner::Reset() {
  Sensor::Reset();
  std::fill(ranges_.begin(), ranges_.end(), def_.range);
}

void LaserScanner::AddToHash(StateHash& hash) const { hash.Add(ranges_); }

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
