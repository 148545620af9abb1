#include "servers/player/devices/ring.h"

#include "base/trig.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

constexpr wire::Bbox3d kElementSize{0.01, 0.01, 0.01};  // m
constexpr double kRangeStep = 0.001;                    // m, the resolution that is told

Device::Capabilities CapabilitiesOf(std::uint16_t interface_code) {
  static const Device::Capabilities kOfSonar = {{MessageType::kData, wire::kSonarDataRanges},
                                                {MessageType::kRequest, wire::kSonarReqGetGeom},
                                                {MessageType::kRequest, wire::kSonarReqPower}};
  static const Device::Capabilities kOfIr = {{MessageType::kData, wire::kIrDataRanges},
                                             {MessageType::kRequest, wire::kIrReqPose},
                                             {MessageType::kRequest, wire::kIrReqPower}};
  static const Device::Capabilities kOfRanger = {
      {MessageType::kData, wire::kRangerDataRange},
      {MessageType::kRequest, wire::kRangerReqGetGeom},
      {MessageType::kRequest, wire::kRangerReqPower},
      {MessageType::kRequest, wire::kRangerReqGetConfig}};
  return interface_code == wire::kSonar ? kOfSonar
         : interface_code == wire::kIr  ? kOfIr
                                        : kOfRanger;
}

}  // namespace

Ring::Ring(DeviceContext context, std::uint16_t interface_code, std::uint16_t index,
           const sim::RangeRing& ring)
    : Device(interface_code, index, "ccmorse", CapabilitiesOf(interface_code)),
      context_(context),
      ring_(ring),
      settings_(ring.Configurations()) {}

void Ring::Step() {
  if (ring_.samples() == samples_ || context_.simulation.tick() == 0) return;
  samples_ = ring_.samples();
  switch (interface_code()) {
    case wire::kSonar: {
      const wire::SonarData data{ring_.ranges()};
      return Publish(wire::kSonarDataRanges, ring_.timestamp(), wire::Body::Of(data));
    }
    case wire::kIr: {
      wire::IrData data;
      data.ranges = ring_.ranges();
      data.voltages.resize(data.ranges.size());
      return Publish(wire::kIrDataRanges, ring_.timestamp(), wire::Body::Of(data));
    }
    default: {
      const wire::RangerDataRange data{ring_.ranges()};
      return Publish(wire::kRangerDataRange, ring_.timestamp(), wire::Body::Of(data));
    }
  }
}

bool Ring::Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) {
  switch (interface_code()) {
    case wire::kSonar:
      return AskSonar(subtype, body, reply);
    case wire::kIr:
      return AskIr(subtype, body, reply);
    default:
      return AskRanger(subtype, body, reply);
  }
}

bool Ring::AskSonar(std::uint8_t subtype, const wire::Body& body, Reply& reply) const {
  if (subtype == wire::kSonarReqPower) {
    wire::SonarPowerConfig wanted;
    return body.To(wanted);
  }
  reply.Set(wire::SonarGeom{Poses()});
  return body.empty();
}

bool Ring::AskIr(std::uint8_t subtype, const wire::Body& body, Reply& reply) const {
  if (subtype == wire::kIrReqPower) {
    wire::IrPowerReq wanted;
    return body.To(wanted);
  }
  reply.Set(wire::IrPose{Poses()});
  return body.empty();
}

bool Ring::AskRanger(std::uint8_t subtype, const wire::Body& body, Reply& reply) const {
  switch (subtype) {
    case wire::kRangerReqPower: {
      wire::RangerPowerConfig wanted;
      return body.To(wanted);
    }
    case wire::kRangerReqGetGeom: {
      wire::RangerGeom geometry;
      geometry.element_poses = Poses();
      geometry.element_sizes.assign(geometry.element_poses.size(), kElementSize);
      const scene::RobotModel& model = ring_.robot().model();
      geometry.size = {model.width, model.length, kElementSize.sh};
      reply.Set(std::move(geometry));
      return body.empty();
    }
    default: {
      // Of one element, whose beam is a cone.
      const double cone = Radians(Setting("cone_deg"));
      wire::RangerConfig config;
      config.min_angle = -cone / 2.0;
      config.max_angle = cone / 2.0;
      config.angular_res = cone;
      config.min_range = Setting("min_range");
      config.max_range = Setting("range");
      config.range_res = kRangeStep;
      config.frequency = Setting("frequency");
      reply.Set(config);
      return body.empty();
    }
  }
}

std::vector<wire::Pose3d> Ring::Poses() const {
  std::vector<wire::Pose3d> poses;
  for (const Json& each : settings_.Find("poses")->AsArray()) {
    const Json::Array& pose = each.AsArray();
    poses.push_back(
        {pose[0].AsDouble(), pose[1].AsDouble(), pose[2].AsDouble(), 0.0, 0.0, pose[3].AsDouble()});
  }
  return poses;
}

double Ring::Setting(const char* name) const { return settings_.Find(name)->AsDouble(); }

}  // namespace ccmorse::servers::player
