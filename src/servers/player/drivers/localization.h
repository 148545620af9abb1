#pragma once

#include <memory>
#include <string>

#include "servers/player/drivers/driver.h"

namespace ccmorse::servers::player {

/// Player's "mapfile": provides a map that is read from a picture. Options: filename (a PNG),
/// resolution (m a pixel), negate (0 or 1; 1: light is occupied), origin ([x y], m, of the lower
/// left corner; by default the middle of the picture is at the origin).
class MapFile : public Driver {
 public:
  MapFile(const DriverDef& def, const DeviceContext& context, const DeviceList& devices);

 protected:
  bool Ask(Provided& device, std::uint8_t subtype, const wire::Body& body, Reply& reply) override {
    return device.index() == map_->index() && map_->Request(subtype, body, reply);
  }

 private:
  std::shared_ptr<Device> map_;
};

/// Player's "fakelocalize": provides a localize, and if the file says so a position2d, whose one
/// hypothesis is the true pose of a robot. Requires a simulation. Option: model (the robot's name).
/// The map's frame is the world's.
class FakeLocalize : public Driver {
 public:
  FakeLocalize(const DriverDef& def, const DeviceContext& context, const DeviceList& devices);
  void Step() override;

 protected:
  bool Ask(Provided& device, std::uint8_t subtype, const wire::Body& body, Reply& reply) override;

 private:
  bool ReadPose(wire::Pose2d& pose);

  const DeviceContext context_;
  Device& simulation_;
  Provided* localize_ = nullptr;
  Provided* position_ = nullptr;
  std::string model_;
  PublishRate rate_;
};

/// localize:0 of a robot where nothing else is said: its true pose.
DriverDef TruePlace(const std::string& robot);

}  // namespace ccmorse::servers::player
