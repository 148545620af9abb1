#pragma once

#include <string>
#include <vector>

#include "base/pose.h"
#include "scene/scenario.h"

namespace ccmorse::scene {

/// A type of robot: what all robots of the type share (specs: syrotek.md A for the S1R).
struct RobotModel {
  std::string type;
  std::vector<HullPart> hull;     ///< what scanners of others see
  std::vector<Vec2> footprint;    ///< m, convex, counter-clockwise: what touches walls and robots
  double origin_height = 0.0;     ///< m above the floor: where the robot's frame lies
  double length = 0.0;            ///< m, bounding box
  double width = 0.0;             ///< m
  double height = 0.0;            ///< m
  double ground_clearance = 0.0;  ///< m between floor and body
  double mass = 0.0;              ///< kg, all of it
  double wheel_radius = 0.0;      ///< m
  double wheel_width = 0.0;       ///< m
  double wheel_mass = 0.0;        ///< kg, one wheel
  double wheel_track = 0.0;       ///< m between the wheels' middles
  double max_speed = 0.0;         ///< m/s; commands are clamped to it
  double max_side_speed = 0.0;    ///< m/s; only omnidirectional robots have any
  double max_turn_rate = 0.0;     ///< rad/s; commands are clamped to it
  LaserDef laser;                 ///< the scanner as delivered
  ProxyTable proxies;             ///< Player indexes where the scenario gives none
  RingDef ir;                     ///< infra-red sensors as delivered
  RingDef sonar;                  ///< sonars as delivered
  double ring_height = 0.0;       ///< m above the floor: where their cones begin
  std::vector<Pose2> ir_mounts;   ///< on the robot, m and rad, front pair first, then left to rear
  std::vector<Pose2> sonar_mounts;   ///< likewise
  std::vector<Pose2> module_mounts;  ///< of either, on the front sensor module, from left to right
};

/// The model of a type. Throws Error that names the known types.
const RobotModel& FindRobotModel(const std::string& type);

/// The model of this very robot: its type's, or what its body says where the type is "Custom".
RobotModel ModelOf(const RobotDef& robot);

/// Names of all types, sorted; "Custom" is none of them, as it has no model of its own.
std::vector<std::string> RobotTypes();

}  // namespace ccmorse::scene
