#include "sim/robots/robot.h"

#include <algorithm>

#include "sim/canvas.h"
#include "sim/robots/s1r.h"

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

void Equip(Robot& robot, const scene::Scenario& scenario, const World& world, Canvas& canvas) {
  // All types carry the S1R's devices, as far as their scenario mounts them.
  EquipS1R(robot, scenario, world, canvas);
}

}  // namespace ccmorse::sim
