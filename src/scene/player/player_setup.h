#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/json.h"

namespace ccmorse::scene {

class Field;

/// Player's port where nothing else is said (specs: player.md C.2).
inline constexpr int kPlayerPort = 6665;

/// A device as .cfg files name it, "key:host:robot:interface:index" with fields missing from the
/// left (specs: player.md C.2).
struct PlayerAddress {
  std::string key;         ///< picks among several of one interface: "input"; "" for none
  std::string host;        ///< "" for this machine
  int port = kPlayerPort;  ///< the field "robot", 1..65535
  std::string interface;   ///< "position2d", one of PlayerInterfaces()
  int index = 0;           ///< 0..65535

  bool operator==(const PlayerAddress&) const = default;
};

/// Reads "laser:0", "6666:position2d:0", "input:::position2d:0" ... Throws Error that says what is
/// wrong, without a place.
PlayerAddress ParsePlayerAddress(std::string_view text);

/// The shortest text that ParsePlayerAddress reads back the same.
std::string ToText(const PlayerAddress& address);

/// Names of Player's interfaces (specs: player.md B.7), sorted.
const std::vector<std::string>& PlayerInterfaces();

/// A device that the simulation itself provides, as Stage's plugin does.
struct PlayerDevice {
  int port = kPlayerPort;
  std::string interface;  ///< "position2d", "ranger", "laser", "sonar", "ir"; "simulation",
                          ///< "graphics2d"
  int index = 0;
  /// The scenario's robot that carries it; "" for simulation, which all robots share.
  std::string robot;
  /// Component of that robot whose data it has: "pose" or "odometry" for position2d, which is
  /// commanded by "motion"; "hokuyo", "sonar" or a name of RobotDef::rangers. "" where it has none.
  std::string device;
};

/// A driver of the server that is no part of the simulation: "snd", "vfh", "rangertolaser" ...
struct PlayerDriver {
  std::string name;
  std::vector<PlayerAddress> provided;  ///< .cfg: provides
  std::vector<PlayerAddress> needed;    ///< .cfg: requires
  bool always_on = false;               ///< starts at once, not with its first subscriber
  double length_unit = 1.0;             ///< m in a length among the options
  double angle_unit = 1.0;              ///< rad in an angle among the options
  /// The rest of its section as written: numbers, strings and lists of both.
  Json::Object options;
  /// "FILE:LINE" of each option, in the same order.
  std::vector<std::string> places;

  // An option by name, in m and rad, or `fallback` where it is not given. Throws Error "FILE:LINE:
  // ..." where it is of another type.
  double Number(std::string_view option, double fallback) const;
  int Integer(std::string_view option, int fallback) const;       ///< within +-1e9
  double Length(std::string_view option, double fallback) const;  ///< m
  double Angle(std::string_view option, double fallback) const;   ///< rad
  std::string Text(std::string_view option, const std::string& fallback) const;
  bool Bool(std::string_view option, bool fallback) const;  ///< 1, 0, yes, no, true, false
  /// A tuple of exactly units.size() numbers, by letter: l in m, a in rad, f as written. nullopt
  /// where it is not given.
  std::optional<std::vector<double>> Tuple(std::string_view option, std::string_view units) const;
  const Json* Find(std::string_view option) const;  ///< as written; nullptr: not given

 private:
  [[noreturn]] void Fail(std::string_view option, const std::string& text) const;
};

/// What a Player server offers: the content of a .cfg, or a scenario's "player" (docs/scenario.md).
struct PlayerSetup {
  std::vector<PlayerDevice> devices;
  std::vector<PlayerDriver> drivers;

  /// Ports to listen on: all that occur among devices and what local drivers provide, ascending.
  std::vector<int> Ports() const;
};

/// Reads a scenario's "player". Throws Error.
PlayerSetup ReadPlayerSetup(const Field& field);

/// The same, as ReadPlayerSetup reads it.
Json PlayerSetupToJson(const PlayerSetup& setup);

}  // namespace ccmorse::scene
