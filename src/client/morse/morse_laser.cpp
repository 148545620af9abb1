#include <algorithm>
#include <cmath>
#include <typeinfo>

#include "base/trig.h"
#include "libCCMorse/MorseError.h"
#include "libCCMorse/MorseLaser.h"

namespace CCMorse {

namespace {
const bool kLaserRegistered = RegisterMorseDevice(
    {{"hokuyo", "laser", "laserscanner", "sick"},
     {"LaserScanner", "Hokuyo", "Sick"},
     [](const MorseDeviceInfo& info) { return std::make_unique<MorseLaser>(info); }});
}  // namespace

MorseLaser::MorseLaser(const MorseDeviceInfo& info) : MorseSensor(info) {}

std::vector<std::string> MorseLaser::SetupServices() const { return {"get_configurations"}; }

void MorseLaser::OnSetup(const std::string& /*service*/, const MorseValue& answer) {
  const MorseValue settings = answer.Get("configurations");
  const auto positive = [&](const char* key) {
    const double value = settings.GetDouble(key);
    return std::isfinite(value) && value > 0.0 ? value : 0.0;
  };
  max_range_ = positive("laser_range");
  resolution_ = ccmorse::Radians(positive("resolution"));
  scan_window_ = ccmorse::Radians(positive("scan_window"));
  frequency_ = positive("frequency");
  mounting_.px = settings.GetDouble("object_to_robot.translation.0");
  mounting_.py = settings.GetDouble("object_to_robot.translation.1");
  mounting_.pz = settings.GetDouble("object_to_robot.translation.2");
  // Rows of the rotation matrix Rz(yaw) Ry(pitch) Rx(roll).
  const auto element = [&](const char* at, double identity) {
    return settings.GetDouble(std::string("object_to_robot.rotation.") + at, identity);
  };
  mounting_.proll = std::atan2(element("2.1", 0.0), element("2.2", 1.0));
  mounting_.ppitch = std::asin(std::clamp(-element("2.0", 0.0), -1.0, 1.0));
  mounting_.pyaw = std::atan2(element("1.0", 0.0), element("0.0", 1.0));
}

bool MorseLaser::OnData(const MorseValue& data) {
  const std::vector<double> ranges = data.GetDoubles("range_list");
  return OnNumbers(ranges.data(), ranges.size());
}

MorseDevice::DataForm MorseLaser::Form() const {
  return typeid(*this) == typeid(MorseLaser) ? DataForm::kScan : DataForm::kText;
}

bool MorseLaser::OnNumbers(const double* numbers, std::size_t count) {
  if (count == 0 || max_range_ == 0.0 || resolution_ == 0.0 || scan_window_ == 0.0) return false;
  ranges_.assign(numbers, numbers + count);
  for (double& range : ranges_) {
    // What is no number met nothing; the comparison is false for it.
    if (!(range < max_range_)) range = max_range_;
    if (range < 0.0) range = 0.0;
  }
  return true;
}

std::size_t MorseLaser::GetCount() const {
  Use();
  const std::lock_guard lock(DataMutex());
  return ranges_.size();
}

std::vector<double> MorseLaser::GetRanges() const {
  Use();
  const std::lock_guard lock(DataMutex());
  return ranges_;
}

void MorseLaser::CopyRanges(std::vector<double>& ranges) const {
  Use();
  const std::lock_guard lock(DataMutex());
  ranges = ranges_;
}

double MorseLaser::GetRange(std::size_t index) const {
  Use();
  const std::lock_guard lock(DataMutex());
  if (index >= ranges_.size()) {
    throw MorseError("index " + std::to_string(index) + " of " + std::to_string(ranges_.size()),
                     "MorseLaser::GetRange()");
  }
  return ranges_[index];
}

double MorseLaser::GetBearing(std::size_t index) const {
  return GetMinAngle() + static_cast<double>(index) * resolution_;
}

double MorseLaser::GetMinRange() const {
  Use();
  const std::lock_guard lock(DataMutex());
  const auto nearest = std::min_element(ranges_.begin(), ranges_.end());
  return nearest == ranges_.end() ? max_range_ : *nearest;
}

double MorseLaser::GetMinRangeAngle() const {
  Use();
  const std::lock_guard lock(DataMutex());
  const auto nearest = std::min_element(ranges_.begin(), ranges_.end());
  return nearest == ranges_.end() ? 0.0
                                  : GetBearing(static_cast<std::size_t>(nearest - ranges_.begin()));
}

}  // namespace CCMorse
