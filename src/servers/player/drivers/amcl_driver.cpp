#include "servers/player/drivers/amcl_driver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/log.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "servers/player/drivers/map_reader.h"
#include "servers/player/pose2d.h"

namespace ccmorse::servers::player {
namespace {

using navigation::Amcl;
using navigation::AmclHypothesis;
using navigation::AmclOptions;
using wire::MessageType;

AmclOptions ReadOptions(const DriverOptions& options, std::uint64_t seed) {
  AmclOptions amcl;
  const auto number = [&](const char* name, double& to) { to = options.Number(name, to); };
  amcl.odom_init = options.Flag("odom_init", amcl.odom_init);
  amcl.pf_min_samples = options.Integer("pf_min_samples", amcl.pf_min_samples);
  amcl.pf_max_samples = options.Integer("pf_max_samples", amcl.pf_max_samples);
  number("pf_err", amcl.pf_err);
  number("pf_z", amcl.pf_z);
  std::array<double, 3> pose{};
  options.Tuple("init_pose", "lla", pose);
  amcl.init_pose = {pose[0], pose[1], pose[2]};
  options.Tuple("init_pose_var", "lla", amcl.init_pose_var);
  options.Tuple("update_thresh", "la", amcl.update_thresh);
  for (std::size_t i = 0; i < amcl.odom_drift.size(); ++i) {
    options.Tuple("odom_drift[" + std::to_string(i) + "]", "fff", amcl.odom_drift[i]);
  }
  amcl.laser_max_beams = options.Integer("laser_max_beams", amcl.laser_max_beams);
  amcl.laser_range_max = options.Length("laser_range_max", amcl.laser_range_max);
  amcl.laser_range_var = options.Length("laser_range_var", amcl.laser_range_var);
  number("laser_range_bad", amcl.laser_range_bad);
  amcl.seed = seed;
  // Complains now of what it cannot work with, not when the map is there.
  const Amcl check(navigation::OccupancyGrid(1, 1, 1.0), amcl);
  return amcl;
}

// `pose`, given in the frame of `from`, moved along with that frame to `to`.
Pose2 MovedAlong(const Pose2& pose, const Pose2& from, const Pose2& to) {
  // The move as the robot makes it, which is what all hypotheses have in common.
  const Vec2 way = InverseTransform(from, {to.x, to.y});
  const Vec2 there = Transform(pose, way);
  return {there.x, there.y, NormalizeAngle(pose.yaw + to.yaw - from.yaw)};
}

}  // namespace

AmclDriver::AmclDriver(const DriverDef& def, const DeviceContext& context,
                       const DeviceList& devices)
    : Driver(def, devices),
      options_(ReadOptions(def.options, context.simulation.scenario().seed)),
      odometry_(Require(wire::kPosition2d, "odometry")),
      laser_(Require(wire::kLaser)),
      map_(Require(wire::kMap, "laser")) {
  if (def.options.Find("laser_pose") != nullptr) {
    std::array<double, 3> pose{};
    def.options.Tuple("laser_pose", "lla", pose);
    laser_pose_ = Pose2{pose[0], pose[1], pose[2]};
  }
  localize_ = Provide(wire::kLocalize, {{MessageType::kData, wire::kLocalizeDataHypoths},
                                        {MessageType::kRequest, wire::kLocalizeReqSetPose},
                                        {MessageType::kRequest, wire::kLocalizeReqGetParticles}});
  position_ = Provide(wire::kPosition2d, {{MessageType::kData, wire::kPosition2dDataState},
                                          {MessageType::kRequest, wire::kPosition2dReqGetGeom}});
  if (localize_ == nullptr && position_ == nullptr) {
    throw Error("driver amcl provides a localize or a position2d");
  }
}

void AmclDriver::Started() {
  driven_.reset();
  amcl_.reset();
  auto map = ReadMap(map_);
  if (map) {
    amcl_.emplace(std::move(*map), options_);
  } else {
    LogWarning("driver amcl: map:{} gives no map to be found on", map_.index());
  }
  Reply reply;
  wire::LaserGeom geometry;
  if (laser_pose_) {
    mount_ = *laser_pose_;
  } else if (laser_.Request(wire::kLaserReqGetGeom, {}, reply) && reply.body().To(geometry)) {
    mount_ = {geometry.pose.px, geometry.pose.py, geometry.pose.pyaw};
  }
}

void AmclDriver::Data(const DataMessage& message) {
  if (&message.device() == &odometry_) {
    wire::Position2dData data;
    if (message.subtype() == wire::kPosition2dDataState && message.body().To(data)) driven_ = data;
    return;
  }
  wire::LaserData scan;
  if (&message.device() != &laser_ || message.subtype() != wire::kLaserDataScan ||
      !message.body().To(scan) || !amcl_ || !driven_) {
    return;
  }
  amcl_->Step({driven_->pos.px, driven_->pos.py, driven_->pos.pa},
              {scan.min_angle, scan.resolution, scan.max_range, scan.ranges, mount_});
  Publish(message.time());
}

void AmclDriver::Publish(double time) {
  const Pose2 best = amcl_->BestPose();
  if (localize_ != nullptr) {
    wire::LocalizeData data;
    data.pending_time = time;
    for (const AmclHypothesis& each : amcl_->hypotheses()) {
      wire::LocalizeHypoth& hypothesis = data.hypoths.emplace_back();
      hypothesis.mean = ToWire(MovedAlong(each.mean, amcl_->hypotheses().front().mean, best));
      hypothesis.cov = each.covariance;
      hypothesis.alpha = each.weight;
    }
    localize_->Publish(wire::kLocalizeDataHypoths, time, wire::Body::Of(data));
  }
  if (position_ != nullptr) {
    wire::Position2dData data = *driven_;
    data.pos = ToWire(best);
    position_->Publish(wire::kPosition2dDataState, time, wire::Body::Of(data));
  }
}

bool AmclDriver::SetPose(const wire::Body& body) {
  wire::LocalizeSetPose wanted;
  if (!amcl_ || !body.To(wanted) || !IsFinite(wanted.mean)) return false;
  std::array<double, 3> deviation{};
  for (std::size_t i = 0; i < deviation.size(); ++i) {
    // xx, yy, aa come first; how they hang together has no effect.
    if (!std::isfinite(wanted.cov[i]) || wanted.cov[i] < 0.0) return false;
    deviation[i] = std::sqrt(wanted.cov[i]);
  }
  amcl_->SetPose({wanted.mean.px, wanted.mean.py, wanted.mean.pa}, deviation);
  return true;
}

bool AmclDriver::Ask(Provided& device, std::uint8_t subtype, const wire::Body& body, Reply& reply) {
  if (&device == position_) return odometry_.Request(subtype, body, reply);
  if (subtype == wire::kLocalizeReqSetPose) return SetPose(body);
  if (!amcl_ || !body.empty()) return false;
  wire::LocalizeGetParticles answer;
  answer.mean = ToWire(amcl_->BestPose());
  for (const navigation::AmclParticle& each : amcl_->particles()) {
    answer.particles.push_back({ToWire(each.pose), each.weight});
    answer.variance += each.weight * (std::pow(each.pose.x - answer.mean.px, 2.0) +
                                      std::pow(each.pose.y - answer.mean.py, 2.0));
  }
  reply.Set(std::move(answer));
  return true;
}

}  // namespace ccmorse::servers::player
