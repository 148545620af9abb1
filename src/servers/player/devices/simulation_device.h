#pragma once

#include <cstdint>

#include "servers/player/device.h"
#include "servers/player/device_context.h"

namespace ccmorse::servers::player {

/// simulation (specs: player.md B.7): poses of robots, by name, and of boxes, as "box_7"; robots
/// can be put elsewhere, where they fit. A robot stands on the floor: z, roll and pitch are 0, and
/// what is asked for them is ignored. RESET puts robots and devices back to the start, time goes
/// on; PAUSE stops all motion, or lets it go on. The property "color" is Stage's: four floats, red,
/// green, blue, alpha, in the machine's order; it cannot be set.
class SimulationDevice : public Device {
 public:
  SimulationDevice(DeviceContext context, std::uint16_t index);

 protected:
  bool Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) override;
  void Tell(std::uint8_t subtype, const wire::Body& body) override;

 private:
  bool FindPose(const std::string& name, wire::Pose2d& pose) const;
  bool PlaceRobot(const std::string& name, double x, double y, double yaw) const;
  bool GetProperty(const wire::Body& body, Reply& reply) const;

  DeviceContext context_;
  bool paused_ = false;
};

}  // namespace ccmorse::servers::player
