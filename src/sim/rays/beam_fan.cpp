#include "sim/rays/beam_fan.h"

#include <cmath>
#include <map>
#include <mutex>
#include <tuple>

#include "base/polygon.h"
#include "base/trig.h"

namespace ccmorse::sim {
namespace {

std::vector<Vec3> LayeredDirections(const scene::LaserDef& def) {
  std::vector<Vec3> directions;
  // MORSE adds the resolution again and again, in degrees, and so do we.
  double elevation = def.layers > 1 ? def.layer_separation * (def.layers - 1) / 2.0 : 0.0;
  for (int layer = 0; layer < def.layers; ++layer) {
    double bearing = -def.scan_window_deg / 2.0;
    if (def.layers > 1 && layer % 2 == 0) bearing += def.layer_offset;
    const double rise = SinCos(Radians(elevation)).sin;
    for (int i = 0; i < def.samples; ++i) {
      const auto [s, c] = SinCos(Radians(bearing));
      const double length = std::sqrt(c * c + s * s + rise * rise);
      directions.push_back({c / length, s / length, rise / length});
      bearing += def.resolution_deg;
    }
    elevation -= def.layer_separation;
  }
  return directions;
}

}  // namespace

BeamFan::BeamFan(const scene::LaserDef& def)
    : def_(def),
      count_(static_cast<std::size_t>(def.samples) * static_cast<std::size_t>(def.layers)),
      range_(def.range),
      position_(def.position),
      rotation_(FromEuler(def.roll, def.pitch, def.yaw)) {
  if (def.layers == 1 && def.roll == 0.0 && def.pitch == 0.0) {
    planar_.emplace(def.samples, -Radians(def.scan_window_deg) / 2.0, Radians(def.resolution_deg),
                    def.range);
  }
}

Vec3 BeamFan::Direction(std::size_t i) const {
  if (!upright()) return directions()[i];
  const Vec2 direction = planar_->Direction(static_cast<int>(i));
  return {direction.x, direction.y, 0.0};
}

const std::vector<Vec3>& BeamFan::directions() const {
  if (directions_) return *directions_;
  using Key = std::tuple<int, double, double, int, double, double, bool>;
  static std::mutex mutex;
  static std::map<Key, std::weak_ptr<const std::vector<Vec3>>> known;
  const std::lock_guard lock(mutex);
  std::weak_ptr<const std::vector<Vec3>>& entry =
      known[{def_.samples, def_.scan_window_deg, def_.resolution_deg, def_.layers,
             def_.layer_separation, def_.layer_offset, upright()}];
  directions_ = entry.lock();
  if (!directions_) {
    std::vector<Vec3> made;
    if (upright()) {
      for (std::size_t i = 0; i < count_; ++i) made.push_back(Direction(i));
    } else {
      made = LayeredDirections(def_);
    }
    entry = directions_ = std::make_shared<const std::vector<Vec3>>(std::move(made));
  }
  return *directions_;
}

Pose2 BeamFan::PlanarPose(const Pose2& robot) const {
  const Vec2 at = Transform(robot, {position_.x, position_.y});
  return {at.x, at.y, robot.yaw + def_.yaw};
}

}  // namespace ccmorse::sim
