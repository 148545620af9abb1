#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "client/core/device_registry.h"
#include "libCCMorse/MorseClient.h"
#include "libCCMorse/MorseDevice.h"
#include "libCCMorse/MorseError.h"
#include "libCCMorse/MorseRobot.h"

namespace CCMorse {

namespace {

struct Registry {
  std::mutex mutex;
  std::vector<MorseDeviceClass> classes;
};

// A function's static, because device classes register before main(), in any order.
Registry& TheRegistry() {
  static Registry registry;
  return registry;
}

std::string LowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Whether `word` stands in `name` on its own, not as a part of a longer word: "pen" is in
// "s1r_pen_2" and "LeftPen", and not in "gripper_open".
bool HasWord(const std::string& name, const std::string& word) {
  const std::string lower = LowerCase(name);
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto is_upper = [](char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t at = lower.find(word); at != std::string::npos; at = lower.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool starts =
        at == 0 || !is_letter(name[at - 1]) || (is_upper(name[at]) && !is_upper(name[at - 1]));
    const bool ends = end == name.size() || !is_letter(name[end]) ||
                      (is_upper(name[end]) && !is_upper(name[end - 1]));
    if (starts && ends) return true;
  }
  return false;
}

}  // namespace

bool RegisterMorseDevice(MorseDeviceClass device_class) {
  Registry& registry = TheRegistry();
  const std::lock_guard lock(registry.mutex);
  registry.classes.push_back(std::move(device_class));
  return true;
}

std::unique_ptr<MorseDevice> core::MakeDevice(const MorseDeviceInfo& info) {
  const std::string short_name = info.name.substr(info.name.rfind('.') + 1);
  std::function<std::unique_ptr<MorseDevice>(const MorseDeviceInfo&)> make;
  {
    Registry& registry = TheRegistry();
    const std::lock_guard lock(registry.mutex);
    bool by_type = false;
    std::size_t longest = 0;
    for (const MorseDeviceClass& candidate : registry.classes) {
      if (std::find(candidate.types.begin(), candidate.types.end(), info.type) !=
          candidate.types.end()) {
        make = candidate.make;
        by_type = true;
      }
      if (by_type) continue;
      for (const std::string& identifier : candidate.identifiers) {
        if (identifier.size() >= longest && HasWord(short_name, identifier)) {
          longest = identifier.size();
          make = candidate.make;
        }
      }
    }
  }
  return make ? make(info) : std::make_unique<MorseDevice>(info);
}

MorseDevice::MorseDevice(const MorseDeviceInfo& info) : info_(info) {}
MorseDevice::~MorseDevice() = default;

std::string MorseDevice::GetShortName() const {
  const std::string& robot = info_.robot->GetName();
  if (info_.name.size() > robot.size() && info_.name.compare(0, robot.size(), robot) == 0 &&
      info_.name[robot.size()] == '.') {
    return info_.name.substr(robot.size() + 1);
  }
  return info_.name;
}

bool MorseDevice::HasService(const std::string& name) const {
  return std::find(info_.services.begin(), info_.services.end(), name) != info_.services.end();
}

std::mutex& MorseDevice::DataMutex() const { return info_.client->DataMutex(); }

void MorseDevice::StartUse() const {
  in_use_ = true;
  info_.client->Fetch(info_.name, false);
}

bool MorseDevice::HasData() const {
  Use();
  const std::lock_guard lock(DataMutex());
  return has_data_;
}

bool MorseDevice::IsValid() const {
  Use();
  const std::lock_guard lock(DataMutex());
  return valid_;
}

double MorseDevice::GetTimestamp() const {
  Use();
  const std::lock_guard lock(DataMutex());
  return timestamp_;
}

MorseValue MorseDevice::GetData() const {
  Use();
  {
    const std::lock_guard lock(DataMutex());
    wants_text_ = true;
    if (!data_missing_) return data_;
  }
  info_.client->Fetch(info_.name, true);
  const std::lock_guard lock(DataMutex());
  return data_;
}

bool MorseDevice::IsPolled() const {
  const std::lock_guard lock(DataMutex());
  return polled_;
}

void MorseDevice::SetPolled(bool polled) {
  if (polled && !HasService("get_local_data")) {
    throw MorseError(info_.name + " has no data to ask for", "MorseDevice::SetPolled()");
  }
  const std::lock_guard lock(DataMutex());
  polled_ = polled;
}

void MorseDevice::Command(const std::string& service, const MorseArgs& args) {
  info_.client->Command(info_.name, service, args);
}

MorseValue MorseDevice::Request(const std::string& service, const MorseArgs& args,
                                double timeout) const {
  return info_.client->Request(info_.name, service, args, timeout);
}

void MorseDevice::CommandNumbers(const char* service, std::initializer_list<double> numbers) {
  if (info_.client->QueueNumbers(info_.name, service, numbers.begin(), numbers.size())) return;
  MorseArgs args;
  for (const double number : numbers) args.Add(number);
  Command(service, args);
}

bool MorseDevice::CommandImage(const char* service, int width, int height,
                               const std::vector<Color_t>& image) {
  return info_.client->QueueImage(info_.name, service, width, height, image);
}

bool MorseDevice::CommandPixels(const char* service, const PixelUpdate_t* pixels,
                                std::size_t count) {
  return info_.client->QueuePixels(info_.name, service, pixels, count);
}

void MorseDevice::AskWithRead(const char* service, std::function<void(const MorseValue&)> take) {
  info_.client->AskWithRead(info_.name, service, std::move(take));
}

void MorseDevice::Accept(const MorseValue& data) {
  if (!data.IsObject()) return;
  const double timestamp = data.GetDouble("timestamp", std::numeric_limits<double>::quiet_NaN());
  data_ = data;
  data_missing_ = false;
  has_data_ = true;
  valid_ = OnData(data) && std::isfinite(timestamp);
  if (valid_) timestamp_ = timestamp;
}

void MorseDevice::AcceptNumbers(double timestamp, const double* numbers, std::size_t count) {
  if (!data_missing_) data_ = MorseValue();
  data_missing_ = true;
  has_data_ = true;
  valid_ = OnNumbers(numbers, count) && std::isfinite(timestamp);
  if (valid_) timestamp_ = timestamp;
}

}  // namespace CCMorse
