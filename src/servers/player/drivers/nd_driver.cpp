#include "servers/player/drivers/nd_driver.h"

#include <algorithm>
#include <array>

#include "base/error.h"

namespace ccmorse::servers::player {
namespace {

int LaserBuffer(const DriverOptions& options) {
  return options.Integer("laser_buffer", navigation::NdOptions().laser_buffer);
}

GoalDriver::Eyes EyesOf(const DriverDef& def) {
  const DriverOptions& options = def.options;
  const int buffer = options.Integer("sonar_buffer", 20);
  if (buffer < 1 || buffer > 1000) throw Error("nd: sonar_buffer must be from 1 to 1000");
  const bool laser = std::any_of(def.required.begin(), def.required.end(),
                                 [](const auto& each) { return each.interface_name == "laser"; });
  GoalDriver::Eyes eyes;
  eyes.sonar = true;
  eyes.sonar_range = options.Length("sonar_max_range", GoalDriver::kSonarRange);
  // Beside a laser the algorithm remembers each step's hits, also those of the sonar.
  eyes.sonar_kept =
      static_cast<std::size_t>(laser ? std::max(1, buffer - LaserBuffer(options) + 1) : buffer);
  if (const Json* const bad = options.Find("sonar_bad_transducers")) {
    if (!bad->IsArray()) throw Error("option 'sonar_bad_transducers' must be a tuple");
    for (const Json& each : bad->AsArray()) {
      if (!each.IsNumber() || !(each.AsDouble() >= 0.0) || each.AsDouble() > 1000.0) {
        throw Error("option 'sonar_bad_transducers' must be a tuple of numbers from 0 on");
      }
      eyes.bad_sonars.push_back(static_cast<std::size_t>(each.AsDouble()));
    }
  }
  return eyes;
}

}  // namespace

NdDriver::NdDriver(const DriverDef& def, const DeviceContext& /*context*/,
                   const DeviceList& devices)
    : GoalDriver(def, devices, EyesOf(def)), nd_(ReadOptions(def.options)) {}

navigation::NdOptions NdDriver::ReadOptions(const DriverOptions& options) {
  navigation::NdOptions nd;
  const auto length = [&](const char* name, double& to) { to = options.Length(name, to); };
  const auto pair = [&](const char* name, double& way, double& turn) {
    std::array<double, 2> numbers = {way, turn};
    options.Tuple(name, "la", numbers);
    way = numbers[0];
    turn = numbers[1];
  };
  nd.robot_radius = RobotRadius(options);
  pair("goal_tol", nd.goal_position_tol, nd.goal_angle_tol);
  pair("max_speed", nd.max_speed, nd.max_turn_rate);
  pair("min_speed", nd.min_speed, nd.min_turn_rate);
  length("avoid_dist", nd.avoid_dist);
  length("safety_dist", nd.safety_dist);
  nd.rotate_stuck_time = options.Number("rotate_stuck_time", nd.rotate_stuck_time);
  nd.translate_stuck_time = options.Number("translate_stuck_time", nd.translate_stuck_time);
  length("translate_stuck_dist", nd.translate_stuck_dist);
  nd.translate_stuck_angle = options.Angle("translate_stuck_angle", nd.translate_stuck_angle);
  nd.wait_on_stall = options.Flag("wait_on_stall", nd.wait_on_stall);
  // Without a laser the driver itself remembers what the sonar heard.
  nd.laser_buffer = has_laser() ? LaserBuffer(options) : 1;
  return nd;
}

}  // namespace ccmorse::servers::player
