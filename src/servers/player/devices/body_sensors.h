#pragma once

#include <cstdint>
#include <vector>

#include "servers/player/device.h"
#include "servers/player/device_context.h"
#include "sim/physics/kinematics.h"
#include "sim/robots/robot.h"

namespace ccmorse::servers::player {

/// bumper: each side of the robot's footprint is a switch, counter-clockwise, that is closed while
/// the robot has been stopped by something and that side is within a millimetre of it (specs:
/// player.md B.7). Sides are straight: their radius is 0.
class Bumper : public Device {
 public:
  Bumper(DeviceContext context, const sim::Robot& robot, std::uint16_t index, double frequency);
  void Step() override;

 protected:
  bool Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) override;

 private:
  DeviceContext context_;
  const sim::Robot& robot_;
  PublishRate rate_;
  std::vector<sim::Footprint> sides_;            // as thin bars before them
  std::vector<const sim::Obstacle*> obstacles_;  // scratch
};

/// power: a battery that is always full, as the simulator has none (12 V, 100 %), once a second.
class Power : public Device {
 public:
  Power(DeviceContext context, std::uint16_t index);
  void Step() override;

 protected:
  bool Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) override;

 private:
  DeviceContext context_;
  PublishRate rate_;
};

}  // namespace ccmorse::servers::player
