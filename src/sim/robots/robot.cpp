#include "sim/robots/robot.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/euler.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "sim/actuators/arucomarker.h"
#include "sim/actuators/destination.h"
#include "sim/actuators/drag.h"
#include "sim/actuators/external_force.h"
#include "sim/actuators/force_torque.h"
#include "sim/actuators/gripper.h"
#include "sim/actuators/keyboard.h"
#include "sim/actuators/light.h"
#include "sim/actuators/motion_vw.h"
#include "sim/actuators/motion_vw_diff.h"
#include "sim/actuators/motion_xyw.h"
#include "sim/actuators/orientation.h"
#include "sim/actuators/pen.h"
#include "sim/actuators/ptu.h"
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
#include "sim/modifiers/modifier.h"
#include "sim/own/own_component.h"
#include "sim/robots/s1r.h"
#include "sim/sensors/accelerometer.h"
#include "sim/sensors/airspeed.h"
#include "sim/sensors/attitude.h"
#include "sim/sensors/barometer.h"
#include "sim/sensors/battery.h"
#include "sim/sensors/clock.h"
#include "sim/sensors/collision.h"
#include "sim/sensors/compound_sensor.h"
#include "sim/sensors/differential_odometry.h"
#include "sim/sensors/gps.h"
#include "sim/sensors/gyroscope.h"
#include "sim/sensors/imu.h"
#include "sim/sensors/laser_scanner.h"
#include "sim/sensors/magnetometer.h"
#include "sim/sensors/odometry.h"
#include "sim/sensors/pose.h"
#include "sim/sensors/proximity.h"
#include "sim/sensors/ptu_posture.h"
#include "sim/sensors/radar_altimeter.h"
#include "sim/sensors/raw_odometry.h"
#include "sim/sensors/robot_properties.h"
#include "sim/sensors/search_and_rescue.h"
#include "sim/sensors/semantic_camera.h"
#include "sim/sensors/thermometer.h"
#include "sim/sensors/velocity.h"
#include "sim/sensors/velodyne_ray_cast.h"

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
  Land(def_.z);
  if (!dynamic()) return;
  PlaceInSpace({position(), FromEuler(dynamics()->roll, dynamics()->pitch, def_.pose.yaw), {}, {}});
}

void Robot::Show() {
  const Rotation& turned = body_.rotation;
  pose_ = {body_.position.x, body_.position.y, ToEuler(turned).z};
  height_ = body_.position.z;
  const Vec3 own = RotateBack(turned, body_.velocity);
  twist_ = {own.x, RotateBack(turned, body_.spin).z, own.y};
  outline_old_ = true;
}

void Robot::Follow(const RigidState& moved, std::vector<Surface> touches, const Instant& now) {
  const RigidState state = held_ ? RigidState{body_.position, body_.rotation, {}, {}} : moved;
  const Vec3 way = state.position - body_.position;
  if (!orders_.replaced) tally_.distance += std::sqrt(Dot(way, way));
  if (touches_.empty() && !touches.empty()) ++tally_.contacts;
  touches_ = std::move(touches);
  body_ = state;
  orders_.force = {};
  orders_.torque = {};
  orders_.replaced = held_;
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
  const Twist told = Worn(now.step);
  twist_ = held_ ? Twist{} : told;
  stalled_ = false;
  if (held_) {
    // It stays.
  } else if (told.v != 0.0 || told.w != 0.0 || told.side != 0.0) {
    const MotionResult moved =
        ground_ != nullptr
            ? MoveOnGround(now, told, obstacles)
            : DriveUntilContact(footprint_, pose_, told.v, told.w, now.step, obstacles, told.side);
    pose_ = moved.pose;
    tally_.distance += moved.driven;
    stalled_ = moved.blocked;
    outline_old_ = true;
  }
  if (ground_ != nullptr) {
    const double before = stand_.z;
    if (!def_.body || !def_.body->flies) stand_ = ground_->StandAt(footprint_, pose_, stand_.z);
    climb_ = (stand_.z - before) / now.step;
    hash_.Add(stand_.z);
    hash_.Add(stand_.roll);
    hash_.Add(stand_.pitch);
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

Vec3 Robot::foot() const {
  if (!tilted()) return {pose_.x, pose_.y, stand_.z};
  return position() - Rotate(rotation(), {0.0, 0.0, model_.origin_height});
}

void Robot::set_ground(const Ground& ground) {
  // A dynamic robot lies on the ground's triangles.
  if (ground.empty() || dynamic()) return;
  ground_ = &ground;
  Land(def_.z);
}

void Robot::Land(double from) {
  climb_ = 0.0;
  if (ground_ == nullptr || (def_.body && def_.body->flies)) return;
  stand_ = ground_->StandAt(footprint_, pose_, ground_->Land({pose_.x, pose_.y}, from));
}

void Robot::FindInTheWay(double reach, std::vector<Obstacle>& found) const {
  if (ground_ == nullptr) return;
  const bool flies = def_.body && def_.body->flies;
  // What is low is driven over; what has no hull is as high as a step.
  double bottom = Ground::kStep;
  double top = 2.0 * Ground::kStep;
  if (flies && !model_.hull.empty()) bottom = model_.hull.front().bottom;
  for (const scene::HullPart& part : model_.hull) {
    top = std::max(top, part.top);
    if (flies) bottom = std::min(bottom, part.bottom);
  }
  ground_->Obstacles(pose_, stand_, reach, bottom, top, flies, found);
}

Twist Robot::Worn(double step) {
  const scene::WearDef& wear = def_.wear;
  if (wear == scene::WearDef{}) return command_;
  // The exact solution over a step is exp(-step / lag), which needs libm; this is its rational
  // approximation, right to first order and stable for any step.
  turning_ += (command_.w - turning_) * step / (step + wear.turn_lag);
  return {command_.v, turning_ + wear.pull * command_.v, command_.side};
}

MotionResult Robot::MoveOnGround(const Instant& now, const Twist& told,
                                 std::span<const Obstacle* const> obstacles) const {
  thread_local std::vector<Obstacle> found;
  thread_local std::vector<const Obstacle*> in_the_way;
  found.clear();
  in_the_way.assign(obstacles.begin(), obstacles.end());
  const double speed = std::sqrt(told.v * told.v + told.side * told.side);
  FindInTheWay(footprint_.radius + speed * now.step + 0.01, found);
  // What the robot stands in lets it out, as physics would push it, but no deeper in.
  const std::vector<Vec2> start = footprint_.At(pose_);
  const std::vector<Vec2> end = footprint_.At(DriveArc(pose_, told.v, told.w, now.step, told.side));
  for (const Obstacle& obstacle : found) {
    const Obstacle* const one = &obstacle;
    if (!Collides(footprint_, pose_, {&one, 1})) {
      in_the_way.push_back(one);
    } else if (ConvexGap(end, obstacle.outline) < ConvexGap(start, obstacle.outline)) {
      return {pose_, true, 0.0};
    }
  }
  return DriveUntilContact(footprint_, pose_, told.v, told.w, now.step, in_the_way, told.side);
}

void Robot::Place(const Pose2& pose) {
  pose_ = pose;
  Land(stand_.z);
  twist_ = {};
  command_ = {};
  turning_ = 0.0;
  stalled_ = false;
  outline_old_ = true;
  if (!dynamic()) return;
  // At its height, upright.
  orders_ = {};
  PlaceInSpace({position(), FromEuler(0.0, 0.0, pose.yaw), {}, {}});
}

void Robot::Orient(double yaw) {
  if (dynamic()) {
    const Vec3 euler = ToEuler(body_.rotation);
    RigidState turned{body_.position, FromEuler(euler.x, euler.y, yaw), body_.velocity, {}};
    return PlaceInSpace(turned);
  }
  pose_.yaw = yaw;
  Land(stand_.z);
  outline_old_ = true;
}

Vec3 Robot::spin() const { return dynamic() ? body_.spin : Vec3{0.0, 0.0, twist_.w}; }

Rotation Robot::rotation() const {
  return dynamic() ? body_.rotation : FromEuler(stand_.roll, stand_.pitch, pose_.yaw);
}

Vec3 Robot::euler() const {
  return dynamic() ? ToEuler(body_.rotation) : Vec3{stand_.roll, stand_.pitch, pose_.yaw};
}

Vec3 Robot::velocity() const {
  if (dynamic()) return body_.velocity;
  const auto [s, c] = SinCos(pose_.yaw);
  return {c * twist_.v - s * twist_.side, s * twist_.v + c * twist_.side, climb_};
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
  held_ = false;
  driver_ = nullptr;
  tally_ = {};
  for (const auto& component : components_) component->Reset();
}

namespace {

template <typename T, typename... Needs>
Component& AddOf(Robot& robot, const scene::ComponentDef& def, Needs&... needs) {
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
                        const scene::Scenario& scenario, World& world, Canvas& canvas) {
  if (def.own) return AddOwn(robot, def);
  if (def.type == "LaserScanner") {
    return robot.Add(
        std::make_unique<LaserScanner>(robot, def.name, def.laser, world, scenario.seed));
  }
  if (def.type == "VelodyneRayCast") {
    return robot.Add(
        std::make_unique<VelodyneRayCast>(robot, def.name, def.laser, world, scenario.seed));
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
  if (def.type == "Proximity") return AddOf<Proximity>(robot, def, world);
  if (def.type == "RadarAltimeter") return AddOf<RadarAltimeter>(robot, def, world);
  if (def.type == "RotorcraftAttitude") return AddOf<RotorcraftAttitude>(robot, def, scenario);
  if (def.type == "RotorcraftVelocity") return AddOf<RotorcraftVelocity>(robot, def, scenario);
  if (def.type == "RotorcraftWaypoint") return AddOf<RotorcraftWaypoint>(robot, def, scenario);
  if (def.type == "Thermometer") return AddOf<Thermometer>(robot, def, world);
  if (def.type == "CompoundSensor") return AddOf<CompoundSensor>(robot, def, world);
  if (def.type == "Gripper") return AddOf<Gripper>(robot, def, world);
  if (def.type == "IMU") return AddOf<Imu>(robot, def, scenario);
  if (def.type == "Magnetometer") return AddOf<Magnetometer>(robot, def, scenario);
  if (def.type == "PTU") return AddOf<Ptu>(robot, def, world);
  if (def.type == "SearchAndRescue") return AddOf<SearchAndRescue>(robot, def, world);
  if (def.type == "SemanticCamera") return AddOf<SemanticCamera>(robot, def, world);
  // All others need nothing but their robot and a name.
  using Maker = Component& (*)(Robot&, const scene::ComponentDef&);
  static const std::map<std::string, Maker> makers = {
      {"Accelerometer", AddOf<Accelerometer>},
      {"Airspeed", AddOf<Airspeed>},
      {"Arucomarker", AddOf<Arucomarker>},
      {"Barometer", AddOf<Barometer>},
      {"Clock", AddOf<Clock>},
      {"Destination", AddOf<Destination>},
      {"Drag", AddOf<Drag>},
      {"ExternalForce", AddOf<ExternalForce>},
      {"ForceTorque", AddOf<ForceTorque>},
      {"Gyroscope", AddOf<Gyroscope>},
      {"Keyboard", AddOf<Keyboard>},
      {"Light", AddOf<Light>},
      {"MotionVW", AddOf<MotionVW>},
      {"MotionVWDiff", AddOf<MotionVWDiff>},
      {"MotionXYW", AddOf<MotionXYW>},
      {"Orientation", AddOf<Orientation>},
      {"PTUPosture", AddOf<PtuPosture>},
      {"QuadrotorDynamicControl", AddOf<QuadrotorDynamicControl>},
      {"Sound", AddOf<Sound>},
      {"StabilizedQuadrotor", AddOf<StabilizedQuadrotor>},
      {"SteerForce", AddOf<SteerForce>},
      {"Teleport", AddOf<Teleport>},
      {"Velocity", AddOf<Velocity>},
      {"Waypoint", AddOf<Waypoint>}};
  const auto maker = makers.find(def.type);
  if (maker != makers.end()) return maker->second(robot, def);
  throw Error("there is no component of type '" + def.type + "'");
}

// Has each of the robot's components from the `first` on know what it is mounted on: "arm.tool"
// sits on "arm", where there is one, else on the robot.
void MountComponents(Robot& robot, std::size_t first) {
  std::vector<Component*> inner_first;
  for (std::size_t i = first; i < robot.components().size(); ++i) {
    inner_first.push_back(robot.components()[i].get());
  }
  const auto depth = [](const Component* one) {
    return std::count(one->name().begin(), one->name().end(), '.');
  };
  std::stable_sort(inner_first.begin(), inner_first.end(),
                   [&](const Component* a, const Component* b) { return depth(a) < depth(b); });
  for (Component* component : inner_first) {
    std::string_view holder = component->name();
    Component* parent = nullptr;
    while (parent == nullptr && holder.find('.') != std::string_view::npos) {
      holder = holder.substr(0, holder.rfind('.'));
      const auto found = std::find_if(inner_first.begin(), inner_first.end(),
                                      [&](const Component* one) { return one->name() == holder; });
      if (found != inner_first.end()) parent = *found;
    }
    component->set_parent(parent);
    component->Mounted();
    component->Reset();  // to show from the start what it has at its place
  }
}

}  // namespace

void Equip(Robot& robot, const scene::Scenario& scenario, World& world, Canvas& canvas) {
  if (robot.def().components) {
    const std::size_t first = robot.components().size();
    for (const scene::ComponentDef& def : *robot.def().components) {
      Component& component = AddComponent(robot, def, scenario, world, canvas);
      component.set_frequency(def.frequency);
      component.set_mount(def.position, def.rotation);
      component.set_interfaces(def.stream, def.services);
      SetProperties(component, def.properties);
      for (std::size_t i = 0; i < def.modifiers.size(); ++i) {
        component.AddModifier(MakeModifier(component, def.modifiers[i], scenario, i));
      }
    }
    MountComponents(robot, first);
    return;
  }
  // All types carry the S1R's devices, as far as their scenario mounts them.
  EquipS1R(robot, scenario, world, canvas);
}

}  // namespace ccmorse::sim
