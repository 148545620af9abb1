#pragma once

#include "servers/player/drivers/driver.h"

namespace ccmorse::servers::player {

/// Player's "rangertolaser": provides a laser, requires a ranger of one element (specs: player.md
/// H9).
class RangerToLaser : public Driver {
 public:
  RangerToLaser(const DriverDef& def, const DeviceContext& context, const DeviceList& devices);
  void Data(const DataMessage& message) override;

 protected:
  bool Ask(Provided& device, std::uint8_t subtype, const wire::Body& body, Reply& reply) override;
  void Started() override;

 private:
  bool ReadConfig();

  Provided* laser_ = nullptr;
  Device& ranger_;
  wire::RangerConfig config_;
  wire::LaserData data_;
};

/// Player's "lasertoranger": provides a ranger, requires a laser.
class LaserToRanger : public Driver {
 public:
  LaserToRanger(const DriverDef& def, const DeviceContext& context, const DeviceList& devices);
  void Data(const DataMessage& message) override;

 protected:
  bool Ask(Provided& device, std::uint8_t subtype, const wire::Body& body, Reply& reply) override;

 private:
  Provided* ranger_ = nullptr;
  Device& laser_;
};

}  // namespace ccmorse::servers::player
