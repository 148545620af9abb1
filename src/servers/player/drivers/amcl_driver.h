#pragma once

#include <optional>

#include "navigation/amcl.h"
#include "servers/player/drivers/driver.h"

namespace ccmorse::servers::player {

/// Player's "amcl": finds the robot on a map (specs: player.md G.5). Provides a localize, its
/// hypotheses, the likeliest first, and if the file says so a position2d, the likeliest pose with
/// the odometry's speeds; both with each scan, in the map's frame. Requires "odometry" position2d,
/// a laser and a map, read when the first user comes, which is also when it starts anew. Options:
/// those of navigation::AmclOptions, lengths and angles in the file's units (degrees unless it says
/// otherwise), with odom_drift[0], [1] and [2]; laser_pose (where the laser sits; by default it is
/// asked). Random numbers have the scenario's seed.
class AmclDriver : public Driver {
 public:
  AmclDriver(const DriverDef& def, const DeviceContext& context, const DeviceList& devices);
  void Data(const DataMessage& message) override;

 protected:
  bool Ask(Provided& device, std::uint8_t subtype, const wire::Body& body, Reply& reply) override;
  void Started() override;

 private:
  void Publish(double time);
  bool SetPose(const wire::Body& body);

  const navigation::AmclOptions options_;
  std::optional<Pose2> laser_pose_;  // as the file says
  Device& odometry_;
  Device& laser_;
  Device& map_;
  Provided* localize_ = nullptr;
  Provided* position_ = nullptr;
  std::optional<navigation::Amcl> amcl_;        // while it has a map
  std::optional<wire::Position2dData> driven_;  // what the odometry last told
  Pose2 mount_;                                 // of the laser
};

}  // namespace ccmorse::servers::player
