#include "client/player/morse_model.h"
#include "libCCMorse/MorseLaser.h"
#include "libCCMorse/MorsePose.h"
#include "libCCMorse/MorseRobot.h"

namespace CCMorse::playerlink {

namespace {

constexpr double kScannerSize = 0.15;  // m, what Player assumes

wire::Pose3d Mounting(const MorseLaser& laser) {
  const player_pose3d_t pose = laser.GetMounting();
  return {pose.px, pose.py, pose.pz, pose.proll, pose.ppitch, pose.pyaw};
}

class Laser final : public MorseModel {
 public:
  explicit Laser(MorseDevice& scanner)
      : MorseModel(scanner),
        laser_(dynamic_cast<MorseLaser&>(scanner)),
        pose_(scanner.GetRobot().FindDevice<MorsePose>()) {}

  bool Deliver(DataSink& sink, bool valid) override {
    thread_local wire::LaserDataScanpose posed;  // keeps its memory
    wire::LaserData& scan = posed.scan;
    scan.min_angle = laser_.GetMinAngle();
    scan.max_angle = laser_.GetMaxAngle();
    scan.resolution = laser_.GetResolution();
    scan.max_range = laser_.GetMaxRange();
    laser_.CopyRanges(scan.ranges);
    if (pose_ == nullptr) {
      return Send(sink, valid, PLAYER_LASER_DATA_SCAN, wire::Body::Of(scan));
    }
    const player_pose3d_t robot = pose_->GetPose();
    posed.pose = {robot.px, robot.py, robot.pyaw};
    return Send(sink, valid, PLAYER_LASER_DATA_SCANPOSE, wire::Body::Of(posed));
  }

  void Command(std::uint8_t /*subtype*/, const wire::Body& /*body*/) override {}

  Answer Request(std::uint8_t subtype, const wire::Body& /*body*/, const TakeReply& take) override {
    switch (subtype) {
      case PLAYER_LASER_REQ_GET_CONFIG: {
        wire::LaserConfig config;
        config.min_angle = laser_.GetMinAngle();
        config.max_angle = laser_.GetMaxAngle();
        config.resolution = laser_.GetResolution();
        config.max_range = laser_.GetMaxRange();
        config.scanning_frequency = laser_.GetFrequency();
        take(wire::Body::Of(config));
        return {};
      }
      case PLAYER_LASER_REQ_GET_GEOM:
        take(wire::Body::Of(wire::LaserGeom{Mounting(laser_), {kScannerSize, kScannerSize, 0.0}}));
        return {};
      case PLAYER_LASER_REQ_SET_CONFIG:
        return Refused("not supported by this device: its settings stand in the scene");
      default:
        return Refused();
    }
  }

 private:
  const MorseLaser& laser_;
  const MorsePose* const pose_;  // may be missing
};

class Ranger final : public MorseModel {
 public:
  explicit Ranger(MorseDevice& scanner)
      : MorseModel(scanner), laser_(dynamic_cast<MorseLaser&>(scanner)) {}

  bool Deliver(DataSink& sink, bool valid) override {
    thread_local wire::RangerDataRange data;  // keeps its memory
    laser_.CopyRanges(data.ranges);
    return Send(sink, valid, PLAYER_RANGER_DATA_RANGE, wire::Body::Of(data));
  }

  void Command(std::uint8_t /*subtype*/, const wire::Body& /*body*/) override {}

  Answer Request(std::uint8_t subtype, const wire::Body& /*body*/, const TakeReply& take) override {
    switch (subtype) {
      case PLAYER_RANGER_REQ_GET_CONFIG: {
        wire::RangerConfig config;
        config.min_angle = laser_.GetMinAngle();
        config.max_angle = laser_.GetMaxAngle();
        config.angular_res = laser_.GetResolution();
        config.max_range = laser_.GetMaxRange();
        config.frequency = laser_.GetFrequency();
        take(wire::Body::Of(config));
        return {};
      }
      case PLAYER_RANGER_REQ_GET_GEOM: {
        const wire::Bbox3d size{kScannerSize, kScannerSize, 0.0};
        take(wire::Body::Of(wire::RangerGeom{Mounting(laser_), size, {wire::Pose3d()}, {size}}));
        return {};
      }
      case PLAYER_RANGER_REQ_SET_CONFIG:
        return Refused("not supported by this device: its settings stand in the scene");
      default:
        return Refused();
    }
  }

 private:
  const MorseLaser& laser_;
};

}  // namespace

std::shared_ptr<MorseModel> MakeLaser(MorseDevice& scanner) {
  return std::make_shared<Laser>(scanner);
}

std::shared_ptr<MorseModel> MakeRanger(MorseDevice& scanner) {
  return std::make_shared<Ranger>(scanner);
}

}  // namespace CCMorse::playerlink
