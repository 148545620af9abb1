#pragma once

#include <cstdint>
#include <vector>

#include "servers/player/device.h"
#include "servers/player/device_context.h"
#include "sim/sensors/laser_scanner.h"

namespace ccmorse::servers::player {

/// laser of a robot's scanner (specs: player.md B.7): every scan, as it is sampled, with an
/// intensity of 0 for each beam. Of several layers it shows the middle one. The scanner is as the
/// scenario has it: SET_CONFIG is acknowledged only where it asks for what is.
class Laser : public Device {
 public:
  Laser(DeviceContext context, std::uint16_t index, const sim::LaserScanner& scanner);
  void Step() override;

 protected:
  bool Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) override;
  void FirstSubscribed() override { samples_ = scanner_.samples(); }

 private:
  DeviceContext context_;
  const sim::LaserScanner& scanner_;
  std::uint64_t samples_ = 0;
  wire::LaserData data_;
};

/// ranger of the same: one element, ranges as doubles; intensities, all 0, once a client has
/// asked for them.
class ScannerRanger : public Device {
 public:
  ScannerRanger(DeviceContext context, std::uint16_t index, const sim::LaserScanner& scanner);
  void Step() override;

 protected:
  bool Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) override;
  void FirstSubscribed() override { samples_ = scanner_.samples(); }
  void LastLeft() override { intensities_ = false; }

 private:
  DeviceContext context_;
  const sim::LaserScanner& scanner_;
  std::uint64_t samples_ = 0;
  bool intensities_ = false;
  wire::RangerDataRange data_;
};

}  // namespace ccmorse::servers::player
