#include "servers/player/drivers/range_converters.h"

#include <algorithm>

#include "base/error.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

}  // namespace

RangerToLaser::RangerToLaser(const DriverDef& def, const DeviceContext& /*context*/,
                             const DeviceList& devices)
    : Driver(def, devices), ranger_(Require(wire::kRanger)) {
  laser_ = Provide(wire::kLaser, {{MessageType::kData, wire::kLaserDataScan},
                                  {MessageType::kRequest, wire::kLaserReqGetGeom},
                                  {MessageType::kRequest, wire::kLaserReqGetConfig},
                                  {MessageType::kRequest, wire::kLaserReqPower}});
  if (laser_ == nullptr) throw Error("driver rangertolaser provides a laser");
}

bool RangerToLaser::ReadConfig() {
  Reply reply;
  return ranger_.Request(wire::kRangerReqGetConfig, {}, reply) && reply.body().To(config_);
}

void RangerToLaser::Started() { ReadConfig(); }

void RangerToLaser::Data(const DataMessage& message) {
  wire::RangerDataRange ranges;
  if (message.subtype() != wire::kRangerDataRange || !message.body().To(ranges)) return;
  data_.min_angle = config_.min_angle;
  data_.max_angle = config_.max_angle;
  data_.resolution = config_.angular_res;
  data_.max_range = config_.max_range;
  data_.ranges = std::move(ranges.ranges);
  for (double& range : data_.ranges) range = std::max(range, 0.0);  // H7
  data_.intensity.assign(data_.ranges.size(), 0);
  ++data_.id;
  laser_->Publish(wire::kLaserDataScan, message.time(), wire::Body::Of(data_));
}

bool RangerToLaser::Ask(Provided& /*device*/, std::uint8_t subtype, const wire::Body& body,
                        Reply& reply) {
  switch (subtype) {
    case wire::kLaserReqGetGeom: {
      Reply answer;
      wire::RangerGeom geometry;
      if (!body.empty() || !ranger_.Request(wire::kRangerReqGetGeom, {}, answer) ||
          !answer.body().To(geometry)) {
        return false;
      }
      wire::LaserGeom same;
      same.pose = geometry.pose;
      same.size = geometry.size;
      reply.Set(same);
      return true;
    }
    case wire::kLaserReqGetConfig: {
      if (!body.empty() || !ReadConfig()) return false;
      wire::LaserConfig same;
      same.min_angle = config_.min_angle;
      same.max_angle = config_.max_angle;
      same.resolution = config_.angular_res;
      same.max_range = config_.max_range;
      same.range_res = config_.range_res;
      same.scanning_frequency = config_.frequency;
      reply.Set(same);
      return true;
    }
    default: {
      wire::LaserPowerConfig wanted;
      return body.To(wanted);
    }
  }
}

LaserToRanger::LaserToRanger(const DriverDef& def, const DeviceContext& /*context*/,
                             const DeviceList& devices)
    : Driver(def, devices), laser_(Require(wire::kLaser)) {
  ranger_ = Provide(wire::kRanger, {{MessageType::kData, wire::kRangerDataRange},
                                    {MessageType::kRequest, wire::kRangerReqGetGeom},
                                    {MessageType::kRequest, wire::kRangerReqGetConfig},
                                    {MessageType::kRequest, wire::kRangerReqPower}});
  if (ranger_ == nullptr) throw Error("driver lasertoranger provides a ranger");
}

void LaserToRanger::Data(const DataMessage& message) {
  wire::LaserData scan;
  if (message.subtype() != wire::kLaserDataScan || !message.body().To(scan)) return;
  const wire::RangerDataRange data{std::move(scan.ranges)};
  ranger_->Publish(wire::kRangerDataRange, message.time(), wire::Body::Of(data));
}

bool LaserToRanger::Ask(Provided& /*device*/, std::uint8_t subtype, const wire::Body& body,
                        Reply& reply) {
  switch (subtype) {
    case wire::kRangerReqGetGeom: {
      Reply answer;
      wire::LaserGeom geometry;
      if (!body.empty() || !laser_.Request(wire::kLaserReqGetGeom, {}, answer) ||
          !answer.body().To(geometry)) {
        return false;
      }
      wire::RangerGeom same;
      same.pose = geometry.pose;
      same.size = geometry.size;
      same.element_poses.emplace_back();
      same.element_sizes.push_back(geometry.size);
      reply.Set(std::move(same));
      return true;
    }
    case wire::kRangerReqGetConfig: {
      Reply answer;
      wire::LaserConfig config;
      if (!body.empty() || !laser_.Request(wire::kLaserReqGetConfig, {}, answer) ||
          !answer.body().To(config)) {
        return false;
      }
      wire::RangerConfig same;
      same.min_angle = config.min_angle;
      same.max_angle = config.max_angle;
      same.angular_res = config.resolution;
      same.max_range = config.max_range;
      same.range_res = config.range_res;
      same.frequency = config.scanning_frequency;
      reply.Set(same);
      return true;
    }
    default: {
      wire::RangerPowerConfig wanted;
      return body.To(wanted);
    }
  }
}

}  // namespace ccmorse::servers::player
