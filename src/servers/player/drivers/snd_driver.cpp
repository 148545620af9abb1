#include "servers/player/drivers/snd_driver.h"

#include <utility>

#include "base/trig.h"

namespace ccmorse::servers::player {
namespace {

navigation::SndOptions ReadOptions(const DriverOptions& options) {
  navigation::SndOptions snd;
  snd.robot_radius = options.Length("robot_radius", snd.robot_radius);
  const auto length = [&](const char* name, std::optional<double>& to) {
    if (options.Find(name) != nullptr) to = options.Length(name, 0.0);
  };
  length("min_gap_width", snd.min_gap_width);
  length("obstacle_avoid_dist", snd.obstacle_avoid_dist);
  length("goal_position_tol", snd.goal_position_tol);
  snd.max_speed = options.Length("max_speed", snd.max_speed);
  snd.max_turn_rate = options.Angle("max_turn_rate", snd.max_turn_rate);
  snd.goal_angle_tol = options.Angle("goal_angle_tol", snd.goal_angle_tol);
  snd.min_range = options.Length("min_range", snd.min_range);
  return snd;
}

}  // namespace

SndDriver::SndDriver(const DriverDef& def, const DeviceContext& /*context*/,
                     const DeviceList& devices)
    : GoalDriver(def, devices, {}), snd_(ReadOptions(def.options)) {}

navigation::Drive SndDriver::Decide(const navigation::RobotState& state) {
  const navigation::Scan centred = navigation::CentreScan(Scan());
  return snd_.Step(state.pose, centred.View());
}

DriverDef SyrotekSnd(const Json::Object& settings) {
  const navigation::SndOptions usual = navigation::Snd::Resolved(navigation::SndOptionsForS1r());
  Json options(Json::Object{{"robot_radius", usual.robot_radius},
                            {"min_gap_width", *usual.min_gap_width},
                            {"obstacle_avoid_dist", *usual.obstacle_avoid_dist},
                            {"max_speed", usual.max_speed},
                            {"max_turn_rate", usual.max_turn_rate / Radians(1.0)},
                            {"goal_position_tol", *usual.goal_position_tol},
                            {"goal_angle_tol", usual.goal_angle_tol / Radians(1.0)},
                            {"min_range", usual.min_range}});
  for (const auto& [name, value] : settings) options.Set(name, value);
  DriverDef def;
  def.name = "snd";
  def.provided = {{"", "position2d", 1}};
  def.required = {{"input", "position2d", 2}, {"output", "position2d", 0}, {"", "laser", 0}};
  def.options = {options.AsObject(), 1.0, Radians(1.0)};
  def.may_fail = true;
  return def;
}

}  // namespace ccmorse::servers::player
