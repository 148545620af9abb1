#include "sim/robots/robot.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "base/trig.h"
#include "sim/actuators/arucomarker.h"
#include "sim/actuators/destination.h"
#include "sim/actuators/gripper.h"
#include "sim/actuators/keyboard.h"
#include "sim/actuators/light.h"
#include "sim/actuators/motion_vw.h"
#include "sim/actuators/motion_vw_diff.h"
#include "sim/actuators/motion_xyw.h"
#include "sim/actuators/orientation.h"
#include "sim/actuators/pen.h"
#include "sim/actuators/ptu.h"
#include "sim/actuators/sound.h"
#include "sim/actuators/teleport.h"
#include "sim/actuators/waypoint.h"
#include "sim/canvas.h"
#include "sim/modifiers/modifier.h"
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

void Robot::Orient(double yaw) {
  pose_.yaw = yaw;
  outline_old_ = true;
}

Vec3 Robot::velocity() const {
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
  Place(def_.pose);
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
  static const std::map<std::string, Maker> makers = {{"Accelerometer", AddOf<Accelerometer>},
                                                      {"Airspeed", AddOf<Airspeed>},
                                                      {"Arucomarker", AddOf<Arucomarker>},
                                                      {"Barometer", AddOf<Barometer>},
                                                      {"Clock", AddOf<Clock>},
                                                      {"Destination", AddOf<Destination>},
                                                      {"Gyroscope", AddOf<Gyroscope>},
                                                      {"Keyboard", AddOf<Keyboard>},
                                                      {"Light", AddOf<Light>},
                                                      {"MotionVW", AddOf<MotionVW>},
                                                      {"MotionVWDiff", AddOf<MotionVWDiff>},
                                                      {"MotionXYW", AddOf<MotionXYW>},
                                                      {"Orientation", AddOf<Orientation>},
                                                      {"PTUPosture", AddOf<PtuPosture>},
                                                      {"Sound", AddOf<Sound>},
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
