#include "sim/sensors/robot_properties.h"

#include "sim/robots/robot.h"

namespace ccmorse::sim {
namespace {

Json ProxiesToJson(const scene::ProxyTable& proxies) {
  Json result(Json::Object{});
  for (const auto& [interface, indexes] : proxies) {
    Json table(Json::Object{});
    for (const auto& [index, device] : indexes) table.Set(std::to_string(index), device);
    result.Set(interface, std::move(table));
  }
  return result;
}

}  // namespace

RobotProperties::RobotProperties(Robot& robot, const std::string& name,
                                 const scene::Scenario& scenario)
    : Sensor(robot, name, "RobotProperties", 1.0) {
  const scene::RobotDef& def = robot.def();
  const scene::RobotModel& model = robot.model();
  Json drivers(Json::Object{});
  for (const auto& [driver, settings] : def.drivers) drivers.Set(driver, settings);
  properties_ =
      Json(Json::Object{
               {"name", def.name},
               {"type", def.type},
               {"size", Json::Array{model.length, model.width, model.height}},
               {"mass", model.mass},
               {"wheel_radius", model.wheel_radius},
               {"wheel_track", model.wheel_track},
               {"max_speed", model.max_speed},
               {"max_turn_rate", model.max_turn_rate},
               {"color", Json::Array{int{def.color.r}, int{def.color.g}, int{def.color.b}}},
               {"pose", Json::Object{{"x", def.pose.x}, {"y", def.pose.y}, {"yaw", def.pose.yaw}}},
               {"laser_position",
                Json::Array{def.laser.position.x, def.laser.position.y, def.laser.position.z}},
               {"proxies", ProxiesToJson(def.proxies)},
               {"drivers", std::move(drivers)},
               {"canvas", Json::Object{{"width", scenario.canvas.width},
                                       {"height", scenario.canvas.height},
                                       {"alpha", scenario.canvas.alpha},
                                       {"mode", scenario.canvas.mode},
                                       {"mode_switching", scenario.canvas.mode_switching}}},
               {"scenario", scenario.name}})
          .Dump();
}

void RobotProperties::Sample(const Instant& now) { DataChanged(now.time); }

void RobotProperties::AppendFields(std::string& out) const {
  out += ", \"properties\": ";
  out += properties_;
}

}  // namespace ccmorse::sim
