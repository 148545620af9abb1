#include "sim/component.h"

#include <cmath>

#include "sim/robots/robot.h"

namespace ccmorse::sim {

Component::Component(Robot& robot, const std::string& name, std::string type, double frequency)
    : robot_(robot),
      name_(name),
      full_name_(robot.name() + "." + name),
      type_(std::move(type)),
      frequency_(frequency) {}

bool Component::TakeDue(const Instant& now, double base_frequency) {
  if (now.tick < next_tick_) return false;
  if (frequency_ >= base_frequency) {
    next_tick_ = now.tick + 1;
    return true;
  }
  // Switched off for a while: the ones missed are not made up for.
  const double ticks = base_frequency / frequency_;
  const double next = std::floor(static_cast<double>(now.tick) / ticks + 1e-9) + 1.0;
  next_tick_ = static_cast<std::uint64_t>(std::ceil(next * ticks - 1e-9));
  return true;
}

const std::string& Component::LocalData() {
  if (!text_valid_) {
    text_ = "{\"timestamp\": ";
    AppendJson(text_, timestamp_);
    AppendFields(text_);
    text_ += '}';
    text_valid_ = true;
  }
  return text_;
}

void Component::Reset() {
  next_tick_ = 0;
  timestamp_ = 0.0;
  text_valid_ = false;
}

void Component::DataChanged(double time) {
  timestamp_ = time;
  text_valid_ = false;
}

void AppendField(std::string& out, const char* key, double value) {
  out += ", \"";
  out += key;
  out += "\": ";
  AppendJson(out, value);
}

void AppendField(std::string& out, const char* key, bool value) {
  out += ", \"";
  out += key;
  out += value ? "\": true" : "\": false";
}

}  // namespace ccmorse::sim
