#include "servers/player/drivers/vfh_driver.h"

namespace ccmorse::servers::player {

VfhDriver::VfhDriver(const DriverDef& def, const DeviceContext& /*context*/,
                     const DeviceList& devices)
    : GoalDriver(def, devices,
                 {.sonar = true,
                  .ranger = true,
                  .exactly_one = true,
                  .sonar_range = def.options.Length("sonar_max_range", kSonarRange)}),
      vfh_(ReadOptions(def.options)) {}

navigation::VfhOptions VfhDriver::ReadOptions(const DriverOptions& options) {
  navigation::VfhOptions vfh;
  const auto length = [&](const char* name, double& to) { to = options.Length(name, to); };
  const auto angle = [&](const char* name, double& to) { to = options.Angle(name, to); };
  const auto number = [&](const char* name, double& to) { to = options.Number(name, to); };
  // Those whose default is another option.
  const auto length_if = [&](const char* name, std::optional<double>& to) {
    if (options.Find(name) != nullptr) to = options.Length(name, 0.0);
  };
  const auto number_if = [&](const char* name, std::optional<double>& to) {
    if (options.Find(name) != nullptr) to = options.Number(name, 0.0);
  };
  vfh.robot_radius = RobotRadius(options);
  length("cell_size", vfh.cell_size);
  vfh.window_diameter = options.Integer("window_diameter", vfh.window_diameter);
  angle("sector_angle", vfh.sector_angle);
  length("safety_dist_0ms", vfh.safety_dist_0ms);
  length_if("safety_dist_1ms", vfh.safety_dist_1ms);
  length("max_speed", vfh.max_speed);
  length_if("max_speed_narrow_opening", vfh.max_speed_narrow_opening);
  length_if("max_speed_wide_opening", vfh.max_speed_wide_opening);
  length("max_acceleration", vfh.max_acceleration);
  angle("min_turnrate", vfh.min_turnrate);
  angle("max_turnrate_0ms", vfh.max_turnrate_0ms);
  if (options.Find("max_turnrate_1ms") != nullptr) {
    vfh.max_turnrate_1ms = options.Angle("max_turnrate_1ms", 0.0);
  }
  number("min_turn_radius_safety_factor", vfh.min_turn_radius_safety_factor);
  number("free_space_cutoff_0ms", vfh.free_space_cutoff_0ms);
  number_if("free_space_cutoff_1ms", vfh.free_space_cutoff_1ms);
  number_if("obs_cutoff_0ms", vfh.obs_cutoff_0ms);
  number_if("obs_cutoff_1ms", vfh.obs_cutoff_1ms);
  number("weight_desired_dir", vfh.weight_desired_dir);
  number("weight_current_dir", vfh.weight_current_dir);
  length("distance_epsilon", vfh.distance_epsilon);
  angle("angle_epsilon", vfh.angle_epsilon);
  length("escape_speed", vfh.escape_speed);
  number("escape_time", vfh.escape_time);
  angle("escape_max_turnrate", vfh.escape_max_turnrate);
  return vfh;
}

}  // namespace ccmorse::servers::player
