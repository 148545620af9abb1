#include "servers/player/drivers/goal_driver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/polygon.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

Pose2 OnTheFloor(const wire::Pose3d& pose) { return {pose.px, pose.py, pose.pyaw}; }

}  // namespace

GoalDriver::GoalDriver(const DriverDef& def, const DeviceList& devices, Eyes eyes)
    : Driver(def, devices),
      eyes_(std::move(eyes)),
      input_(Require(wire::kPosition2d, "input")),
      output_(Require(wire::kPosition2d, "output")) {
  laser_ = RequireIfGiven(wire::kLaser);
  if (eyes_.sonar) sonar_ = RequireIfGiven(wire::kSonar);
  if (eyes_.ranger) ranger_ = RequireIfGiven(wire::kRanger);
  const int count = (laser_ != nullptr) + (sonar_ != nullptr) + (ranger_ != nullptr);
  if (count == 0 || (count > 1 && eyes_.exactly_one)) {
    throw Error("driver " + def.name + " requires " + (eyes_.exactly_one ? "exactly one " : "a ") +
                "laser" + (eyes_.sonar ? " or sonar" : "") + (eyes_.ranger ? " or ranger" : ""));
  }
  goals_ = Provide(wire::kPosition2d, {{MessageType::kData, wire::kPosition2dDataState},
                                       {MessageType::kCommand, wire::kPosition2dCmdPos},
                                       {MessageType::kCommand, wire::kPosition2dCmdVel},
                                       {MessageType::kRequest, wire::kPosition2dReqGetGeom},
                                       {MessageType::kRequest, wire::kPosition2dReqMotorPower},
                                       {MessageType::kRequest, wire::kPosition2dReqVelocityMode},
                                       {MessageType::kRequest, wire::kPosition2dReqPositionMode},
                                       {MessageType::kRequest, wire::kPosition2dReqSetOdom},
                                       {MessageType::kRequest, wire::kPosition2dReqResetOdom}});
  if (goals_ == nullptr) throw Error("driver " + def.name + " provides a position2d");
}

double GoalDriver::RobotRadius(const DriverOptions& options) {
  Reply reply;
  wire::Position2dGeom geometry;
  if (output_.Request(wire::kPosition2dReqGetGeom, {}, reply)) reply.body().To(geometry);
  return options.Length("robot_radius", 0.5 * std::hypot(geometry.size.sw, geometry.size.sl));
}

void GoalDriver::Started() {
  Reply reply;
  if (laser_ != nullptr) {
    wire::LaserGeom geometry;
    if (laser_->Request(wire::kLaserReqGetGeom, {}, reply) && reply.body().To(geometry)) {
      mount_ = OnTheFloor(geometry.pose);
    }
  }
  if (sonar_ != nullptr) {
    wire::SonarGeom geometry;
    if (sonar_->Request(wire::kSonarReqGetGeom, {}, reply) && reply.body().To(geometry)) {
      ring_.clear();
      for (const wire::Pose3d& pose : geometry.poses) ring_.push_back(OnTheFloor(pose));
    }
  }
  if (ranger_ != nullptr) {
    wire::RangerGeom geometry;
    if (ranger_->Request(wire::kRangerReqGetGeom, {}, reply) && reply.body().To(geometry)) {
      mount_ = OnTheFloor(geometry.pose);
      ring_.clear();
      if (geometry.element_poses.size() > 1) {
        for (const auto& pose : geometry.element_poses) ring_.push_back(OnTheFloor(pose));
      }
    }
    if (ranger_->Request(wire::kRangerReqGetConfig, {}, reply)) reply.body().To(ranger_config_);
  }
}

void GoalDriver::Stopped() {
  ClearGoal();
  Drive(0.0, 0.0);
  state_.reset();
  heard_.clear();
}

void GoalDriver::Data(const DataMessage& message) {
  if (&message.device() == &input_) {
    wire::Position2dData data;
    if (message.subtype() != wire::kPosition2dDataState || !message.body().To(data)) return;
    state_ = {{data.pos.px, data.pos.py, data.pos.pa},
              data.vel.px,
              data.vel.pa,
              data.stall != 0,
              message.time()};
    goals_->Publish(wire::kPosition2dDataState, message.time(), wire::Body::Of(data));
    return;
  }
  if (!state_ || !Look(message) || !HasGoal()) return;
  state_->time = std::max(state_->time, message.time());
  const navigation::Drive drive = Decide(*state_);
  Drive(drive.speed, drive.turn_rate);
  if (drive.at_goal) ClearGoal();
}

// Takes what it sees; true when it is time to decide: with a sonar beside a laser, the laser's.
bool GoalDriver::Look(const DataMessage& message) {
  const Device* const from = &message.device();
  if (from == laser_ && laser_ != nullptr) {
    return message.subtype() == wire::kLaserDataScan && message.body().To(scan_);
  }
  if (from == sonar_ && sonar_ != nullptr) {
    wire::SonarData data;
    if (message.subtype() != wire::kSonarDataRanges || !message.body().To(data)) return false;
    LookAround(data.ranges, eyes_.sonar_range);
    return laser_ == nullptr;
  }
  wire::RangerDataRange data;
  if (from != ranger_ || message.subtype() != wire::kRangerDataRange || !message.body().To(data)) {
    return false;
  }
  if (!ring_.empty()) {
    LookAround(data.ranges, ranger_config_.max_range);
    return true;
  }
  scan_.min_angle = ranger_config_.min_angle;
  scan_.resolution = ranger_config_.angular_res;
  scan_.max_range = ranger_config_.max_range;
  scan_.ranges = std::move(data.ranges);
  return scan_.resolution > 0.0;
}

void GoalDriver::LookAround(std::span<const double> ranges, double range_max) {
  std::vector<Vec2>& hits = heard_.emplace_back();
  for (std::size_t i = 0; i < std::min(ranges.size(), ring_.size()); ++i) {
    const double range = navigation::CleanRange(ranges[i], range_max);
    const auto& bad = eyes_.bad_sonars;
    if (range < range_max && std::find(bad.begin(), bad.end(), i) == bad.end()) {
      hits.push_back(Transform(state_->pose, Transform(ring_[i], {range, 0.0})));
    }
  }
  if (heard_.size() > eyes_.sonar_kept) heard_.erase(heard_.begin());
}

navigation::ScanView GoalDriver::Scan() const {
  return {scan_.min_angle, scan_.resolution, scan_.max_range, scan_.ranges, mount_};
}

std::vector<Vec2> GoalDriver::Hits() const {
  std::vector<Vec2> hits = navigation::HitPoints(Scan());
  for (const std::vector<Vec2>& reading : heard_) {
    for (const Vec2& hit : reading) hits.push_back(InverseTransform(state_->pose, hit));
  }
  return hits;
}

bool GoalDriver::Ask(Provided& /*device*/, std::uint8_t subtype, const wire::Body& body,
                     Reply& reply) {
  return output_.Request(subtype, body, reply);
}

void GoalDriver::Tell(Provided& /*device*/, std::uint8_t subtype, const wire::Body& body) {
  if (subtype == wire::kPosition2dCmdPos) {
    wire::Position2dCmdPos goal;
    if (body.To(goal) && std::isfinite(goal.pos.px) && std::isfinite(goal.pos.py) &&
        std::isfinite(goal.pos.pa)) {
      SetGoal({goal.pos.px, goal.pos.py, goal.pos.pa});
    }
    return;
  }
  ClearGoal();  // somebody drives by hand
  output_.Command(subtype, body);
}

void GoalDriver::Drive(double speed, double turn_rate) {
  wire::Position2dCmdVel command;
  command.vel = {speed, 0.0, turn_rate};
  command.state = 1;
  output_.Command(wire::kPosition2dCmdVel, wire::Body::Of(command));
}

}  // namespace ccmorse::servers::player
