#include <cmath>

#include "base/trig.h"
#include "client/player/proxy_lookup.h"
#include "libCCMorse/MorseOdometry.h"
#include "libCCMorse/MorsePose.h"
#include "libCCMorse/Position2dProxy.h"

namespace CCMorse {

namespace {

constexpr double kHeadingGain = 2.0;  // 1/s: turn rate for a heading error of 1 rad

bool IsPosition(const MorseDevice& device) {
  return dynamic_cast<const MorsePose*>(&device) != nullptr ||
         dynamic_cast<const MorseOdometry*>(&device) != nullptr;
}

// Without a table of proxies, the true pose stands for a robot; odometry is the second choice.
bool IsFirstChoice(const MorseDevice& device) {
  if (dynamic_cast<const MorsePose*>(&device)) return true;
  return dynamic_cast<const MorseOdometry*>(&device) != nullptr &&
         device.GetRobot().FindDevice<MorsePose>() == nullptr;
}

// The pose `b`, given in the frame `a`, in the frame that `a` is given in.
player_pose2d_t Compose(const player_pose2d_t& a, const player_pose2d_t& b) {
  const double s = std::sin(a.pa);
  const double c = std::cos(a.pa);
  return {a.px + c * b.px - s * b.py, a.py + s * b.px + c * b.py,
          ccmorse::NormalizeAngle(a.pa + b.pa)};
}

player_pose2d_t Inverse(const player_pose2d_t& a) {
  const double s = std::sin(a.pa);
  const double c = std::cos(a.pa);
  return {-c * a.px - s * a.py, s * a.px - c * a.py, -a.pa};
}

player_pose2d_t Flat(const player_pose3d_t& pose) { return {pose.px, pose.py, pose.pyaw}; }

bool HasTables(MorseClient& client) {
  for (const MorseRobot* robot : client.GetRobots()) {
    if (robot->HasProperties()) return true;
  }
  return false;
}

MorseDevice& FindPosition(PlayerClient* client, std::uint32_t index, const std::string& robot) {
  constexpr char kFunction[] = "Position2dProxy::Position2dProxy()";
  MorseClient& morse = RequireClient(client, kFunction);
  return FindProxyDevice(morse, "position2d", index, robot,
                         HasTables(morse) ? IsPosition : IsFirstChoice, kFunction);
}

}  // namespace

Position2dProxy::Position2dProxy(PlayerClient* client, std::uint32_t index,
                                 const std::string& robot)
    : Position2dProxy(client, index, FindPosition(client, index, robot)) {}

Position2dProxy::Position2dProxy(PlayerClient* client, std::uint32_t index, MorseDevice& source)
    : MorseProxy(client, index, "position2d", source),
      pose_(dynamic_cast<MorsePose*>(&source)),
      odometry_(dynamic_cast<MorseOdometry*>(&source)),
      speeds_(odometry_ ? odometry_ : source.GetRobot().FindDevice<MorseOdometry>()) {}

Position2dProxy::~Position2dProxy() = default;

void Position2dProxy::SetSpeed(double x_speed, double yaw_speed) {
  {
    const std::lock_guard lock(ProxyMutex());
    if (!motors_on_) return;
  }
  GetRobot().SetSpeed(x_speed, yaw_speed);
}

void Position2dProxy::SetSpeed(double x_speed, double /*y_speed*/, double yaw_speed) {
  SetSpeed(x_speed, yaw_speed);
}

void Position2dProxy::SetSpeed(player_pose2d_t velocity) { SetSpeed(velocity.px, velocity.pa); }

void Position2dProxy::SetVelHead(double x_speed, double yaw_head) {
  SetSpeed(x_speed, kHeadingGain * ccmorse::NormalizeAngle(yaw_head - GetYaw()));
}

void Position2dProxy::SetVelHead(double x_speed, double /*y_speed*/, double yaw_head) {
  SetVelHead(x_speed, yaw_head);
}

void Position2dProxy::GoTo(double x, double y, double yaw) {
  GoTo(player_pose2d_t{x, y, yaw}, player_pose2d_t());
}

void Position2dProxy::GoTo(player_pose2d_t position) { GoTo(position, player_pose2d_t()); }

void Position2dProxy::GoTo(player_pose2d_t position, player_pose2d_t velocity) {
  {
    const std::lock_guard lock(ProxyMutex());
    if (!motors_on_) return;
  }
  if (!std::isfinite(position.px) || !std::isfinite(position.py) || !std::isfinite(position.pa)) {
    throw MorseError("a number of the goal is not finite", "Position2dProxy::GoTo()");
  }
  const player_pose2d_t goal = ToWorld(position);
  constexpr double kTolerance = 0.05;  // m
  GetRobot().SetGoal(goal.px, goal.py, kTolerance, velocity.px);
}

void Position2dProxy::SetCarlike(double x_speed, double drive_angle) {
  double track = 0.0;
  try {
    track = GetRobot().GetWheelTrack();
  } catch (const MorseError& error) {
    throw MorseError(error.GetErrorStr(), "Position2dProxy::SetCarlike()");
  }
  if (!(track > 0.0)) {
    throw MorseError("the robot has no wheel track", "Position2dProxy::SetCarlike()");
  }
  SetSpeed(x_speed, x_speed * std::tan(drive_angle) / track);
}

void Position2dProxy::SetMotorEnable(bool enable) {
  {
    const std::lock_guard lock(ProxyMutex());
    motors_on_ = enable;
  }
  if (!enable) GetRobot().Stop();
}

player_pose2d_t Position2dProxy::RawPose(bool* has_data) const {
  // valid as of the device: a proxy made after a Read() sees the data that are there.
  if (pose_) {
    *has_data = pose_->HasData();
    return Flat(pose_->GetPose());
  }
  *has_data = odometry_->HasData();
  return Flat(odometry_->GetPose());
}

player_pose2d_t Position2dProxy::GetPose() const {
  bool has_data = false;
  const player_pose2d_t raw = RawPose(&has_data);
  const std::lock_guard lock(ProxyMutex());
  if (awaited_) {
    if (!has_data) return *awaited_;
    frame_ = Compose(*awaited_, Inverse(raw));
    awaited_.reset();
  }
  // An unmoved frame changes no bit of what the sensor said.
  if (frame_.px == 0.0 && frame_.py == 0.0 && frame_.pa == 0.0) return raw;
  return Compose(frame_, raw);
}

player_pose2d_t Position2dProxy::ToWorld(player_pose2d_t pose) const {
  GetPose();  // settles an awaited frame
  player_pose2d_t frame;
  {
    const std::lock_guard lock(ProxyMutex());
    frame = frame_;
  }
  player_pose2d_t raw = Compose(Inverse(frame), pose);
  if (pose_) return raw;
  // From the odometry's frame into the world, by where the robot is in both now.
  const MorsePose* truth = GetRobot().FindDevice<MorsePose>();
  if (!truth || !truth->HasPose()) return raw;
  const player_pose2d_t start =
      Compose(Flat(truth->GetPose()), Inverse(Flat(odometry_->GetPose())));
  return Compose(start, raw);
}

void Position2dProxy::ResetOdometry() { SetOdometry(0.0, 0.0, 0.0); }

void Position2dProxy::SetOdometry(double x, double y, double yaw) {
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(yaw)) {
    throw MorseError("a number of the pose is not finite", "Position2dProxy::SetOdometry()");
  }
  {
    const std::lock_guard lock(ProxyMutex());
    awaited_ = player_pose2d_t{x, y, yaw};
  }
  GetPose();  // settles it when there are data
}

double Position2dProxy::GetXPos() const { return GetPose().px; }
double Position2dProxy::GetYPos() const { return GetPose().py; }
double Position2dProxy::GetYaw() const { return GetPose().pa; }
double Position2dProxy::GetXSpeed() const { return speeds_ ? speeds_->GetXSpeed() : 0.0; }
double Position2dProxy::GetYSpeed() const { return speeds_ ? speeds_->GetYSpeed() : 0.0; }
double Position2dProxy::GetYawSpeed() const { return speeds_ ? speeds_->GetYawSpeed() : 0.0; }
bool Position2dProxy::GetStall() const { return speeds_ && speeds_->GetStall(); }

void Position2dProxy::RequestGeom() {
  player_bbox3d_t size;
  try {
    size = GetRobot().GetSize();
  } catch (const MorseError& error) {
    throw MorseError(error.GetErrorStr(), "Position2dProxy::RequestGeom()");
  }
  const std::lock_guard lock(ProxyMutex());
  size_ = size;
}

player_pose3d_t Position2dProxy::GetOffset() const { return {}; }

player_bbox3d_t Position2dProxy::GetSize() const {
  const std::lock_guard lock(ProxyMutex());
  return size_;
}

std::ostream& operator<<(std::ostream& out, const Position2dProxy& proxy) {
  const player_pose2d_t pose = proxy.GetPose();
  return out << "#Position2D (" << proxy.GetInterface() << ":" << proxy.GetIndex() << ")\n"
             << "#xpos\typos\ttheta\tspeed\tsidespeed\tturn\tstall\n"
             << pose.px << " " << pose.py << " " << pose.pa << " " << proxy.GetXSpeed() << " "
             << proxy.GetYSpeed() << " " << proxy.GetYawSpeed() << " " << proxy.GetStall() << "\n";
}

}  // namespace CCMorse
