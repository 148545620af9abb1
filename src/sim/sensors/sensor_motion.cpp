#include "sim/sensors/sensor_motion.h"

#include <cmath>

#include "base/euler.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {
namespace {

constexpr double kShortestStep = 1e-6;  // s; nothing is updated after less (specs: morse.md B.2)
constexpr double kLever = 0.01;         // m from the robot's origin from which on it counts

}  // namespace

MountPlace PlaceOfMount(const Component& component) {
  const Robot& robot = component.robot();
  const Vec3 mount = component.mount();
  const Vec3& euler = component.mount_euler();
  const Vec2 at = Transform(robot.pose(), {mount.x, mount.y});
  MountPlace result;
  result.position = {at.x, at.y, robot.position().z + mount.z};
  // Rz(robot) Rz Ry Rx of the mount: its yaw is added, roll and pitch are the mount's own.
  result.euler = {euler.x, euler.y, NormalizeAngle(robot.pose().yaw + euler.z)};
  result.rotation = FromEuler(result.euler.x, result.euler.y, result.euler.z);
  if (robot.tilted()) {
    const Rotation body = robot.rotation();
    result.position = robot.position() + Rotate(body, mount);
    result.rotation = Combined(body, FromEuler(euler.x, euler.y, euler.z));
    result.euler = ToEuler(result.rotation);
  }
  return result;
}

const SensorMotion::State& SensorMotion::Update(const Instant& now, const std::string& mode) {
  const double step = now.time - last_time_;
  if (moved_before_ && step < kShortestStep) return state_;
  const MountPlace before = state_.place;
  const Vec3 velocity_before = state_.velocity;
  state_ = {};
  state_.place = PlaceOfMount(component_);
  if (moved_before_) {
    state_.step = step;
    state_.distance = Length(state_.place.position - before.position);
  }
  if (mode == "Position") {
    ByPosition(before);
  } else {
    ByVelocity();
  }
  if (moved_before_) state_.acceleration = (1.0 / step) * (state_.velocity - velocity_before);
  last_time_ = now.time;
  moved_before_ = true;
  return state_;
}

void SensorMotion::ByVelocity() {
  const Robot& robot = component_.robot();
  const Rotation mount = component_.mount_rotation();
  state_.velocity = robot.velocity();
  const Vec3 spin = robot.dynamic() ? RotateBack(robot.rotation(), robot.spin())
                                    : Vec3{0.0, 0.0, robot.twist().w};
  state_.angular_velocity = RotateBack(mount, spin);
  const Vec3 arm = component_.mount();
  if (Length(arm) > kLever) {
    Vec3 lever = Cross(spin, Cross(spin, arm));
    if (state_.step > 0.0) {
      const Vec3 change = spin - last_spin_;
      lever = lever +
              Cross({change.x / state_.step, change.y / state_.step, change.z / state_.step}, arm);
    }
    state_.lever_acceleration = RotateBack(mount, lever);
  }
  last_spin_ = spin;
}

void SensorMotion::ByPosition(const MountPlace& before) {
  if (state_.step <= 0.0) return;
  const MountPlace& here = state_.place;
  state_.velocity = (1.0 / state_.step) * (here.position - before.position);
  if (component_.robot().dynamic()) {
    // The turn from there to here, as seen from there: of a small one, its axis and angle.
    const Vec3 x = RotateBack(before.rotation, here.rotation.x);
    const Vec3 y = RotateBack(before.rotation, here.rotation.y);
    const Vec3 z = RotateBack(before.rotation, here.rotation.z);
    const Vec3 axis{0.5 * (y.z - z.y), 0.5 * (z.x - x.z), 0.5 * (x.y - y.x)};
    const double sine = Length(axis);
    const double angle = Atan2(sine, 0.5 * (x.x + y.y + z.z - 1.0));
    state_.angular_velocity = (sine > 0.0 ? angle / sine / state_.step : 0.0) * axis;
    return;
  }
  // Of robots that turn about z only, the rates of the angles are the rate of yaw.
  const double rate = NormalizeAngle(here.euler.z - before.euler.z) / state_.step;
  state_.angular_velocity = RotateBack(component_.mount_rotation(), {0.0, 0.0, rate});
}

void SensorMotion::Reset() {
  state_ = {};
  state_.place = PlaceOfMount(component_);
  last_time_ = 0.0;
  last_spin_ = {};
  moved_before_ = false;
}

}  // namespace ccmorse::sim
