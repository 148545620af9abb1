#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "servers/player/device.h"
#include "servers/player/device_context.h"
#include "sim/robots/robot.h"

namespace ccmorse::servers::player {

/// A device to be made.
struct DeviceDef {
  std::string interface_name;  ///< "position2d"
  int index = 0;               ///< 0..65535
  /// What it shows, where the interface leaves a choice: the name of one of the robot's components
  /// ("odometry", "pose", "hokuyo", "ir", "sonar"); "": the one that it usually shows.
  std::string source = "";
  double frequency = 0.0;  ///< Hz, of what is thinned out; 0: the scenario's read frequency
  bool drives = true;      ///< position2d: takes commands
};

/// The device of a robot. nullptr when the robot carries no such thing. Throws Error for an
/// interface that no robot has.
std::shared_ptr<Device> MakeDevice(const DeviceContext& context, const sim::Robot& robot,
                                   const DeviceDef& def);

/// What a robot serves where nothing else is said. position2d: 0 odometry, which drives, 2 global
/// pose (SyRoTek's conventions; 1 is the goal driver's). laser 0 and ranger 0: the scanner; sonar 0
/// and ranger 1: the sonars; ir 0 and ranger 2: the infra-red sensors. graphics2d: 0 in the robot's
/// frame, 1 in the world's. And one each of bumper, power, blobfinder, fiducial, speech,
/// simulation, map and opaque.
std::vector<DeviceDef> DefaultDevices();

}  // namespace ccmorse::servers::player
