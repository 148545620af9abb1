#include <typeinfo>

#include "client/morse/read_pose.h"
#include "libCCMorse/MorseOdometry.h"

namespace CCMorse {

namespace {

constexpr const char* kSpeedKeys[6] = {"vx", "vy", "vz", "wx", "wy", "wz"};

const bool kOdometryRegistered =
    RegisterMorseDevice({{"odometry"}, {"IntegratedOdometry"}, [](const MorseDeviceInfo& info) {
                           return std::make_unique<MorseOdometry>(info);
                         }});

}  // namespace

MorseOdometry::MorseOdometry(const MorseDeviceInfo& info) : MorseSensor(info) {}

bool MorseOdometry::OnData(const MorseValue& data) {
  const auto pose = ReadPose(data, kPoseKeys);
  const auto speed = ReadPose(data, kSpeedKeys);
  if (!pose || !speed) return false;
  pose_ = *pose;
  speed_ = *speed;
  stall_ = data.GetBool("stall");
  return true;
}

MorseDevice::DataForm MorseOdometry::Form() const {
  return typeid(*this) == typeid(MorseOdometry) ? DataForm::kOdometry : DataForm::kText;
}

bool MorseOdometry::OnNumbers(const double* numbers, std::size_t count) {
  constexpr std::size_t kCount = 13;
  const auto pose = count == kCount ? ReadPose(numbers) : std::nullopt;
  const auto speed = count == kCount ? ReadPose(numbers + 6) : std::nullopt;
  if (!pose || !speed) return false;
  pose_ = *pose;
  speed_ = *speed;
  stall_ = numbers[12] != 0.0;
  return true;
}

player_pose3d_t MorseOdometry::GetPose() const {
  Use();
  const std::lock_guard lock(DataMutex());
  return pose_;
}

player_pose3d_t MorseOdometry::GetSpeed() const {
  Use();
  const std::lock_guard lock(DataMutex());
  return speed_;
}

bool MorseOdometry::GetStall() const {
  Use();
  const std::lock_guard lock(DataMutex());
  return stall_;
}

}  // namespace CCMorse
