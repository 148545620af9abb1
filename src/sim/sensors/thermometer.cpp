#include "sim/sensors/thermometer.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "base/trig.h"
#include "sim/robots/robot.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

namespace {

// What the property says of its strength: itself where it is a number.
double Strength(const Json& value, double otherwise) {
  return value.IsNumber() ? value.AsDouble() : otherwise;
}

}  // namespace

Thermometer::Thermometer(Robot& robot, const std::string& name, const World& world)
    : Sensor(robot, name, "Thermometer", 60.0),
      world_(world),
      range_(static_cast<double>(std::numeric_limits<std::int64_t>::max())) {
  constexpr double kAny = 1e12;
  AddProperty("FireTag", tag_);
  AddProperty("DefaultTemperature", default_, -kAny, kAny);
  AddProperty("FireTemperature", fire_, -kAny, kAny);
  AddProperty("Range", range_, 0.0, std::numeric_limits<double>::infinity());
  AddProperty("Alpha", alpha_, 0.0, kAny);
}

void Thermometer::Sample(const Instant& now) {
  const Vec3 here = PlaceOfMount(*this).position;
  temperature_ = default_;
  for (const SceneObject& object : world_.objects().all()) {
    const Json* const fire = object.properties.Find(tag_);
    if (fire == nullptr || object.robot == &robot()) continue;
    const Vec3 off = object.WorldPosition() - here;
    const double distance = std::sqrt(Dot(off, off));
    if (distance < range_) temperature_ += Strength(*fire, fire_) * Exp(-alpha_ * distance);
  }
  DataChanged(now.time);
}

void Thermometer::Reset() {
  Sensor::Reset();
  temperature_ = 0.0;
}

void Thermometer::AddToHash(StateHash& hash) const { hash.Add(temperature_); }

void Thermometer::AppendFields(std::string& out) const {
  AppendField(out, "temperature", temperature_);
}

}  // namespace ccmorse::sim
