#include "sim/sensors/velodyne_ray_cast.h"

#include "base/euler.h"
#include "base/trig.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {
namespace {

constexpr double kTilt = 12.0 * kPi / 180.0;  // rad, downwards
constexpr double kStep = 0.01745;             // rad an activation

}  // namespace

VelodyneRayCast::VelodyneRayCast(Robot& robot, const std::string& name, const scene::LaserDef& def,
                                 const World& world, std::uint64_t seed)
    : LaserScanner(robot, name, "LaserScannerRotationZ", def, world, seed) {}

Rotation VelodyneRayCast::FanRotation() const {
  // The beams of a level fan, stood up so that its left is above.
  const Rotation upright = FromEuler(kPi / 2.0, 0.0, 0.0);
  return Combined(mount_rotation(), Combined(FromEuler(0.0, kTilt, turn_), upright));
}

void VelodyneRayCast::Sample(const Instant& now) {
  LaserScanner::Sample(now);
  turn_ = NormalizeAngle(turn_ + kStep);
}

Vec3 VelodyneRayCast::PointDirection(std::size_t i) const {
  const Vec3 level = fan().Direction(i);
  return {level.x, 0.0 - level.z, level.y};
}

void VelodyneRayCast::Reset() {
  LaserScanner::Reset();
  turn_ = 0.0;
}

}  // namespace ccmorse::sim
