#include "servers/player/drivers/snd_driver.h"

#include <utility>

#include "base/error.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

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
    : Driver(def, devices),
      input_(Require(wire::kPosition2d, "input")),
      output_(Require(wire::kPosition2d, "output")),
      laser_(Require(wire::kLaser)),
      snd_(ReadOptions(def.options)) {
  goals_ = Provide(wire::kPosition2d, {{MessageType::kData, wire::kPosition2dDataState},
                                       {MessageType::kCommand, wire::kPosition2dCmdPos},
                                       {MessageType::kCommand, wire::kPosition2dCmdVel},
                                       {MessageType::kRequest, wire::kPosition2dReqGetGeom},
                                       {MessageType::kRequest, wire::kPosition2dReqMotorPower},
                                       {MessageType::kRequest, wire::kPosition2dReqVelocityMode},
                                       {MessageType::kRequest, wire::kPosition2dReqPositionMode},
                                       {MessageType::kRequest, wire::kPosition2dReqSetOdom},
                                       {MessageType::kRequest, wire::kPosition2dReqResetOdom}});
  if (goals_ == nullptr) throw Error("driver snd provides a position2d");
}

void SndDriver::Started() {
  Reply reply;
  wire::LaserGeom geometry;
  if (laser_.Request(wire::kLaserReqGetGeom, {}, reply) && reply.body().To(geometry)) {
    mount_ = {geometry.pose.px, geometry.pose.py, geometry.pose.pyaw};
  }
}

void SndDriver::Stopped() {
  snd_.ClearGoal();
  Drive(0.0, 0.0);
  has_pose_ = false;
}

void SndDriver::Data(const DataMessage& message) {
  if (&message.device() == &input_) {
    wire::Position2dData data;
    if (message.subtype() != wire::kPosition2dDataState || !message.body().To(data)) return;
    pose_ = {data.pos.px, data.pos.py, data.pos.pa};
    has_pose_ = true;
    goals_->Publish(wire::kPosition2dDataState, message.time(), wire::Body::Of(data));
    return;
  }
  wire::LaserData scan;
  if (&message.device() != &laser_ || message.subtype() != wire::kLaserDataScan ||
      !message.body().To(scan) || !snd_.goal() || !has_pose_) {
    return;
  }
  const navigation::ScanView seen{scan.min_angle, scan.resolution, scan.max_range, scan.ranges,
                                  mount_};
  const navigation::Scan centred = navigation::CentreScan(seen);
  const navigation::Drive drive = snd_.Step(pose_, centred.View());
  Drive(drive.speed, drive.turn_rate);
  if (drive.at_goal) snd_.ClearGoal();
}

bool SndDriver::Ask(Provided& /*device*/, std::uint8_t subtype, const wire::Body& body,
                    Reply& reply) {
  return output_.Request(subtype, body, reply);
}

void SndDriver::Tell(Provided& /*device*/, std::uint8_t subtype, const wire::Body& body) {
  wire::Position2dCmdPos goal;
  if (subtype == wire::kPosition2dCmdPos && body.To(goal)) {
    snd_.SetGoal({goal.pos.px, goal.pos.py, goal.pos.pa});
    return;
  }
  snd_.ClearGoal();  // somebody drives by hand
  output_.Command(subtype, body);
}

void SndDriver::Drive(double speed, double turn_rate) {
  wire::Position2dCmdVel command;
  command.vel = {speed, 0.0, turn_rate};
  command.state = 1;
  output_.Command(wire::kPosition2dCmdVel, wire::Body::Of(command));
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
