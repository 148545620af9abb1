#include "scene/player/player_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/trig.h"
#include "scene/field.h"

namespace ccmorse::scene {
namespace {

// A whole number of digits only, at most `most`; -1 for anything else.
int WholeNumber(std::string_view text, int most) {
  int number = -1;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool fine = read.ec == std::errc{} && read.ptr == text.data() + text.size() &&
                    text.front() != '-' && number <= most;
  return fine ? number : -1;
}

void CheckInterface(const std::string& interface) {
  const std::vector<std::string>& known = PlayerInterfaces();
  if (std::find(known.begin(), known.end(), interface) != known.end()) return;
  throw Error(fmt::format("{} is no interface of Player{}", Quoted(interface),
                          DidYouMean(interface, known)));
}

PlayerAddress AddressField(const Field& field) {
  try {
    return ParsePlayerAddress(field.Text());
  } catch (const Error& error) {
    field.Fail(error.what());
  }
}

std::vector<PlayerAddress> Addresses(ObjectReader& reader, const std::string& key) {
  std::vector<PlayerAddress> addresses;
  if (!reader.Has(key)) return addresses;
  for (const Field& item : reader.Require(key).Items()) addresses.push_back(AddressField(item));
  return addresses;
}

Json AddressesToJson(const std::vector<PlayerAddress>& addresses) {
  Json::Array texts;
  for (const PlayerAddress& address : addresses) texts.emplace_back(ToText(address));
  return texts;
}

bool IsNumber(const Json& value) { return value.IsNumber() && std::isfinite(value.AsDouble()); }

// Text that can stand in a .cfg, too: a message shows it on one line.
bool IsText(const Json& value) {
  return value.IsString() &&
         std::none_of(value.AsString().begin(), value.AsString().end(),
                      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
}

void ReadOptions(const Field& field, PlayerDriver& driver) {
  ObjectReader reader(field);
  for (const auto& [name, value] : field.value().AsObject()) {
    const Field option = reader.Require(name);
    const bool fine = IsNumber(value) || IsText(value) || value.IsBool() ||
                      (value.IsArray() && std::all_of(value.AsArray().begin(),
                                                      value.AsArray().end(), [](const Json& item) {
                                                        return IsNumber(item) || IsText(item);
                                                      }));
    if (!fine)
      option.FailHere("must be a number, a string, true, false or a list of the first two");
    driver.options.emplace_back(name, value);
    driver.places.push_back(fmt::format("{}:{}", option.file(), option.line()));
  }
}

PlayerDevice ReadDevice(const Field& field) {
  // What the simulation has something for (specs: player.md C.2).
  static const std::vector<std::string> interfaces = {
      "position2d", "ranger", "laser", "sonar", "ir", "simulation", "graphics2d"};
  ObjectReader reader(field);
  PlayerDevice device;
  const Field address_field = reader.Require("address");
  const PlayerAddress address = AddressField(address_field);
  if (!address.key.empty() || !address.host.empty()) {
    address_field.FailHere(
        "must be PORT:INTERFACE:INDEX or INTERFACE:INDEX: it is on this machine");
  }
  if (std::find(interfaces.begin(), interfaces.end(), address.interface) == interfaces.end()) {
    address_field.FailHere(fmt::format("is of interface {}, but robots have {} only",
                                       Quoted(address.interface), Listed(interfaces)));
  }
  device.port = address.port;
  device.interface = address.interface;
  device.index = address.index;
  if (device.interface != "simulation") device.robot = reader.Require("robot").Identifier();
  if (device.interface != "simulation" && device.interface != "graphics2d") {
    device.device = reader.Require("device").Identifier();
  }
  reader.Finish();
  return device;
}

PlayerDriver ReadDriver(const Field& field) {
  ObjectReader reader(field);
  PlayerDriver driver;
  const Field name = reader.Require("name");
  driver.name = name.Text();
  if (driver.name.empty() || !IsText(name.value())) name.FailHere("must be the name of a driver");
  driver.provided = Addresses(reader, "provides");
  driver.needed = Addresses(reader, "requires");
  driver.always_on = reader.Bool("alwayson", driver.always_on);
  driver.length_unit = reader.Number("length_unit", driver.length_unit, {0.0, 1e3, true});
  driver.angle_unit = reader.Number("angle_unit", driver.angle_unit, {0.0, 1e3, true});
  if (reader.Has("options")) ReadOptions(reader.Require("options"), driver);
  reader.Finish();
  return driver;
}

}  // namespace

PlayerAddress ParsePlayerAddress(std::string_view text) {
  const std::string quoted = Quoted(text);
  std::vector<std::string_view> fields;
  for (std::string_view rest = text;;) {
    const std::size_t colon = rest.find(':');
    fields.push_back(rest.substr(0, colon));
    if (colon == std::string_view::npos) break;
    rest = rest.substr(colon + 1);
  }
  if (fields.size() < 2 || fields.size() > 5) {
    throw Error(
        fmt::format("{} is no device; write INTERFACE:INDEX, as \"laser:0\", or all of "
                    "KEY:HOST:ROBOT:INTERFACE:INDEX",
                    quoted));
  }
  while (fields.size() < 5) fields.insert(fields.begin(), std::string_view{});
  PlayerAddress address;
  address.key = fields[0];
  address.host = fields[1];
  if (!fields[2].empty()) {
    address.port = WholeNumber(fields[2], 65535);
    if (address.port < 1) {
      throw Error(fmt::format("{} has {} for its robot, which is the number of a port, 1..65535",
                              quoted, Quoted(fields[2])));
    }
  }
  address.interface = fields[3];
  CheckInterface(address.interface);
  address.index = fields[4].empty() ? -1 : WholeNumber(fields[4], 65535);
  if (address.index < 0) {
    throw Error(
        fmt::format("{} ends in {}, must be in an index 0..65535", quoted, Quoted(fields[4])));
  }
  return address;
}

std::string ToText(const PlayerAddress& address) {
  const std::string port = address.port == kPlayerPort ? "" : std::to_string(address.port);
  const std::string end = fmt::format("{}:{}", address.interface, address.index);
  if (!address.key.empty()) return fmt::format("{}:{}:{}:{}", address.key, address.host, port, end);
  if (!address.host.empty()) return fmt::format("{}:{}:{}", address.host, port, end);
  return port.empty() ? end : port + ":" + end;
}

const std::vector<std::string>& PlayerInterfaces() {
  static const std::vector<std::string> names = {
      "actarray",     "aio",          "audio",
      "blackboard",   "blinkenlight", "blobfinder",
      "bumper",       "camera",       "coopobject",
      "dio",          "fiducial",     "gps",
      "graphics2d",   "graphics3d",   "gripper",
      "health",       "imu",          "ir",
      "joystick",     "laser",        "limb",
      "localize",     "log",          "map",
      "opaque",       "planner",      "player",
      "pointcloud3d", "position1d",   "position2d",
      "position3d",   "power",        "ptz",
      "ranger",       "rfid",         "simulation",
      "sonar",        "speech",       "speech_recognition",
      "stereo",       "vectormap",    "wifi",
      "wsn"};
  return names;
}

const Json* PlayerDriver::Find(std::string_view option) const {
  const Json* found = nullptr;
  for (const auto& [key, value] : options) {
    if (key == option) found = &value;
  }
  return found;
}

void PlayerDriver::Fail(std::string_view option, const std::string& text) const {
  std::string place;
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (options[i].first == option && i < places.size()) place = places[i] + ": ";
  }
  throw Error(fmt::format("{}{} of driver {} {}", place, Quoted(option), Quoted(name), text));
}

double PlayerDriver::Number(std::string_view option, double fallback) const {
  const Json* const value = Find(option);
  if (value == nullptr) return fallback;
  if (!value->IsNumber()) Fail(option, "must be a number");
  return value->AsDouble();
}

int PlayerDriver::Integer(std::string_view option, int fallback) const {
  const double number = Number(option, fallback);
  if (number != std::floor(number) || std::fabs(number) > 1e9) {
    Fail(option, fmt::format("must be a whole number, not {}", number));
  }
  return static_cast<int>(number);
}

double PlayerDriver::Length(std::string_view option, double fallback) const {
  return Find(option) == nullptr ? fallback : Number(option, 0.0) * length_unit;
}

double PlayerDriver::Angle(std::string_view option, double fallback) const {
  return Find(option) == nullptr ? fallback : Number(option, 0.0) * angle_unit;
}

std::string PlayerDriver::Text(std::string_view option, const std::string& fallback) const {
  const Json* const value = Find(option);
  if (value == nullptr) return fallback;
  if (!value->IsString()) Fail(option, "must be a string");
  return value->AsString();
}

bool PlayerDriver::Bool(std::string_view option, bool fallback) const {
  const Json* const value = Find(option);
  if (value == nullptr) return fallback;
  if (value->IsBool()) return value->AsBool();
  if (value->IsNumber()) return value->AsDouble() != 0.0;
  if (value->IsString()) {
    const std::string& text = value->AsString();
    if (text == "yes" || text == "true" || text == "1") return true;
    if (text == "no" || text == "false" || text == "0") return false;
  }
  Fail(option, "must be 1, 0, yes, no, true or false");
}

std::optional<std::vector<double>> PlayerDriver::Tuple(std::string_view option,
                                                       std::string_view units) const {
  const Json* const value = Find(option);
  if (value == nullptr) return std::nullopt;
  if (!value->IsArray() || value->AsArray().size() != units.size()) {
    Fail(option, fmt::format("must be a tuple of {} numbers", units.size()));
  }
  std::vector<double> numbers;
  for (const Json& item : value->AsArray()) {
    if (!item.IsNumber()) Fail(option, "must be a tuple of numbers");
    const char unit = units[numbers.size()];
    numbers.push_back(item.AsDouble() * (unit == 'l'   ? length_unit
                                         : unit == 'a' ? angle_unit
                                                       : 1.0));
  }
  return numbers;
}

std::vector<int> PlayerSetup::Ports() const {
  std::set<int> ports;
  for (const PlayerDevice& device : devices) ports.insert(device.port);
  for (const PlayerDriver& driver : drivers) {
    for (const PlayerAddress& address : driver.provided) {
      if (address.host.empty()) ports.insert(address.port);
    }
  }
  return {ports.begin(), ports.end()};
}

PlayerSetup ReadPlayerSetup(const Field& field) {
  ObjectReader reader(field);
  PlayerSetup setup;
  std::set<std::string> seen;
  const auto once = [&seen](const PlayerAddress& address, const Field& at) {
    const std::string text =
        fmt::format("{}:{}:{}", address.port, address.interface, address.index);
    if (!seen.insert(text).second) at.FailHere(fmt::format("provides {} a second time", text));
  };
  if (reader.Has("devices")) {
    for (const Field& item : reader.Require("devices").Items()) {
      setup.devices.push_back(ReadDevice(item));
      const PlayerDevice& device = setup.devices.back();
      once({"", "", device.port, device.interface, device.index}, item);
    }
  }
  if (reader.Has("drivers")) {
    for (const Field& item : reader.Require("drivers").Items()) {
      setup.drivers.push_back(ReadDriver(item));
      for (const PlayerAddress& address : setup.drivers.back().provided) once(address, item);
    }
  }
  reader.Finish();
  return setup;
}

Json PlayerSetupToJson(const PlayerSetup& setup) {
  Json::Array devices;
  for (const PlayerDevice& device : setup.devices) {
    Json::Object object = {
        {"address", ToText({"", "", device.port, device.interface, device.index})}};
    if (device.interface != "simulation") object.emplace_back("robot", device.robot);
    if (!device.device.empty()) object.emplace_back("device", device.device);
    devices.emplace_back(std::move(object));
  }
  Json::Array drivers;
  for (const PlayerDriver& driver : setup.drivers) {
    drivers.emplace_back(Json::Object{{"name", driver.name},
                                      {"provides", AddressesToJson(driver.provided)},
                                      {"requires", AddressesToJson(driver.needed)},
                                      {"alwayson", driver.always_on},
                                      {"length_unit", driver.length_unit},
                                      {"angle_unit", driver.angle_unit},
                                      {"options", driver.options}});
  }
  return Json::Object{{"devices", std::move(devices)}, {"drivers", std::move(drivers)}};
}

}  // namespace ccmorse::scene
