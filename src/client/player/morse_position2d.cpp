#include <cmath>
#include <mutex>

#include "base/trig.h"
#include "client/player/morse_model.h"
#include "libCCMorse/MorseOdometry.h"
#include "libCCMorse/MorsePose.h"
#include "libCCMorse/MorseRobot.h"
#include "wire/player/frame.h"

namespace CCMorse::playerlink {

namespace {

constexpr double kHeadingGain = 2.0;  // 1/s: turn rate for a heading error of 1 rad
constexpr double kTolerance = 0.05;   // m, around a goal

// The pose `b`, given in the frame `a`, in the frame that `a` is given in.
wire::Pose2d Compose(const wire::Pose2d& a, const wire::Pose2d& b) {
  const double s = std::sin(a.pa);
  const double c = std::cos(a.pa);
  return {a.px + c * b.px - s * b.py, a.py + s * b.px + c * b.py,
          ccmorse::NormalizeAngle(a.pa + b.pa)};
}

wire::Pose2d Inverse(const wire::Pose2d& a) {
  const double s = std::sin(a.pa);
  const double c = std::cos(a.pa);
  return {-c * a.px - s * a.py, s * a.px - c * a.py, -a.pa};
}

wire::Pose2d Flat(const player_pose3d_t& pose) { return {pose.px, pose.py, pose.pyaw}; }

bool Finite(const wire::Pose2d& pose) {
  return std::isfinite(pose.px) && std::isfinite(pose.py) && std::isfinite(pose.pa);
}

class Position2d final : public MorseModel {
 public:
  explicit Position2d(MorseDevice& source)
      : MorseModel(source),
        robot_(source.GetRobot()),
        pose_(dynamic_cast<MorsePose*>(&source)),
        odometry_(dynamic_cast<MorseOdometry*>(&source)),
        speeds_(odometry_ != nullptr ? odometry_ : robot_.FindDevice<MorseOdometry>()) {}

  bool Deliver(DataSink& sink, bool valid) override {
    wire::Position2dData data;
    data.pos = Pose();
    if (speeds_ != nullptr) {
      const player_pose3d_t speed = speeds_->GetSpeed();
      data.vel = {speed.px, speed.py, speed.pyaw};
      data.stall = speeds_->GetStall() ? 1 : 0;
    }
    return Send(sink, valid, PLAYER_POSITION2D_DATA_STATE, wire::Body::Of(data));
  }

  void Command(std::uint8_t subtype, const wire::Body& body) override {
    {
      const std::lock_guard lock(mutex_);
      if (!motors_on_) return;
    }
    wire::Position2dCmdVel speeds;
    wire::Position2dCmdPos goal;
    wire::Position2dCmdCar car;
    wire::Position2dCmdVelHead heading;
    // A robot with two wheels cannot go sideways, so that speed is dropped.
    if (subtype == PLAYER_POSITION2D_CMD_VEL && body.To(speeds)) {
      robot_.SetSpeed(speeds.vel.px, speeds.vel.pa);
    } else if (subtype == PLAYER_POSITION2D_CMD_POS && body.To(goal)) {
      GoTo(goal);
    } else if (subtype == PLAYER_POSITION2D_CMD_CAR && body.To(car)) {
      robot_.SetSpeed(car.velocity, car.velocity * std::tan(car.angle) / WheelTrack());
    } else if (subtype == PLAYER_POSITION2D_CMD_VEL_HEAD && body.To(heading)) {
      robot_.SetSpeed(heading.velocity,
                      kHeadingGain * ccmorse::NormalizeAngle(heading.angle - Pose().pa));
    }
  }

  Answer Request(std::uint8_t subtype, const wire::Body& body, const TakeReply& take) override {
    wire::Position2dPowerConfig power;
    wire::Position2dSetOdomReq odometry;
    switch (subtype) {
      case PLAYER_POSITION2D_REQ_GET_GEOM:
        return GetGeometry(take);
      case PLAYER_POSITION2D_REQ_MOTOR_POWER:
        if (!body.To(power)) return Refused();
        {
          const std::lock_guard lock(mutex_);
          motors_on_ = power.state != 0;
        }
        if (power.state == 0) robot_.Stop();
        return {};
      case PLAYER_POSITION2D_REQ_SET_ODOM:
        if (!body.To(odometry)) return Refused();
        SetOdometry(odometry.pose);
        return {};
      case PLAYER_POSITION2D_REQ_RESET_ODOM:
        SetOdometry({});
        return {};
      case PLAYER_POSITION2D_REQ_VELOCITY_MODE:
      case PLAYER_POSITION2D_REQ_POSITION_MODE:
        return {};  // either works at any time
      case wire::kCapabilities: {
        wire::CapabilitiesReq asked;
        const bool known = body.To(asked) && asked.type == PLAYER_MSGTYPE_CMD &&
                           asked.subtype >= PLAYER_POSITION2D_CMD_VEL &&
                           asked.subtype <= PLAYER_POSITION2D_CMD_VEL_HEAD;
        return known ? Answer() : Refused();
      }
      default:
        return Refused();
    }
  }

  bool TakeChanged() override {
    const std::lock_guard lock(mutex_);
    return std::exchange(changed_, false);
  }

 private:
  // Of the device, so that a proxy that is made after a Read() sees the data that are there.
  wire::Pose2d RawPose(bool* has_data) const {
    *has_data = device().HasData();
    return Flat(pose_ != nullptr ? pose_->GetPose() : odometry_->GetPose());
  }

  wire::Pose2d Pose() {
    bool has_data = false;
    const wire::Pose2d raw = RawPose(&has_data);
    const std::lock_guard lock(mutex_);
    if (awaited_) {
      if (!has_data) return *awaited_;
      frame_ = Compose(*awaited_, Inverse(raw));
      awaited_.reset();
    }
    // An unmoved frame changes no bit of what the sensor said.
    if (frame_ == wire::Pose2d()) return raw;
    return Compose(frame_, raw);
  }

  wire::Pose2d ToWorld(const wire::Pose2d& pose) {
    Pose();  // settles an awaited frame
    wire::Pose2d frame;
    {
      const std::lock_guard lock(mutex_);
      frame = frame_;
    }
    const wire::Pose2d raw = Compose(Inverse(frame), pose);
    if (pose_ != nullptr) return raw;
    // From the odometry's frame into the world, by where the robot is in both now.
    const auto* truth = robot_.FindDevice<MorsePose>();
    if (truth == nullptr || !truth->HasPose()) return raw;
    const wire::Pose2d start = Compose(Flat(truth->GetPose()), Inverse(Flat(odometry_->GetPose())));
    return Compose(start, raw);
  }

  void GoTo(const wire::Position2dCmdPos& command) {
    if (!Finite(command.pos)) {
      throw MorseError("a number of the goal is not finite", "Position2dProxy::GoTo()");
    }
    const wire::Pose2d goal = ToWorld(command.pos);
    robot_.SetGoal(goal.px, goal.py, kTolerance, command.vel.px);
  }

  double WheelTrack() const {
    constexpr char kFunction[] = "Position2dProxy::SetCarlike()";
    double track = 0.0;
    try {
      track = robot_.GetWheelTrack();
    } catch (const MorseError& error) {
      throw MorseError(error.GetErrorStr(), kFunction);
    }
    if (!(track > 0.0)) throw MorseError("the robot has no wheel track", kFunction);
    return track;
  }

  void SetOdometry(const wire::Pose2d& pose) {
    if (!Finite(pose)) {
      throw MorseError("a number of the pose is not finite", "Position2dProxy::SetOdometry()");
    }
    const std::lock_guard lock(mutex_);
    awaited_ = pose;
    changed_ = true;
  }

  Answer GetGeometry(const TakeReply& take) const {
    wire::Position2dGeom geom;
    try {
      const player_bbox3d_t size = robot_.GetSize();
      geom.size = {size.sw, size.sl, size.sh};
    } catch (const MorseError& error) {
      return Refused(error.GetErrorStr());
    }
    take(wire::Body::Of(geom));
    return {};
  }

  MorseRobot& robot_;
  MorsePose* const pose_;          // where positions come from: this one
  MorseOdometry* const odometry_;  // or this one
  MorseOdometry* const speeds_;    // may be missing

  std::mutex mutex_;
  bool motors_on_ = true;
  bool changed_ = false;
  std::optional<wire::Pose2d> awaited_;  // an odometry that was set before the first data
  wire::Pose2d frame_;                   // pose of the sensor's frame in ours
};

}  // namespace

std::shared_ptr<MorseModel> MakePosition2d(MorseDevice& source) {
  return std::make_shared<Position2d>(source);
}

}  // namespace CCMorse::playerlink
