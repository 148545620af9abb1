#pragma once

#include <cstdint>

#include "servers/player/device.h"
#include "servers/player/device_context.h"
#include "sim/sensors/range_ring.h"

namespace ccmorse::servers::player {

/// A ring of range sensors, infra-red or sonar, as sonar, ir or ranger (specs: player.md B.7): all
/// ranges as they are sampled, in the order of the ring's poses. As an ir it gives no voltages: 0 V
/// each. As a ranger each sensor is an element.
class Ring : public Device {
 public:
  /// `interface_code`: kSonar, kIr or kRanger.
  Ring(DeviceContext context, std::uint16_t interface_code, std::uint16_t index,
       const sim::RangeRing& ring);
  void Step() override;

 protected:
  bool Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) override;
  void FirstSubscribed() override { samples_ = ring_.samples(); }

 private:
  bool AskSonar(std::uint8_t subtype, const wire::Body& body, Reply& reply) const;
  bool AskIr(std::uint8_t subtype, const wire::Body& body, Reply& reply) const;
  bool AskRanger(std::uint8_t subtype, const wire::Body& body, Reply& reply) const;
  std::vector<wire::Pose3d> Poses() const;
  double Setting(const char* name) const;

  DeviceContext context_;
  const sim::RangeRing& ring_;
  Json settings_;
  std::uint64_t samples_ = 0;
};

}  // namespace ccmorse::servers::player
