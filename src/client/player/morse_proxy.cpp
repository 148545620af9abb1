#include <algorithm>
#include <cmath>
#include <utility>

#include "client/core/subscription.h"
#include "libCCMorse/MorseClient.h"
#include "libCCMorse/MorseDevice.h"
#include "libCCMorse/MorseProxy.h"
#include "libCCMorse/MorseRobot.h"

namespace CCMorse {

MorseProxy::MorseProxy(PlayerClient* client, std::uint32_t index, std::string interface,
                       MorseDevice& device)
    : player_client_(client),
      index_(index),
      interface_(std::move(interface)),
      client_(device.GetClient().shared_from_this()),
      device_(&device),
      robot_(&device.GetRobot()),
      subscription_(std::make_shared<MorseSubscription>()) {
  subscription_->proxy = this;
  subscription_->device = device_;
  robot_->AddSubscription(subscription_);
  device_->Use();
}

MorseProxy::~MorseProxy() { robot_->RemoveSubscription(subscription_.get()); }

bool MorseProxy::IsValid() const {
  const std::lock_guard lock(client_->DataMutex());
  return subscription_->valid;
}

bool MorseProxy::IsFresh() const {
  const std::lock_guard lock(client_->DataMutex());
  return subscription_->fresh;
}

void MorseProxy::NotFresh() {
  const std::lock_guard lock(client_->DataMutex());
  subscription_->fresh = false;
}

double MorseProxy::GetDataTime() const {
  const std::lock_guard lock(client_->DataMutex());
  return std::isfinite(subscription_->time) ? subscription_->time : 0.0;
}

double MorseProxy::GetElapsedTime() const {
  const std::lock_guard lock(client_->DataMutex());
  return subscription_->elapsed;
}

std::uint32_t MorseProxy::GetInterface() const {
  return static_cast<std::uint32_t>(client_->LookupCode(interface_));
}

std::string MorseProxy::GetDriverName() const { return device_->GetName(); }

void MorseProxy::SetReplaceRule(bool /*replace*/, int /*type*/, int /*subtype*/) {}
int MorseProxy::HasCapability(std::uint32_t /*type*/, std::uint32_t /*subtype*/) const { return 0; }
int MorseProxy::GetBoolProp(const char* /*property*/, bool* /*value*/) const { return -1; }
int MorseProxy::SetBoolProp(const char* /*property*/, bool /*value*/) { return -1; }
int MorseProxy::GetIntProp(const char* /*property*/, std::int32_t* /*value*/) const { return -1; }
int MorseProxy::SetIntProp(const char* /*property*/, std::int32_t /*value*/) { return -1; }
int MorseProxy::GetDblProp(const char* /*property*/, double* /*value*/) const { return -1; }
int MorseProxy::SetDblProp(const char* /*property*/, double /*value*/) { return -1; }
int MorseProxy::GetStrProp(const char* /*property*/, char** /*value*/) const { return -1; }
int MorseProxy::SetStrProp(const char* /*property*/, const char* /*value*/) { return -1; }

MorseProxy::connection_t MorseProxy::ConnectReadSignal(std::function<void()> subscriber) {
  const std::lock_guard lock(client_->DataMutex());
  const int id = subscription_->next_connection++;
  subscription_->subscribers.emplace_back(id, std::move(subscriber));
  return id;
}

void MorseProxy::DisconnectReadSignal(connection_t connection) {
  const std::lock_guard lock(client_->DataMutex());
  auto& subscribers = subscription_->subscribers;
  subscribers.erase(std::remove_if(subscribers.begin(), subscribers.end(),
                                   [&](const auto& entry) { return entry.first == connection; }),
                    subscribers.end());
}

}  // namespace CCMorse
