#include "sim/robots/robot.h"

#include <algorithm>

#include "base/error.h"
#include "sim/actuators/motion_vw.h"
#include "sim/actuators/pen.h"
#include "sim/actuators/waypoint.h"
#include "sim/canvas.h"
#include "sim/robots/s1r.h"
#include "sim/sensors/laser_scanner.h"
#include "sim/sensors/odometry.h"
#include "sim/sensors/pose.h"
#include "sim/sensors/robot_properties.h"

namespace ccmorse::sim {

Robot::Robot(const scene::RobotDef& def, int index)
    : def_(def),
      model_(scene::ModelOf(def)),
      footprint_(Footprint::Make(model_.footprint)),
      index_(index) {
  outline_.outline.reserve(footprint_.outline.size());
  Place(def_.pose);
  hash_.Add(name());
}

void Robot::Register(std::unique_ptr<Sensor> sensor) {
  sensors_.push_back(sensor.get());
  components_.push_back(std::move(sensor));
}

void Robot::Register(std::unique_ptr<Actuator> actuator) {
  actuators_.push_back(actuator.get());
  components_.push_back(std::move(actuator));
}

void Robot::Command(const Twist& twist, const Actuator* by) {
  command_ = {std::clamp(twist.v, -model_.max_speed, model_.max_speed),
              std::clamp(twist.w, -model_.max_turn_rate, model_.max_turn_rate),
              std::clamp(twist.side, -model_.max_side_speed, model_.max_side_speed)};
  driver_ = by;
}

void Robot::Move(const Instant& now, std::span<const Obstacle* const> obstacles) {
  const bool touched_before = stalled_;
  twist_ = command_;
  stalled_ = false;
  if (command_.v != 0.0 || command_.w != 0.0 || command_.side != 0.0) {
    const MotionResult moved = DriveUntilContact(footprint_, pose_, command_.v, command_.w,
                                                 now.step, obstacles, command_.side);
    pose_ = moved.pose;
    tally_.distance += moved.driven;
    stalled_ = moved.blocked;
    outline_old_ = true;
  }
  if (stalled_) {
    twist_ = {};
    tally_.stalled += now.step;
    if (!touched_before) ++tally_.contacts;
  }
  hash_.Add(pose_.x);
  hash_.Add(pose_.y);
  hash_.Add(pose_.yaw);
  hash_.Add(twist_.v);
  hash_.Add(twist_.w);
}

void Robot::Place(const Pose2& pose) {
  pose_ = pose;
  twist_ = {};
  command_ = {};
  stalled_ = false;
  outline_old_ = true;
}

const Obstacle& Robot::outline() const {
  if (outline_old_) {
    outline_.MoveTo(footprint_, pose_);
    outline_old_ = false;
  }
  return outline_;
}

void Robot::Reset() {
  Place(def_.pose);
  driver_ = nullptr;
  tally_ = {};
  for (const auto& component : components_) component->Reset();
}

namespace {

Component& AddComponent(Robot& robot, const scene::ComponentDef& def,
                        const scene::Scenario& scenario, const World& world, Canvas& canvas) {
  if (def.type == "LaserScanner") {
    return robot.Add(
        std::make_unique<LaserScanner>(robot, def.name, def.laser, world, scenario.seed));
  }
  if (def.type == "Pose") {
    return robot.Add(std::make_unique<PoseSensor>(robot, def.name, scenario.seed, def.noise));
  }
  if (def.type == "Odometry") {
    return robot.Add(std::make_unique<OdometrySensor>(robot, def.name, scenario.seed));
  }
  if (def.type == "RobotProperties") {
    return robot.Add(std::make_unique<RobotProperties>(robot, def.name, scenario));
  }
  if (def.type == "MotionVW") return robot.Add(std::make_unique<MotionVW>(robot, def.name));
  if (def.type == "Waypoint") return robot.Add(std::make_unique<Waypoint>(robot, def.name));
  if (def.type == "Pen") return robot.Add(std::make_unique<Pen>(robot, def.name, canvas));
  throw Error("there is no component of type '" + def.type + "'");
}

}  // namespace

void Equip(Robot& robot, const scene::Scenario& scenario, const World& world, Canvas& canvas) {
  if (robot.def().components) {
    for (const scene::ComponentDef& def : *robot.def().components) {
      Component& component = AddComponent(robot, def, scenario, world, canvas);
      component.set_frequency(def.frequency);
      component.set_mount(def.position, def.rotation);
      component.set_interfaces(def.stream, def.services);
      component.Reset();  // to show from the start what it has at its place
    }
    return;
  }
  // All types carry the S1R's devices, as far as their scenario mounts them.
  EquipS1R(robot, scenario, world, canvas);
}

}  // namespace ccmorse::sim
