#include "servers/player/devices/position2d.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/polygon.h"
#include "base/trig.h"
#include "servers/player/pose2d.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

// Stage's position control (specs: player.md C.3).
constexpr double kGoalSpeed = 0.4;           // m/s, at most
constexpr double kGoalTurn = 1.0;            // rad/s, at most
constexpr double kGoalBearing = kPi / 16.0;  // rad, off it the robot turns on the spot
constexpr double kGoalDistance = 0.02;       // m
constexpr double kGoalAngle = kPi / 180.0;   // rad
constexpr double kTurnGain = 4.0;            // 1/s, for the last bit of a turn

double TurnTowards(double angle, double most) { return std::clamp(kTurnGain * angle, -most, most); }

}  // namespace

Position2d::Position2d(DeviceContext context, const sim::Robot& robot, std::uint16_t index,
                       const sim::Sensor& sensor, bool drives, double frequency)
    : Device(wire::kPosition2d, index, "ccmorse",
             {{MessageType::kData, wire::kPosition2dDataState},
              {MessageType::kCommand, wire::kPosition2dCmdVel},
              {MessageType::kCommand, wire::kPosition2dCmdPos},
              {MessageType::kCommand, wire::kPosition2dCmdCar},
              {MessageType::kCommand, wire::kPosition2dCmdVelHead},
              {MessageType::kRequest, wire::kPosition2dReqGetGeom},
              {MessageType::kRequest, wire::kPosition2dReqMotorPower},
              {MessageType::kRequest, wire::kPosition2dReqVelocityMode},
              {MessageType::kRequest, wire::kPosition2dReqPositionMode},
              {MessageType::kRequest, wire::kPosition2dReqSetOdom},
              {MessageType::kRequest, wire::kPosition2dReqResetOdom}}),
      context_(context),
      robot_(robot),
      sensor_(sensor),
      drives_(drives),
      rate_(frequency) {
  if (sensor.number_form() != sim::NumberForm::kPose) return;
  // A pose in the world is told in the coordinates that the world's file had.
  const Vec2 origin = context.simulation.world().scene().origin;
  frame_ = {-origin.x, -origin.y, 0.0};
}

void Position2d::Read() {
  numbers_.clear();
  sensor_.AppendNumbers(numbers_);
  const Vec2 at = Transform(frame_, {numbers_[0], numbers_[1]});
  pose_ = {at.x, at.y, NormalizeAngle(numbers_[5] + frame_.yaw)};
}

void Position2d::Step() {
  if (goal_) {
    Read();
    DriveToGoal();
  } else if (heading_) {
    Read();
    DriveByHeading();
  }
  if (!rate_.TakeDue(context_.simulation) || sensor_.samples() == 0) return;
  Read();
  const sim::Twist& twist = robot_.twist();
  wire::Position2dData data;
  data.pos = {pose_.x, pose_.y, pose_.yaw};
  data.vel = {twist.v, 0.0, twist.w};
  // An odometry counts speeds with the errors that it counts ways with.
  if (sensor_.number_form() == sim::NumberForm::kOdometry) {
    data.vel = {numbers_[6], 0.0, numbers_[11]};
  }
  data.stall = robot_.stalled() ? 1 : 0;
  Publish(wire::kPosition2dDataState, sensor_.timestamp(), wire::Body::Of(data));
}

void Position2d::Drive(double v, double w) {
  commanded_ = true;
  if (!power_) return;
  speed_ = {v, w};
  const std::array<Json, 2> arguments = {Json(v), Json(w)};
  context_.Run(robot_.name() + ".motion", "set_speed", arguments);
}

void Position2d::Stop() {
  goal_.reset();
  heading_.reset();
  if (!commanded_) return;
  speed_ = {};
  const std::array<Json, 2> arguments = {Json(0.0), Json(0.0)};
  context_.Run(robot_.name() + ".motion", "set_speed", arguments);
}

void Position2d::LastLeft() {
  Stop();
  commanded_ = false;
}

void Position2d::Tell(std::uint8_t subtype, const wire::Body& body) {
  if (!drives_) return;
  switch (subtype) {
    case wire::kPosition2dCmdVel: {
      wire::Position2dCmdVel command;
      if (!body.To(command) || !IsFinite(command.vel)) return;
      goal_.reset();
      heading_.reset();
      return Drive(command.vel.px, command.vel.pa);
    }
    case wire::kPosition2dCmdCar: {
      wire::Position2dCmdCar command;
      if (!body.To(command)) return;
      if (!std::isfinite(command.velocity) || !std::isfinite(command.angle)) return;
      goal_.reset();
      heading_.reset();
      const auto [s, c] = SinCos(command.angle);
      return Drive(command.velocity * c, command.velocity * s / robot_.model().wheel_track);
    }
    case wire::kPosition2dCmdVelHead: {
      wire::Position2dCmdVelHead command;
      if (!body.To(command)) return;
      if (!std::isfinite(command.velocity) || !std::isfinite(command.angle)) return;
      goal_.reset();
      heading_ = NormalizeAngle(command.angle);
      heading_speed_ = command.velocity;
      Read();
      return DriveByHeading();
    }
    case wire::kPosition2dCmdPos: {
      wire::Position2dCmdPos command;
      if (!body.To(command) || !IsFinite(command.pos) || !IsFinite(command.vel)) return;
      heading_.reset();
      goal_ = Pose2{command.pos.px, command.pos.py, NormalizeAngle(command.pos.pa)};
      goal_speed_ = {std::fabs(command.vel.px), std::fabs(command.vel.pa)};
      near_goal_ = false;
      Read();
      return DriveToGoal();
    }
    default:
      return;
  }
}

void Position2d::DriveByHeading() {
  const double turn = TurnTowards(NormalizeAngle(*heading_ - pose_.yaw), kGoalTurn);
  if (heading_speed_ != speed_.v || turn != speed_.w) Drive(heading_speed_, turn);
}

void Position2d::DriveToGoal() {
  const double most_speed = goal_speed_.v > 0.0 ? goal_speed_.v : kGoalSpeed;
  const double most_turn = goal_speed_.w > 0.0 ? goal_speed_.w : kGoalTurn;
  const Vec2 way{goal_->x - pose_.x, goal_->y - pose_.y};
  const double distance = std::sqrt(Dot(way, way));
  double v = 0.0;
  double w = 0.0;
  near_goal_ = distance < (near_goal_ ? 2.0 * kGoalDistance : kGoalDistance);
  if (near_goal_) {
    const double off = NormalizeAngle(goal_->yaw - pose_.yaw);
    if (std::fabs(off) > kGoalAngle) w = TurnTowards(off, most_turn);
  } else {
    const double off = NormalizeAngle(Atan2(way.y, way.x) - pose_.yaw);
    w = TurnTowards(off, most_turn);
    // It comes to rest in the middle of what counts as there.
    if (std::fabs(off) < kGoalBearing) v = std::min(most_speed, 2.0 * distance);
  }
  if (v != speed_.v || w != speed_.w) Drive(v, w);
}

bool Position2d::Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) {
  switch (subtype) {
    case wire::kPosition2dReqGetGeom: {
      if (!body.empty()) return false;
      const scene::RobotModel& model = robot_.model();
      wire::Position2dGeom geometry;
      geometry.size = {model.width, model.length, model.height};
      reply.Set(geometry);
      return true;
    }
    case wire::kPosition2dReqMotorPower: {
      wire::Position2dPowerConfig wanted;
      if (!body.To(wanted)) return false;
      if (wanted.state == 0) Stop();
      power_ = wanted.state != 0;
      return true;
    }
    case wire::kPosition2dReqVelocityMode: {
      wire::Position2dVelocityModeConfig wanted;
      return body.To(wanted);
    }
    case wire::kPosition2dReqPositionMode: {
      wire::Position2dPositionModeReq wanted;
      return body.To(wanted);
    }
    case wire::kPosition2dReqResetOdom:
    case wire::kPosition2dReqSetOdom: {
      wire::Position2dSetOdomReq wanted;
      if (subtype == wire::kPosition2dReqSetOdom && (!body.To(wanted) || !IsFinite(wanted.pose))) {
        return false;
      }
      numbers_.clear();
      sensor_.AppendNumbers(numbers_);
      frame_ = {};
      frame_.yaw = NormalizeAngle(wanted.pose.pa - numbers_[5]);
      const Vec2 turned = Transform(frame_, {numbers_[0], numbers_[1]});
      frame_.x = wanted.pose.px - turned.x;
      frame_.y = wanted.pose.py - turned.y;
      return true;
    }
    default:
      return false;
  }
}

}  // namespace ccmorse::servers::player
