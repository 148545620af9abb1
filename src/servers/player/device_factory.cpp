#include "servers/player/device_factory.h"

#include <array>

#include "base/error.h"
#include "servers/player/devices/position2d.h"
#include "servers/player/devices/scanner.h"

namespace ccmorse::servers::player {
namespace {

// The component that a device is to show, of the type that it needs; nullptr where there is none.
template <typename Component>
const Component* Find(const DeviceContext& context, const sim::Robot& robot, const DeviceDef& def,
                      const char* usual) {
  const std::string& name = def.source.empty() ? usual : def.source;
  return dynamic_cast<const Component*>(
      context.simulation.FindComponent(robot.name() + "." + name));
}

double Frequency(const DeviceContext& context, const DeviceDef& def) {
  return def.frequency > 0.0 ? def.frequency : context.simulation.scenario().time.read_frequency;
}

using Made = std::shared_ptr<Device>;

Made MakePosition2d(const DeviceContext& context, const sim::Robot& robot, const DeviceDef& def) {
  const auto* const sensor = Find<sim::Sensor>(context, robot, def, "odometry");
  if (sensor == nullptr) return nullptr;
  const sim::NumberForm form = sensor->number_form();
  if (form != sim::NumberForm::kOdometry && form != sim::NumberForm::kPose) return nullptr;
  // Who looks from above does not drive.
  const bool drives = def.index != 2;
  return std::make_shared<Position2d>(context, robot, static_cast<std::uint16_t>(def.index),
                                      *sensor, drives, Frequency(context, def));
}

template <typename Kind>
Made MakeScanner(const DeviceContext& context, const sim::Robot& robot, const DeviceDef& def) {
  const auto* const scanner = Find<sim::LaserScanner>(context, robot, def, "hokuyo");
  if (scanner == nullptr) return nullptr;
  return std::make_shared<Kind>(context, static_cast<std::uint16_t>(def.index), *scanner);
}

struct Maker {
  const char* interface_name;
  Made (*make)(const DeviceContext&, const sim::Robot&, const DeviceDef&);
};

constexpr std::array kMakers = {
    Maker{"position2d", &MakePosition2d},
    Maker{"laser", &MakeScanner<Laser>},
    Maker{"ranger", &MakeScanner<ScannerRanger>},
};

}  // namespace

std::shared_ptr<Device> MakeDevice(const DeviceContext& context, const sim::Robot& robot,
                                   const DeviceDef& def) {
  if (def.index < 0 || def.index > 0xffff) throw Error("a device's index is from 0 to 65535");
  for (const Maker& maker : kMakers) {
    if (def.interface_name == maker.interface_name) return maker.make(context, robot, def);
  }
  throw Error("no robot has the interface '" + def.interface_name + "'");
}

std::vector<DeviceDef> DefaultDevices() {
  return {{"position2d", 0, "odometry"}, {"position2d", 2, "pose"}, {"laser", 0}, {"ranger", 0}};
}

}  // namespace ccmorse::servers::player
