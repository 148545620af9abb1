#include "servers/player/devices/scanner.h"

#include <cmath>

#include "base/trig.h"
#include "sim/robots/robot.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

constexpr double kLaserStep = 0.001;             // m, the resolution that is told: a real scanner's
constexpr wire::Bbox3d kSize{0.07, 0.07, 0.05};  // m, of a Hokuyo (specs: syrotek.md A)

const scene::LaserDef& Def(const sim::LaserScanner& scanner) { return scanner.robot().def().laser; }

struct Angles {
  double min, max, step;  // rad
};

Angles AnglesOf(const scene::LaserDef& def) {
  const double min = -Radians(def.scan_window_deg) / 2.0;
  const double step = Radians(def.resolution_deg);
  return {min, min + step * (def.samples - 1), step};
}

// The layer that looks least up or down.
std::size_t FirstBeam(const scene::LaserDef& def) {
  return static_cast<std::size_t>(def.layers / 2) * static_cast<std::size_t>(def.samples);
}

wire::Pose3d PoseOf(const scene::LaserDef& def) {
  return {def.position.x, def.position.y, def.position.z, def.roll, def.pitch, def.yaw};
}

bool Near(double a, double b) { return std::fabs(a - b) <= 1e-3 * std::fmax(1.0, std::fabs(b)); }

}  // namespace

Laser::Laser(DeviceContext context, std::uint16_t index, const sim::LaserScanner& scanner)
    : Device(wire::kLaser, index, "ccmorse",
             {{MessageType::kData, wire::kLaserDataScan},
              {MessageType::kRequest, wire::kLaserReqGetGeom},
              {MessageType::kRequest, wire::kLaserReqGetConfig},
              {MessageType::kRequest, wire::kLaserReqSetConfig},
              {MessageType::kRequest, wire::kLaserReqPower},
              {MessageType::kRequest, wire::kLaserReqGetId}}),
      context_(context),
      scanner_(scanner) {
  const scene::LaserDef& def = Def(scanner);
  const Angles angles = AnglesOf(def);
  data_.min_angle = angles.min;
  data_.max_angle = angles.max;
  data_.resolution = angles.step;
  data_.max_range = def.range;
  data_.intensity.resize(static_cast<std::size_t>(def.samples));
}

void Laser::Step() {
  if (scanner_.samples() == samples_ || context_.simulation.tick() == 0) return;
  samples_ = scanner_.samples();
  const auto first =
      scanner_.ranges().begin() + static_cast<std::ptrdiff_t>(FirstBeam(Def(scanner_)));
  data_.ranges.assign(first, first + Def(scanner_).samples);
  data_.id = static_cast<std::uint32_t>(samples_);
  context_.directory.sample_use().Count(scanner_);
  Publish(wire::kLaserDataScan, scanner_.timestamp(), wire::Body::Of(data_));
}

bool Laser::Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) {
  const scene::LaserDef& def = Def(scanner_);
  switch (subtype) {
    case wire::kLaserReqGetGeom: {
      wire::LaserGeom geometry;
      geometry.pose = PoseOf(def);
      geometry.size = kSize;
      reply.Set(geometry);
      return body.empty();
    }
    case wire::kLaserReqGetConfig: {
      const Angles angles = AnglesOf(def);
      wire::LaserConfig config;
      config.min_angle = angles.min;
      config.max_angle = angles.max;
      config.resolution = angles.step;
      config.max_range = def.range;
      config.range_res = kLaserStep;
      config.scanning_frequency = def.frequency;
      reply.Set(config);
      return body.empty();
    }
    case wire::kLaserReqSetConfig: {
      wire::LaserConfig wanted;
      const Angles angles = AnglesOf(def);
      return body.To(wanted) && Near(wanted.min_angle, angles.min) &&
             Near(wanted.max_angle, angles.max) && Near(wanted.resolution, angles.step) &&
             Near(wanted.max_range, def.range) && Near(wanted.scanning_frequency, def.frequency);
    }
    case wire::kLaserReqPower: {
      wire::LaserPowerConfig wanted;
      return body.To(wanted);
    }
    case wire::kLaserReqGetId:
      reply.Set(wire::LaserGetIdConfig{1});
      return body.empty();
    default:
      return false;
  }
}

ScannerRanger::ScannerRanger(DeviceContext context, std::uint16_t index,
                             const sim::LaserScanner& scanner)
    : Device(wire::kRanger, index, "ccmorse",
             {{MessageType::kData, wire::kRangerDataRange},
              {MessageType::kData, wire::kRangerDataIntns},
              {MessageType::kRequest, wire::kRangerReqGetGeom},
              {MessageType::kRequest, wire::kRangerReqPower},
              {MessageType::kRequest, wire::kRangerReqIntns},
              {MessageType::kRequest, wire::kRangerReqSetConfig},
              {MessageType::kRequest, wire::kRangerReqGetConfig}}),
      context_(context),
      scanner_(scanner) {}

void ScannerRanger::Step() {
  if (scanner_.samples() == samples_ || context_.simulation.tick() == 0) return;
  samples_ = scanner_.samples();
  const auto first =
      scanner_.ranges().begin() + static_cast<std::ptrdiff_t>(FirstBeam(Def(scanner_)));
  data_.ranges.assign(first, first + Def(scanner_).samples);
  context_.directory.sample_use().Count(scanner_);
  Publish(wire::kRangerDataRange, scanner_.timestamp(), wire::Body::Of(data_));
  if (!intensities_) return;
  wire::RangerDataIntns intensities;
  intensities.intensities.resize(data_.ranges.size());
  Publish(wire::kRangerDataIntns, scanner_.timestamp(), wire::Body::Of(intensities));
}

bool ScannerRanger::Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) {
  const scene::LaserDef& def = Def(scanner_);
  const Angles angles = AnglesOf(def);
  switch (subtype) {
    case wire::kRangerReqGetGeom: {
      wire::RangerGeom geometry;
      geometry.pose = PoseOf(def);
      geometry.size = kSize;
      // In the ranger's own frame.
      geometry.element_poses.emplace_back();
      geometry.element_sizes.push_back(kSize);
      reply.Set(std::move(geometry));
      return body.empty();
    }
    case wire::kRangerReqGetConfig: {
      wire::RangerConfig config;
      config.min_angle = angles.min;
      config.max_angle = angles.max;
      config.angular_res = angles.step;
      config.max_range = def.range;
      config.range_res = kLaserStep;
      config.frequency = def.frequency;
      reply.Set(config);
      return body.empty();
    }
    case wire::kRangerReqSetConfig: {
      wire::RangerConfig wanted;
      return body.To(wanted) && Near(wanted.min_angle, angles.min) &&
             Near(wanted.max_angle, angles.max) && Near(wanted.angular_res, angles.step) &&
             Near(wanted.max_range, def.range) && Near(wanted.frequency, def.frequency);
    }
    case wire::kRangerReqPower: {
      wire::RangerPowerConfig wanted;
      return body.To(wanted);
    }
    case wire::kRangerReqIntns: {
      wire::RangerIntnsConfig wanted;
      if (!body.To(wanted)) return false;
      intensities_ = wanted.state != 0;
      return true;
    }
    default:
      return false;
  }
}

}  // namespace ccmorse::servers::player
