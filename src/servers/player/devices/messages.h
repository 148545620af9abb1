#pragma once

#include <cstdint>
#include <string>

#include "servers/player/device.h"
#include "servers/player/device_context.h"

namespace ccmorse::servers::player {

/// speech: what is said goes into the log, up to 200 bytes of it, a few lines a second.
class Speech : public Device {
 public:
  Speech(const std::string& robot, std::uint16_t index);

 protected:
  void Tell(std::uint8_t subtype, const wire::Body& body) override;

 private:
  std::string robot_;
  double second_ = 0.0;  // of wall-clock time
  int said_ = 0;         // in it
};

/// opaque: hands on what one client sends to all who have subscribed, the sender among them. A
/// request is answered with its own bytes as well.
class Opaque : public Device {
 public:
  Opaque(DeviceContext context, std::uint16_t index);

 protected:
  bool Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) override;
  void Tell(std::uint8_t subtype, const wire::Body& body) override;

 private:
  DeviceContext context_;
};

}  // namespace ccmorse::servers::player
