#include "sim/actuators/teleport.h"

#include <cmath>

#include "base/euler.h"
#include "base/trig.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {
namespace {

constexpr double kFarthestJump = 1e6;  // m

}  // namespace

Teleport::Teleport(Robot& robot, const std::string& name)
    : Actuator(robot, name, "Teleport", 60.0) {
  AddService({"translate", {{"x"}, {"y", true}, {"z", true}}, [this](Arguments arguments) {
                SetTarget(position_ + Vec3{NumberArgument(arguments, 0, "x"),
                                           NumberArgument(arguments, 1, "y", 0.0),
                                           NumberArgument(arguments, 2, "z", 0.0)},
                          euler_);
                return Json();
              }});
  AddService({"rotate", {{"roll"}, {"pitch", true}, {"yaw", true}}, [this](Arguments arguments) {
                SetTarget(position_, euler_ + Vec3{NumberArgument(arguments, 0, "roll"),
                                                   NumberArgument(arguments, 1, "pitch", 0.0),
                                                   NumberArgument(arguments, 2, "yaw", 0.0)});
                return Json();
              }});
}

void Teleport::SetTarget(const Vec3& position, const Vec3& euler) {
  for (const double part : {position.x, position.y, position.z, euler.x, euler.y, euler.z}) {
    if (!(std::fabs(part) <= kFarthestJump)) throw WrongArgument("that is too far away");
  }
  position_ = position;
  euler_ = euler;
  DataChanged(timestamp());
}

void Teleport::Receive(const Json& message) {
  SetTarget({NumberMember(message, "x"), NumberMember(message, "y"), NumberMember(message, "z")},
            {NumberMember(message, "roll"), NumberMember(message, "pitch"),
             NumberMember(message, "yaw")});
}

void Teleport::Act(const Instant& now) {
  DataChanged(now.time);
  if (robot().dynamic()) {
    // So that the actuator itself is there: its robot is turned by what the mount is not.
    const Rotation wanted = FromEuler(euler_.x, euler_.y, euler_.z);
    const Rotation mounted = mount_rotation();
    const Rotation back{{mounted.x.x, mounted.y.x, mounted.z.x},
                        {mounted.x.y, mounted.y.y, mounted.z.y},
                        {mounted.x.z, mounted.y.z, mounted.z.z}};
    const Rotation turned = Combined(wanted, back);
    return robot().PlaceInSpace({position_ - Rotate(turned, mount()), turned, {}, {}});
  }
  const double yaw = NormalizeAngle(euler_.z - mount_euler().z);
  const auto [s, c] = SinCos(yaw);
  const Vec3 arm = mount();
  robot().Place(
      {position_.x - (c * arm.x - s * arm.y), position_.y - (s * arm.x + c * arm.y), yaw});
}

void Teleport::Reset() {
  Actuator::Reset();
  const MountPlace here = PlaceOfMount(*this);
  position_ = here.position;
  euler_ = here.euler;
}

void Teleport::AppendFields(std::string& out) const {
  AppendField(out, "x", position_.x);
  AppendField(out, "y", position_.y);
  AppendField(out, "z", position_.z);
  AppendField(out, "yaw", euler_.z);
  AppendField(out, "pitch", euler_.y);
  AppendField(out, "roll", euler_.x);
}

}  // namespace ccmorse::sim
