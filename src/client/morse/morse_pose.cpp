#include <typeinfo>

#include "client/morse/read_pose.h"
#include "libCCMorse/MorsePose.h"

namespace CCMorse {

namespace {
const bool kPoseRegistered =
    RegisterMorseDevice({{"pose"}, {"Pose"}, [](const MorseDeviceInfo& info) {
                           return std::make_unique<MorsePose>(info);
                         }});
}  // namespace

MorsePose::MorsePose(const MorseDeviceInfo& info) : MorseSensor(info) {}

bool MorsePose::OnData(const MorseValue& data) {
  const auto pose = ReadPose(data, kPoseKeys);
  if (pose) pose_ = *pose;
  return pose.has_value();
}

MorseDevice::DataForm MorsePose::Form() const {
  return typeid(*this) == typeid(MorsePose) ? DataForm::kPose : DataForm::kText;
}

bool MorsePose::OnNumbers(const double* numbers, std::size_t count) {
  const auto pose = count == 6 ? ReadPose(numbers) : std::nullopt;
  if (pose) pose_ = *pose;
  return pose.has_value();
}

bool MorsePose::HasPose() const { return IsValid(); }

player_pose3d_t MorsePose::GetPose() const {
  Use();
  const std::lock_guard lock(DataMutex());
  return pose_;
}

}  // namespace CCMorse
