#include "servers/player/device.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace ccmorse::servers::player {
namespace {

// What clients may leave in a device's property bag.
constexpr std::size_t kMostProperties = 64;
constexpr std::size_t kLongestProperty = 4096;  // bytes of a key or a text

constexpr double kEarliest = 1e-6;  // s; data stamped 0 would count as none (H4)

}  // namespace

Device::Device(std::uint16_t interface_code, std::uint16_t index, std::string driver,
               Capabilities capabilities)
    : interface_(interface_code),
      index_(index),
      driver_(std::move(driver)),
      capabilities_(capabilities) {}

bool Device::HasCapability(wire::MessageType type, std::uint8_t subtype) const {
  return std::find(capabilities_.begin(), capabilities_.end(), std::pair(type, subtype)) !=
         capabilities_.end();
}

void Device::Subscribe(Subscriber& subscriber) {
  for (Listener& each : subscribers_) {
    if (each.subscriber != &subscriber) continue;
    ++each.times;
    return;
  }
  subscribers_.push_back({&subscriber, 1});
  if (subscribers_.size() == 1) FirstSubscribed();
}

void Device::Unsubscribe(Subscriber& subscriber) {
  const auto found =
      std::find_if(subscribers_.begin(), subscribers_.end(),
                   [&](const Listener& each) { return each.subscriber == &subscriber; });
  if (found == subscribers_.end() || --found->times > 0) return;
  subscribers_.erase(found);
  if (subscribers_.empty()) LastLeft();
}

bool Device::IsSubscribed(const Subscriber& subscriber) const {
  return std::any_of(subscribers_.begin(), subscribers_.end(),
                     [&](const Listener& each) { return each.subscriber == &subscriber; });
}

bool Device::Request(std::uint8_t subtype, const wire::Body& body, Reply& reply) {
  if (subtype >= wire::kSetBool) return Universal(subtype, body, reply);
  return HasCapability(wire::MessageType::kRequest, subtype) && Ask(subtype, body, reply);
}

void Device::Command(std::uint8_t subtype, const wire::Body& body) {
  if (HasCapability(wire::MessageType::kCommand, subtype)) Tell(subtype, body);
}

void Device::Publish(std::uint8_t subtype, double time, const wire::Body& body) {
  if (subscribers_.empty()) return;
  if (time <= last_time_) {
    time = std::nextafter(last_time_, std::numeric_limits<double>::infinity());
  }
  last_time_ = time = std::max(time, kEarliest);
  const DataMessage message(*this, subtype, time, body);
  for (const Listener& each : subscribers_) each.subscriber->Data(message);
}

bool Device::Universal(std::uint8_t subtype, const wire::Body& body, Reply& reply) {
  switch (subtype) {
    case wire::kCapabilities: {
      wire::CapabilitiesReq asked;
      if (!body.To(asked) || asked.type > 6 || asked.subtype > 255) return false;
      const auto about = static_cast<std::uint8_t>(asked.subtype);
      const auto type = static_cast<wire::MessageType>(asked.type);
      return HasCapability(type, about) ||
             (type == wire::MessageType::kRequest && about >= wire::kSetBool);
    }
    case wire::kGetInt:
      return GetProperty<wire::IntpropReq, std::int32_t>(body, reply);
    case wire::kSetInt:
      return SetProperty<wire::IntpropReq, std::int32_t>(body);
    case wire::kGetDouble:
      return GetProperty<wire::DblpropReq, double>(body, reply);
    case wire::kSetDouble:
      return SetProperty<wire::DblpropReq, double>(body);
    case wire::kGetString:
      return GetProperty<wire::StrpropReq, std::string>(body, reply);
    case wire::kSetString:
      return SetProperty<wire::StrpropReq, std::string>(body);
    case wire::kGetBool:
      return GetProperty<wire::BoolpropReq, bool>(body, reply);
    default:
      return SetProperty<wire::BoolpropReq, bool>(body);
  }
}

template <typename Struct, typename Value>
bool Device::GetProperty(const wire::Body& body, Reply& reply) const {
  Struct property;
  if (!body.To(property)) return false;
  const auto found = properties_.find(property.key);
  if (found == properties_.end() || !std::holds_alternative<Value>(found->second)) return false;
  property.value = std::get<Value>(found->second);
  reply.Set(std::move(property));
  return true;
}

template <typename Struct, typename Value>
bool Device::SetProperty(const wire::Body& body) {
  Struct property;
  if (!body.To(property) || property.key.size() > kLongestProperty) return false;
  if constexpr (std::is_same_v<Value, std::string>) {
    if (property.value.size() > kLongestProperty) return false;
  }
  const auto found = properties_.find(property.key);
  if (found == properties_.end() && properties_.size() >= kMostProperties) return false;
  properties_.insert_or_assign(property.key, Property(static_cast<Value>(property.value)));
  return true;
}

void DeviceList::Add(std::shared_ptr<Device> device) {
  if (Find(device->interface_code(), device->index()) != nullptr) {
    throw Error("two devices are called " +
                std::string(wire::InterfaceName(device->interface_code())) + ":" +
                std::to_string(device->index()));
  }
  devices_.push_back(std::move(device));
}

Device* DeviceList::Find(std::uint16_t interface_code, std::uint16_t index) const {
  for (const auto& device : devices_) {
    if (device->interface_code() == interface_code && device->index() == index) {
      return device.get();
    }
  }
  return nullptr;
}

}  // namespace ccmorse::servers::player
