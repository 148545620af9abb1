#pragma once

#include "navigation/snd.h"
#include "servers/player/drivers/driver.h"

namespace ccmorse::servers::player {

/// Player's "snd": smooth nearness diagram navigation (specs: player.md G.1). Provides a position2d
/// that takes goals; requires "input" position2d, where it is, "output" position2d, which it
/// drives, and a laser. Its data are the input's; speeds and all requests go to the output. What it
/// needs to know of the laser's place on the robot it asks the laser. A goal is in the input's
/// frame. Options: those of navigation::SndOptions, lengths and angles in the file's units (degrees
/// unless it says otherwise).
class SndDriver : public Driver {
 public:
  SndDriver(const DriverDef& def, const DeviceContext& context, const DeviceList& devices);
  void Data(const DataMessage& message) override;

 protected:
  bool Ask(Provided& device, std::uint8_t subtype, const wire::Body& body, Reply& reply) override;
  void Tell(Provided& device, std::uint8_t subtype, const wire::Body& body) override;
  void Started() override;
  void Stopped() override;

 private:
  void Drive(double speed, double turn_rate);

  Device& input_;
  Device& output_;
  Device& laser_;
  Provided* goals_ = nullptr;
  navigation::Snd snd_;
  Pose2 pose_;   // the newest of the input
  Pose2 mount_;  // of the laser
  bool has_pose_ = false;
};

/// The goal driver that SyRoTek's robots have as position2d:1 (specs: syrotek.md A), with settings
/// for the S1R; `settings`, the scenario's robots[].drivers.snd, overrules them: by name, m and
/// degrees.
DriverDef SyrotekSnd(const Json::Object& settings);

}  // namespace ccmorse::servers::player
