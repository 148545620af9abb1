#include "sim/sensors/battery.h"

#include <algorithm>
#include <cmath>

#include "sim/robots/robot.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

namespace {

constexpr double kFull = 100.0;  // %

bool Contains(const scene::ZoneDef& zone, const Vec3& point) {
  const Vec3 off = point - zone.position;
  return std::fabs(off.x) <= zone.half_size.x && std::fabs(off.y) <= zone.half_size.y &&
         std::fabs(off.z) <= zone.half_size.z;
}

}  // namespace

Battery::Battery(Robot& robot, const std::string& name, const scene::Scenario& scenario)
    : Sensor(robot, name, "Battery", 60.0) {
  for (const scene::ZoneDef& zone : scenario.zones) {
    if (zone.type == "Charging") zones_.push_back(zone);
  }
  AddProperty("DischargingRate", rate_, 0.0, 1e6);
}

void Battery::Sample(const Instant& now) {
  const Vec3 place = PlaceOfMount(*this).position;
  const double change = rate_ * (now.time - last_time_);
  last_time_ = now.time;
  const bool charging = std::any_of(zones_.begin(), zones_.end(), [&](const scene::ZoneDef& zone) {
    return Contains(zone, place);
  });
  charge_ = std::clamp(charging ? charge_ + change : charge_ - change, 0.0, kFull);
  status_ = !charging ? "Discharging" : charge_ < kFull ? "Charging" : "Charged";
  DataChanged(now.time);
}

void Battery::Reset() {
  // Time goes on when objects are put back: what passed before is no matter of the new charge.
  const double known = timestamp();
  Sensor::Reset();
  last_time_ = known;
  charge_ = kFull;
  status_ = "Charged";
}

void Battery::AddToHash(StateHash& hash) const { hash.Add(charge_); }

void Battery::AppendFields(std::string& out) const {
  AppendField(out, "charge", charge_);
  AppendField(out, "status", std::string_view(status_));
}

}  // namespace ccmorse::sim
