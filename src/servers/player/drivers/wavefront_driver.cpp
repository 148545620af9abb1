#include "servers/player/drivers/wavefront_driver.h"

#include <cmath>

#include "base/error.h"
#include "base/log.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "servers/player/drivers/map_reader.h"
#include "servers/player/pose2d.h"

namespace ccmorse::servers::player {
namespace {

using navigation::Wavefront;
using navigation::WavefrontOptions;
using wire::MessageType;

// A waypoint is sent again when it has moved by more in the output's frame, as it does where the
// input is put right against the output's dead reckoning.
constexpr double kMoved = 0.02;           // m
constexpr double kTurned = Radians(3.0);  // rad

WavefrontOptions ReadWavefront(const DriverOptions& options) {
  WavefrontOptions wavefront;
  const auto length = [&](const char* name, double& to) { to = options.Length(name, to); };
  length("safety_dist", wavefront.safety_dist);
  length("max_radius", wavefront.max_radius);
  wavefront.dist_penalty = options.Number("dist_penalty", wavefront.dist_penalty);
  length("distance_epsilon", wavefront.distance_epsilon);
  wavefront.angle_epsilon = options.Angle("angle_epsilon", wavefront.angle_epsilon);
  length("replan_dist_thresh", wavefront.replan_dist_thresh);
  wavefront.replan_min_time = options.Number("replan_min_time", wavefront.replan_min_time);
  wavefront.add_rotational_waypoints =
      options.Flag("add_rotational_waypoints", wavefront.add_rotational_waypoints);
  // Complains now of what it cannot work with, not when the map is there.
  const Wavefront check(navigation::OccupancyGrid(1, 1, 1.0), wavefront);
  return wavefront;
}

double ReadRate(const DriverOptions& options) {
  const double rate = options.Number("update_rate", 10.0);
  if (!(rate > 0.0) || !std::isfinite(rate)) {
    throw Error("wavefront: update_rate must be more than 0");
  }
  return rate;
}

}  // namespace

WavefrontDriver::WavefrontDriver(const DriverDef& def, const DeviceContext& context,
                                 const DeviceList& devices)
    : Driver(def, devices),
      context_(context),
      options_(ReadWavefront(def.options)),
      refresh_map_(def.options.Flag("force_map_refresh", false)),
      rate_(ReadRate(def.options)),
      output_(Require(wire::kPosition2d, "output")),
      map_(Require(wire::kMap)) {
  input_ = RequireIfGiven(wire::kLocalize);
  if (input_ == nullptr) input_ = &Require(wire::kPosition2d, "input");
  planner_ = Provide(wire::kPlanner, {{MessageType::kData, wire::kPlannerDataState},
                                      {MessageType::kCommand, wire::kPlannerCmdGoal},
                                      {MessageType::kRequest, wire::kPlannerReqGetWaypoints},
                                      {MessageType::kRequest, wire::kPlannerReqEnable}});
  if (planner_ == nullptr) throw Error("driver wavefront provides a planner");
}

void WavefrontDriver::LoadMap() {
  wavefront_.reset();
  auto map = ReadMap(map_);
  if (map) {
    wavefront_.emplace(std::move(*map), options_);
  } else {
    LogWarning("driver wavefront: map:{} gives no map that it could plan on", map_.index());
  }
}

void WavefrontDriver::Started() {
  enabled_ = true;
  LoadMap();
}

void WavefrontDriver::Stopped() {
  Drive({});
  wavefront_.reset();
  pose_.reset();
  output_pose_.reset();
}

void WavefrontDriver::Data(const DataMessage& message) {
  wire::Position2dData position;
  wire::LocalizeData hypotheses;
  if (message.device().interface_code() == wire::kPosition2d) {
    if (message.subtype() != wire::kPosition2dDataState || !message.body().To(position)) return;
    if (&message.device() == input_) pose_ = ToPose(position.pos);
    if (&message.device() == &output_) output_pose_ = ToPose(position.pos);
  } else if (&message.device() == input_ && message.subtype() == wire::kLocalizeDataHypoths &&
             message.body().To(hypotheses) && !hypotheses.hypoths.empty()) {
    pose_ = ToPose(hypotheses.hypoths.front().mean);  // the likeliest comes first
  }
}

void WavefrontDriver::Step() {
  if (!rate_.TakeDue(context_.simulation) || !pose_) return;
  const double now = context_.simulation.time();
  const navigation::WavefrontStatus status =
      wavefront_ ? wavefront_->Step(*pose_, now) : navigation::WavefrontStatus();
  Drive(enabled_ ? status : navigation::WavefrontStatus());
  wire::PlannerData data;
  data.valid = status.valid ? 1 : 0;
  data.done = status.done ? 1 : 0;
  data.pos = ToWire(*pose_);
  data.waypoint_idx = status.current;
  if (status.waypoint) data.waypoint = ToWire(*status.waypoint);
  if (wavefront_) {
    if (wavefront_->goal()) data.goal = ToWire(*wavefront_->goal());
    data.waypoints_count = static_cast<std::uint32_t>(wavefront_->waypoints().size());
  }
  planner_->Publish(wire::kPlannerDataState, now, wire::Body::Of(data));
}

// Has the output go to the waypoint, or stand where there is none.
void WavefrontDriver::Drive(const navigation::WavefrontStatus& status) {
  if (!status.waypoint) {
    if (sent_) output_.Command(wire::kPosition2dCmdVel, wire::Body::Of(wire::Position2dCmdVel()));
    sent_.reset();
    return;
  }
  if (!output_pose_) return;
  // From the map to the robot, and from there to the output's frame.
  const Vec2 ahead = InverseTransform(*pose_, {status.waypoint->x, status.waypoint->y});
  const Vec2 there = Transform(*output_pose_, ahead);
  const Pose2 goal{there.x, there.y,
                   NormalizeAngle(output_pose_->yaw + status.waypoint->yaw - pose_->yaw)};
  if (sent_ && std::hypot(goal.x - sent_->x, goal.y - sent_->y) <= kMoved &&
      std::fabs(NormalizeAngle(goal.yaw - sent_->yaw)) <= kTurned) {
    return;
  }
  sent_ = goal;
  wire::Position2dCmdPos command;
  command.pos = ToWire(goal);
  command.state = 1;
  output_.Command(wire::kPosition2dCmdPos, wire::Body::Of(command));
}

double WavefrontDriver::PathLength() const {
  double length = 0.0;
  if (wavefront_->path().empty()) return length;
  Vec2 last = wavefront_->map().CentreOf(wavefront_->path().front());
  for (const Pose2& waypoint : wavefront_->waypoints()) {
    length += std::hypot(waypoint.x - last.x, waypoint.y - last.y);
    last = {waypoint.x, waypoint.y};
  }
  return length;
}

bool WavefrontDriver::Ask(Provided& /*device*/, std::uint8_t subtype, const wire::Body& body,
                          Reply& reply) {
  if (subtype == wire::kPlannerReqEnable) {
    wire::PlannerEnableReq wanted;
    if (!body.To(wanted)) return false;
    enabled_ = wanted.state != 0;
    if (!enabled_) Drive({});
    return true;
  }
  wire::PlannerWaypointsReq path;
  if (wavefront_) {
    path.waypoints_distance = PathLength();
    for (const Pose2& each : wavefront_->waypoints()) path.waypoints.push_back(ToWire(each));
  }
  reply.Set(std::move(path));
  return body.empty();
}

void WavefrontDriver::Tell(Provided& /*device*/, std::uint8_t /*subtype*/, const wire::Body& body) {
  wire::PlannerCmd command;
  if (!body.To(command) || !std::isfinite(command.goal.px) || !std::isfinite(command.goal.py) ||
      !std::isfinite(command.goal.pa)) {
    return;
  }
  if (refresh_map_) LoadMap();
  if (!wavefront_) return;
  wavefront_->SetGoal(ToPose(command.goal));
  sent_.reset();  // also where it stands there already: the output may have been driven by others
}

DriverDef SyrotekPlanner() {
  const WavefrontOptions usual = navigation::WavefrontOptionsForS1r();
  DriverDef def;
  def.name = "wavefront";
  def.provided = {{"", "planner", 0}};
  def.required = {{"input", "position2d", 2}, {"output", "position2d", 1}, {"", "map", 0}};
  def.options.values = {{"safety_dist", usual.safety_dist},
                        {"max_radius", usual.max_radius},
                        {"dist_penalty", usual.dist_penalty},
                        {"distance_epsilon", usual.distance_epsilon},
                        {"angle_epsilon", usual.angle_epsilon},
                        {"replan_dist_thresh", usual.replan_dist_thresh},
                        {"add_rotational_waypoints", usual.add_rotational_waypoints},
                        {"force_map_refresh", true}};
  def.may_fail = true;
  return def;
}

}  // namespace ccmorse::servers::player
