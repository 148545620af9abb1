#include "sim/sensors/compound_sensor.h"

#include <algorithm>
#include <string_view>

#include "sim/robots/robot.h"

namespace ccmorse::sim {
namespace {

std::string_view Trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

CompoundSensor::CompoundSensor(Robot& robot, const std::string& name, const World& world)
    : Sensor(robot, name, "CompoundSensor", 60.0), world_(world) {
  AddProperty("sensors", names_);
}

void CompoundSensor::Find() {
  if (found_) return;
  found_ = true;
  sensors_.clear();
  const std::string_view all = names_;
  for (std::size_t begin = 0; begin <= all.size();) {
    const std::size_t end = std::min(all.find(',', begin), all.size());
    const std::string_view wanted = Trimmed(all.substr(begin, end - begin));
    begin = end + 1;
    for (const Robot* robot : world_.robots()) {
      for (const auto& component : robot->components()) {
        // One that is a compound could hold this one, and have no end.
        if (component->full_name() != wanted || component->type() == type()) continue;
        if (dynamic_cast<const Sensor*>(component.get()) != nullptr) {
          sensors_.push_back(component.get());
        }
      }
    }
  }
}

void CompoundSensor::Sample(const Instant& now) {
  Find();
  DataChanged(now.time);
}

void CompoundSensor::Reset() {
  Sensor::Reset();
  found_ = false;
  sensors_.clear();
}

void CompoundSensor::AppendFields(std::string& out) const {
  for (Component* sensor : sensors_) {
    out += ", ";
    AppendJson(out, std::string_view(sensor->full_name()));
    out += ": ";
    out += sensor->LocalData();
  }
}

}  // namespace ccmorse::sim
