#include "servers/player/drivers/driver.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace ccmorse::servers::player {

std::string DriverOptions::Place(std::string_view name) const {
  for (std::size_t i = 0; i < std::min(values.size(), places.size()); ++i) {
    if (values[i].first == name) return places[i] + ": ";
  }
  return "";
}

void DriverOptions::Fail(std::string_view name, const std::string& text) const {
  throw Error(Place(name) + "option '" + std::string(name) + "' must be " + text);
}

const Json* DriverOptions::Find(std::string_view name) const {
  asked.emplace(name);
  for (const auto& [key, value] : values) {
    if (key == name) return &value;
  }
  return nullptr;
}

double DriverOptions::Number(std::string_view name, double fallback) const {
  const Json* const value = Find(name);
  if (value == nullptr) return fallback;
  if (!value->IsNumber()) Fail(name, "a number");
  return value->AsDouble();
}

double DriverOptions::Length(std::string_view name, double fallback) const {
  return Find(name) == nullptr ? fallback : Number(name, 0.0) * length_unit;
}

double DriverOptions::Angle(std::string_view name, double fallback) const {
  return Find(name) == nullptr ? fallback : Number(name, 0.0) * angle_unit;
}

std::string DriverOptions::Text(std::string_view name, const std::string& fallback) const {
  const Json* const value = Find(name);
  if (value == nullptr) return fallback;
  if (!value->IsString()) Fail(name, "a text");
  return value->AsString();
}

int DriverOptions::Integer(std::string_view name, int fallback) const {
  const double number = Number(name, fallback);
  if (number != std::floor(number) || std::fabs(number) > 1e9) {
    Fail(name, "a whole number");
  }
  return static_cast<int>(number);
}

bool DriverOptions::Flag(std::string_view name, bool fallback) const {
  const Json* const value = Find(name);
  if (value == nullptr) return fallback;
  if (value->IsBool()) return value->AsBool();
  if (value->IsNumber()) return value->AsDouble() != 0.0;
  const std::string text = Text(name, "");
  if (text == "yes" || text == "true") return true;
  if (text == "no" || text == "false") return false;
  Fail(name, "1, 0, yes, no, true or false");
}

void DriverOptions::Tuple(std::string_view name, std::string_view units,
                          std::span<double> to) const {
  const Json* const value = Find(name);
  if (value == nullptr) return;
  const auto is_number = [](const Json& item) { return item.IsNumber(); };
  if (!value->IsArray() || value->AsArray().size() != units.size() ||
      !std::all_of(value->AsArray().begin(), value->AsArray().end(), is_number)) {
    Fail(name, "a tuple of " + std::to_string(units.size()) + " numbers");
  }
  for (std::size_t i = 0; i < units.size(); ++i) {
    to[i] = value->AsArray()[i].AsDouble() * (units[i] == 'l'   ? length_unit
                                              : units[i] == 'a' ? angle_unit
                                                                : 1.0);
  }
}

Driver::Driver(const DriverDef& def, const DeviceList& devices) : def_(def), devices_(devices) {}

Driver::~Driver() {
  if (users_ == 0) return;
  for (Device* const device : required_) device->Unsubscribe(*this);
}

Driver::Provided* Driver::Provide(std::uint16_t interface_code, Device::Capabilities capabilities,
                                  std::string_view key) {
  for (const DriverDevice& each : def_.provided) {
    if (wire::InterfaceCode(each.interface_name) != interface_code) continue;
    if (!key.empty() && each.key != key) continue;
    auto device = std::make_shared<Provided>(
        *this, interface_code, static_cast<std::uint16_t>(each.index), def_.name, capabilities);
    provided_.push_back(device);
    return device.get();
  }
  return nullptr;
}

Driver::Provided* Driver::ProvideOne(std::uint16_t interface_code, int index) {
  auto device = std::make_shared<Provided>(*this, interface_code, static_cast<std::uint16_t>(index),
                                           def_.name, Device::Capabilities());
  provided_.push_back(device);
  return device.get();
}

std::vector<Device*> Driver::RequireAll() {
  std::vector<Device*> all;
  for (const DriverDevice& each : def_.required) all.push_back(RequireNamed(each));
  return all;
}

Device* Driver::RequireIfGiven(std::uint16_t interface_code, std::string_view key) {
  const DriverDevice* found = nullptr;
  for (const DriverDevice& each : def_.required) {
    if (wire::InterfaceCode(each.interface_name) != interface_code) continue;
    if (found == nullptr ? key.empty() || each.key.empty() || each.key == key : each.key == key) {
      found = &each;
    }
  }
  return found == nullptr ? nullptr : RequireNamed(*found);
}

Device* Driver::RequireNamed(const DriverDevice& named) {
  const auto code = wire::InterfaceCode(named.interface_name);
  Device* const device =
      code ? devices_.Find(*code, static_cast<std::uint16_t>(named.index)) : nullptr;
  if (device == nullptr) {
    throw Error("driver " + def_.name + ": there is no " + named.interface_name + ":" +
                std::to_string(named.index) + ", which it requires");
  }
  if (std::find(required_.begin(), required_.end(), device) == required_.end()) {
    required_.push_back(device);
  }
  return device;
}

Device& Driver::Require(std::uint16_t interface_code, std::string_view key) {
  Device* const device = RequireIfGiven(interface_code, key);
  if (device == nullptr) {
    throw Error("driver " + def_.name + " requires a " +
                std::string(wire::InterfaceName(interface_code)) +
                (key.empty() ? "" : " \"" + std::string(key) + "\""));
  }
  return *device;
}

void Driver::KeepOn(bool on) {
  if (on == kept_on_) return;
  kept_on_ = on;
  on ? UserCame() : UserLeft();
}

void Driver::UserCame() {
  if (++users_ > 1) return;
  for (Device* const device : required_) device->Subscribe(*this);
  Started();
}

void Driver::UserLeft() {
  if (--users_ > 0) return;
  Stopped();
  for (Device* const device : required_) device->Unsubscribe(*this);
}

}  // namespace ccmorse::servers::player
