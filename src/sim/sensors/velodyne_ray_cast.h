#pragma once

#include <string>

#include "sim/sensors/laser_scanner.h"

namespace ccmorse::sim {

/// MORSE's VelodyneRayCast (specs: morse.md B.2), a scanner whose fan stands upright, tilted down
/// by 12 degrees, and turns by 0.01745 rad to the left about its mount's z after each activation:
/// LaserScannerRotationZ. Ranges and points are listed from the lowest beam upwards; points are in
/// the frame that turns and is tilted, whose x looks out of the middle of the fan.
class VelodyneRayCast : public LaserScanner {
 public:
  VelodyneRayCast(Robot& robot, const std::string& name, const scene::LaserDef& def,
                  const World& world, std::uint64_t seed);
  void Mounted() override { LetMove(); }
  void Sample(const Instant& now) override;
  void Reset() override;

 private:
  Vec3 PointDirection(std::size_t i) const override;
  Rotation FanRotation() const override;

  double turn_ = 0.0;  // rad, in (-pi, pi]
};

}  // namespace ccmorse::sim
