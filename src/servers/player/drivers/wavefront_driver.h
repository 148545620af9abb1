#pragma once

#include <optional>

#include "navigation/wavefront.h"
#include "servers/player/drivers/driver.h"

namespace ccmorse::servers::player {

/// Player's "wavefront": a planner on a map (specs: player.md G.4). Requires "input", a position2d
/// or a localize, where the robot is on the map; "output", a position2d that goes to positions
/// (snd, vfh, nd), whose frame may be another: waypoints are turned into it; and a map, read when
/// the first user comes and, with force_map_refresh, for each goal. Options: those of
/// navigation::WavefrontOptions, lengths and angles in the file's units (degrees unless it says
/// otherwise), force_map_refresh (0) and update_rate (10 Hz). cspace_file has no effect: nothing
/// is kept in files. The command START has none either: plans start where the robot is.
class WavefrontDriver : public Driver {
 public:
  WavefrontDriver(const DriverDef& def, const DeviceContext& context, const DeviceList& devices);
  void Data(const DataMessage& message) override;
  void Step() override;

 protected:
  bool Ask(Provided& device, std::uint8_t subtype, const wire::Body& body, Reply& reply) override;
  void Tell(Provided& device, std::uint8_t subtype, const wire::Body& body) override;
  void Started() override;
  void Stopped() override;

 private:
  void LoadMap();
  void Drive(const navigation::WavefrontStatus& status);
  double PathLength() const;

  const DeviceContext context_;
  const navigation::WavefrontOptions options_;
  const bool refresh_map_;
  PublishRate rate_;
  Device* input_ = nullptr;
  Device& output_;
  Device& map_;
  Provided* planner_ = nullptr;
  std::optional<navigation::Wavefront> wavefront_;  // while it has a map
  std::optional<Pose2> pose_;                       // on the map
  std::optional<Pose2> output_pose_;                // in the output's frame, where it says so
  std::optional<Pose2> sent_;                       // the goal that the output has been given
  bool enabled_ = true;
};

/// The planner of SyRoTek's robots, planner:0 over map:0, which has them driven by position2d:1;
/// with settings for the S1R.
DriverDef SyrotekPlanner();

}  // namespace ccmorse::servers::player
