#include "sim/robots/robot.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/trig.h"
#include "sim/actuators/destination.h"
#include "sim/actuators/drag.h"
#include "sim/actuators/external_force.h"
#include "sim/actuators/force_torque.h"
#include "sim/actuators/light.h"
#include "sim/actuators/motion_vw.h"
#include "sim/actuators/motion_vw_diff.h"
#include "sim/actuators/motion_xyw.h"
#include "sim/actuators/orientation.h"
#include "sim/actuators/pen.h"
#include "sim/actuators/quadrotor_dynamic_control.h"
#include "sim/actuators/rotorcraft_attitude.h"
#include "sim/actuators/rotorcraft_velocity.h"
#include "sim/actuators/rotorcraft_waypoint.h"
#include "sim/actuators/sound.h"
#include "sim/actuators/stabilized_quadrotor.h"
#include "sim/actuators/steer_force.h"
#include "sim/actuators/teleport.h"
#include "sim/actuators/waypoint.h"
#include "sim/canvas.h"
#include "sim/physics/space.h"
#include "sim/robots/s1r.h"
#include "sim/sensors/accelerometer.h"
#include "sim/sensors/airspeed.h"
#include "sim/sensors/attitude.h"
#include "sim/sensors/barometer.h"
#include "sim/sensors/battery.h"
#include "sim/sensors/clock.h"
#include "sim/sensors/collision.h"
#include "sim/sensors/differential_odometry.h"
#include "sim/sensors/gps.h"
#include "sim/sensors/gyroscope.h"
#include "sim/sensors/laser_scanner.h"
#include "sim/sensors/odometry.h"
#include "sim/sensors/pose.h"
#include "sim/sensors/proximity.h"
#include "sim/sensors/radar_altimeter.h"
#include "sim/sensors/raw_odometry.h"
#include "sim/sensors/robot_properties.h"
#include "sim/sensors/thermometer.h"
#include "sim/sensors/velocity.h"

namespace ccmorse::sim {
namespace {

double Square(double number) { return number * number; }

}  // namespace

Robot::Robot(const scene::RobotDef& def, int index)
    : def_(def),
      model_(scene::ModelOf(def)),
      footprint_(Footprint::Make(model_.footprint)),
      index_(index),
      height_(model_.origin_height),
      dynamic_(def_.body && def_.body->dynamics) {
  outline_.outline.reserve(footprint_.outline.size());
  if (dynamic()) {
    // Of the box around it, as if its middle were its centre of mass (specs: morse.md H.2).
    const Vec3 sides{model_.length, model_.width, dynamics()->top - dynamics()->bottom};
    const double share = model_.mass / 12.0;
    inertia_ = {share * (sides.y * sides.y + sides.z * sides.z),
                share * (sides.x * sides.x + sides.z * sides.z),
                share * (sides.x * sides.x + sides.y * sides.y)};
  }
  PlaceAtStart();
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
  orders_.wheels.reset();
}

void Robot::CommandWheels(const WheelSpeeds& speeds, const Actuator* by) {
  command_ = {};
  driver_ = by;
  orders_.wheels = speeds;
}

void Robot::Push(const Vec3& force, const Vec3& torque) {
  orders_.force = orders_.force + force;
  orders_.torque = orders_.torque + torque;
}

void Robot::PlaceInSpace(const RigidState& state) {
  body_ = state;
  orders_.replaced = true;
  Show();
}

void Robot::PlaceAtStart() {
  height_ = model_.origin_height;
  Place(def_.pose);
  if (!dynamic()) return;
  PlaceInSpace({position(), FromEuler(dynamics()->roll, dynamics()->pitch, def_.pose.yaw), {}, {}});
}

void Robot::Show() {
  const Rotation& turned = body_.rotation;
  pose_ = {body_.position.x, body_.position.y, EulerOf(turned).z};
  height_ = body_.position.z;
  const Vec3 own = RotateBack(turned, body_.velocity);
  twist_ = {own.x, RotateBack(turned, body_.spin).z, own.y};
  outline_old_ = true;
}

void Robot::Follow(const RigidState& state, std::vector<Surface> touches, const Instant& now) {
  const Vec3 way = state.position - body_.position;
  if (!orders_.replaced) tally_.distance += std::sqrt(Dot(way, way));
  if (touches_.empty() && !touches.empty()) ++tally_.contacts;
  touches_ = std::move(touches);
  body_ = state;
  orders_.force = {};
  orders_.torque = {};
  orders_.replaced = false;
  Show();
  // Something is in its way when it goes at less than a tenth of what it is told.
  const double asked = std::sqrt(command_.v * command_.v + command_.side * command_.side);
  stalled_ = !touches_.empty() && asked > 0.0 && Dot(way, way) < Square(0.1 * asked * now.step);
  if (stalled_) tally_.stalled += now.step;
  for (const Vec3& v : {state.position, state.rotation.x, state.rotation.y, state.rotation.z,
                        state.velocity, state.spin}) {
    hash_.Add(v.x);
    hash_.Add(v.y);
    hash_.Add(v.z);
  }
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
  if (!dynamic()) return;
  // At its height, upright.
  orders_ = {};
  PlaceInSpace({position(), FromEuler(0.0, 0.0, pose.yaw), {}, {}});
}

void Robot::Orient(double yaw) {
  if (dynamic()) {
    const Vec3 euler = EulerOf(body_.rotation);
    RigidState turned{body_.position, FromEuler(euler.x, euler.y, yaw), body_.velocity, {}};
    return PlaceInSpace(turned);
  }
  pose_.yaw = yaw;
  outline_old_ = true;
}

Vec3 Robot::spin() const { return dynamic() ? body_.spin : Vec3{0.0, 0.0, twist_.w}; }

Rotation Robot::rotation() const {
  return dynamic() ? body_.rotation : FromEuler(0.0, 0.0, pose_.yaw);
}

Vec3 Robot::euler() const {
  return dynamic() ? EulerOf(body_.rotation) : Vec3{0.0, 0.0, pose_.yaw};
}

Vec3 Robot::velocity() const {
  if (dynamic()) return body_.velocity;
  const auto [s, c] = SinCos(pose_.yaw);
  return {c * twist_.v - s * twist_.side, s * twist_.v + c * twist_.side, 0.0};
}

const Obstacle& Robot::outline() const {
  if (outline_old_) {
    outline_.MoveTo(footprint_, pose_);
    outline_old_ = false;
  }
  return outline_;
}

void Robot::Reset() {
  PlaceAtStart();
  touches_.clear();
  driver_ = nullptr;
  tally_ = {};
  for (const auto& component : components_) component->Reset();
}

namespace {

template <typename T, typename... Needs>
Component& AddOf(Robot& robot, const scene::ComponentDef& def, const Needs&... needs) {
  return robot.Add(std::make_unique<T>(robot, def.name, needs...));
}

Component& AddOdometry(Robot& robot, const scene::ComponentDef& def,
                       const scene::Scenario& scenario) {
  if (def.level == "raw") return AddOf<RawOdometry>(robot, def);
  if (def.level == "differential") return AddOf<DifferentialOdometry>(robot, def);
  return robot.Add(std::make_unique<OdometrySensor>(robot, def.name, scenario.seed));
}

// The properties that a script or a file gives; those that the component has not are of no effect.
void SetProperties(Component& component, const Json& properties) {
  for (const auto& [name, value] : properties.AsObject()) {
    if (!component.HasProperty(name)) continue;
    try {
      component.SetProperty(name, value);
    } catch (const WrongArgument& wrong) {
      throw Error(component.full_name() + ": " + wrong.what());
    }
  }
}

Component& AddComponent(Robot& robot, const scene::ComponentDef& def,
                        const scene::Scenario& scenario, const World& world, Canvas& canvas) {
  if (def.type == "LaserScanner") {
    return robot.Add(
        std::make_unique<LaserScanner>(robot, def.name, def.laser, world, scenario.seed));
  }
  if (def.type == "Pose") {
    return robot.Add(std::make_unique<PoseSensor>(robot, def.name, scenario.seed, def.noise));
  }
  if (def.type == "Odometry") return AddOdometry(robot, def, scenario);
  if (def.type == "GPS") {
    return robot.Add(std::make_unique<Gps>(robot, def.name, def.level, scenario));
  }
  if (def.type == "RobotProperties") {
    return robot.Add(std::make_unique<RobotProperties>(robot, def.name, scenario));
  }
  if (def.type == "Pen") return robot.Add(std::make_unique<Pen>(robot, def.name, canvas));
  if (def.type == "Attitude") return AddOf<Attitude>(robot, def, scenario);
  if (def.type == "Battery") return AddOf<Battery>(robot, def, scenario);
  if (def.type == "Collision") return AddOf<Collision>(robot, def, world);
  if (def.type == "Proximity") return AddOf<Proximity>(robot, def, scenario, world);
  if (def.type == "RadarAltimeter") return AddOf<RadarAltimeter>(robot, def, world);
  if (def.type == "Thermometer") return AddOf<Thermometer>(robot, def, scenario, world);
  if (def.type == "RotorcraftAttitude") return AddOf<RotorcraftAttitude>(robot, def, scenario);
  if (def.type == "RotorcraftVelocity") return AddOf<RotorcraftVelocity>(robot, def, scenario);
  if (def.type == "RotorcraftWaypoint") return AddOf<RotorcraftWaypoint>(robot, def, scenario);
  // All others need nothing but their robot and a name.
  using Maker = Component& (*)(Robot&, const scene::ComponentDef&);
  static const std::map<std::string, Maker> makers = {
      {"Accelerometer", AddOf<Accelerometer>},
      {"Airspeed", AddOf<Airspeed>},
      {"Barometer", AddOf<Barometer>},
      {"Clock", AddOf<Clock>},
      {"Destination", AddOf<Destination>},
      {"Drag", AddOf<Drag>},
      {"ExternalForce", AddOf<ExternalForce>},
      {"ForceTorque", AddOf<ForceTorque>},
      {"QuadrotorDynamicControl", AddOf<QuadrotorDynamicControl>},
      {"StabilizedQuadrotor", AddOf<StabilizedQuadrotor>},
      {"SteerForce", AddOf<SteerForce>},
      {"Gyroscope", AddOf<Gyroscope>},
      {"Light", AddOf<Light>},
      {"MotionVW", AddOf<MotionVW>},
      {"MotionVWDiff", AddOf<MotionVWDiff>},
      {"MotionXYW", AddOf<MotionXYW>},
      {"Orientation", AddOf<Orientation>},
      {"Sound", AddOf<Sound>},
      {"Teleport", AddOf<Teleport>},
      {"Velocity", AddOf<Velocity>},
      {"Waypoint", AddOf<Waypoint>}};
  const auto maker = makers.find(def.type);
  if (maker != makers.end()) return maker->second(robot, def);
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
      SetProperties(component, def.properties);
      component.Reset();  // to show from the start what it has at its place
    }
    return;
  }
  // All types carry the S1R's devices, as far as their scenario mounts them.
  EquipS1R(robot, scenario, world, canvas);
}

}  // namespace ccmorse::sim
