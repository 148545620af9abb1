#include "servers/player/device_factory.h"

#include <array>

#include "base/error.h"
#include "servers/player/devices/body_sensors.h"
#include "servers/player/devices/graphics2d.h"
#include "servers/player/devices/map_device.h"
#include "servers/player/devices/messages.h"
#include "servers/player/devices/position2d.h"
#include "servers/player/devices/ring.h"
#include "servers/player/devices/scanner.h"
#include "servers/player/devices/sight.h"
#include "servers/player/devices/simulation_device.h"

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

std::uint16_t Index(const DeviceDef& def) { return static_cast<std::uint16_t>(def.index); }

using Made = std::shared_ptr<Device>;

Made MakePosition2d(const DeviceContext& context, const sim::Robot& robot, const DeviceDef& def) {
  const auto* const sensor = Find<sim::Sensor>(context, robot, def, "odometry");
  if (sensor == nullptr) return nullptr;
  const sim::NumberForm form = sensor->number_form();
  if (form != sim::NumberForm::kOdometry && form != sim::NumberForm::kPose) return nullptr;
  return std::make_shared<Position2d>(context, robot, Index(def), *sensor, def.drives,
                                      Frequency(context, def));
}

Made MakeLaser(const DeviceContext& context, const sim::Robot& robot, const DeviceDef& def) {
  const auto* const scanner = Find<sim::LaserScanner>(context, robot, def, "hokuyo");
  if (scanner == nullptr) return nullptr;
  return std::make_shared<Laser>(context, Index(def), *scanner);
}

Made MakeRing(const DeviceContext& context, const sim::Robot& robot, const DeviceDef& def,
              std::uint16_t interface_code, const char* usual) {
  const auto* const ring = Find<sim::RangeRing>(context, robot, def, usual);
  if (ring == nullptr) return nullptr;
  return std::make_shared<Ring>(context, interface_code, Index(def), *ring);
}

Made MakeSonar(const DeviceContext& context, const sim::Robot& robot, const DeviceDef& def) {
  return MakeRing(context, robot, def, wire::kSonar, "sonar");
}

Made MakeIr(const DeviceContext& context, const sim::Robot& robot, const DeviceDef& def) {
  return MakeRing(context, robot, def, wire::kIr, "ir");
}

Made MakeRanger(const DeviceContext& context, const sim::Robot& robot, const DeviceDef& def) {
  const auto* const scanner = Find<sim::LaserScanner>(context, robot, def, "hokuyo");
  if (scanner == nullptr) return MakeRing(context, robot, def, wire::kRanger, "hokuyo");
  return std::make_shared<ScannerRanger>(context, Index(def), *scanner);
}

// Devices of a robot's body, published at a rate.
template <typename Kind>
Made MakeOfBody(const DeviceContext& context, const sim::Robot& robot, const DeviceDef& def) {
  return std::make_shared<Kind>(context, robot, Index(def), Frequency(context, def));
}

// Devices of the world, which are the same for each robot.
template <typename Kind>
Made MakeOfWorld(const DeviceContext& context, const sim::Robot& /*robot*/, const DeviceDef& def) {
  return std::make_shared<Kind>(context, Index(def));
}

Made MakeGraphics2d(const DeviceContext& context, const sim::Robot& robot, const DeviceDef& def) {
  return std::make_shared<Graphics2d>(context, robot, Index(def));
}

Made MakeSpeech(const DeviceContext& /*context*/, const sim::Robot& robot, const DeviceDef& def) {
  return std::make_shared<Speech>(robot.name(), Index(def));
}

struct Maker {
  const char* interface_name;
  Made (*make)(const DeviceContext&, const sim::Robot&, const DeviceDef&);
};

constexpr std::array kMakers = {
    Maker{"position2d", &MakePosition2d},
    Maker{"laser", &MakeLaser},
    Maker{"ranger", &MakeRanger},
    Maker{"sonar", &MakeSonar},
    Maker{"ir", &MakeIr},
    Maker{"bumper", &MakeOfBody<Bumper>},
    Maker{"power", &MakeOfWorld<Power>},
    Maker{"blobfinder", &MakeOfBody<Blobfinder>},
    Maker{"fiducial", &MakeOfBody<Fiducial>},
    Maker{"graphics2d", &MakeGraphics2d},
    Maker{"speech", &MakeSpeech},
    Maker{"simulation", &MakeOfWorld<SimulationDevice>},
    Maker{"map", &MakeOfWorld<MapDevice>},
    Maker{"opaque", &MakeOfWorld<Opaque>},
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
  const auto of = [](const char* interface_name, int index, const char* source = "") {
    return DeviceDef{interface_name, index, source};
  };
  DeviceDef from_above = of("position2d", 2, "pose");
  from_above.drives = false;
  return {of("position2d", 0, "odometry"),
          from_above,
          of("laser", 0),
          of("ranger", 0, "hokuyo"),
          of("sonar", 0),
          of("ranger", 1, "sonar"),
          of("ir", 0),
          of("ranger", 2, "ir"),
          of("bumper", 0),
          of("power", 0),
          of("blobfinder", 0),
          of("fiducial", 0),
          of("graphics2d", 0),
          of("graphics2d", 1),
          of("speech", 0),
          of("simulation", 0),
          of("map", 0),
          of("opaque", 0)};
}

}  // namespace ccmorse::servers::player
