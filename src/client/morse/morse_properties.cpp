#include <algorithm>
#include <charconv>

#include "libCCMorse/MorseProperties.h"

namespace CCMorse {

namespace {
const bool kPropertiesRegistered = RegisterMorseDevice(
    {{"properties", "robotproperties"},
     {"RobotProperties", "Robotproperties"},
     [](const MorseDeviceInfo& info) { return std::make_unique<MorseProperties>(info); }});
}  // namespace

MorseProperties::MorseProperties(const MorseDeviceInfo& info) : MorseSensor(info) {
  SetPolled(false);  // read once: nothing in it changes
}

std::vector<std::string> MorseProperties::SetupServices() const { return {"get_local_data"}; }

void MorseProperties::OnSetup(const std::string& /*service*/, const MorseValue& answer) {
  const std::lock_guard lock(DataMutex());
  OnData(answer);
}

bool MorseProperties::OnData(const MorseValue& data) {
  const MorseValue properties = data.Get("properties");
  if (!properties.IsObject()) return false;
  properties_ = properties;
  return true;
}

MorseValue MorseProperties::GetAll() const {
  const std::lock_guard lock(DataMutex());
  return properties_;
}

bool MorseProperties::Has(const std::string& path) const { return GetAll().Has(path); }
MorseValue MorseProperties::Get(const std::string& path) const { return GetAll().Get(path); }

double MorseProperties::GetDouble(const std::string& path, double fallback) const {
  return GetAll().GetDouble(path, fallback);
}

int MorseProperties::GetInt(const std::string& path, int fallback) const {
  return GetAll().GetInt(path, fallback);
}

bool MorseProperties::GetBool(const std::string& path, bool fallback) const {
  return GetAll().GetBool(path, fallback);
}

std::string MorseProperties::GetString(const std::string& path, const std::string& fallback) const {
  return GetAll().GetString(path, fallback);
}

std::vector<double> MorseProperties::GetDoubles(const std::string& path) const {
  return GetAll().GetDoubles(path);
}

player_pose2d_t MorseProperties::GetInitialPose() const {
  const MorseValue all = GetAll();
  return {all.GetDouble("pose.x"), all.GetDouble("pose.y"), all.GetDouble("pose.yaw")};
}

std::vector<int> MorseProperties::GetProxyIndexes(const std::string& interface) const {
  std::vector<int> indexes;
  for (const std::string& key : GetAll().Member("proxies").Member(interface).GetKeys()) {
    int index = 0;
    const auto parsed = std::from_chars(key.data(), key.data() + key.size(), index);
    if (parsed.ec == std::errc() && parsed.ptr == key.data() + key.size()) indexes.push_back(index);
  }
  std::sort(indexes.begin(), indexes.end());
  return indexes;
}

MorseValue MorseProperties::GetDriver(const std::string& name) const {
  return GetAll().Member("drivers").Member(name);
}

}  // namespace CCMorse
