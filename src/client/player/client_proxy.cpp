#include <cstdlib>
#include <cstring>
#include <exception>
#include <ostream>

#include "client/player/proxy_state.h"
#include "libplayerc++/playerc++.h"
#include "wire/player/frame.h"

namespace PlayerCc {

namespace {

constexpr std::uint16_t kUnknownInterface = 0xFFFF;

// A property's value asked for, 0 or -1.
template <typename Property>
int Fetch(ProxyState& state, std::uint8_t subtype, const char* key, Property& property) {
  property.key = key;
  return AskFor(state, subtype, wire::Body::Of(property), property).ok() ? 0 : -1;
}

template <typename Property, typename Value>
int Store(ProxyState& state, std::uint8_t subtype, const char* key, const Value& value) {
  Property property;
  property.key = key;
  property.value = value;
  return Ask(state, subtype, property).ok() ? 0 : -1;
}

}  // namespace

void Require(const Answer& answer, const char* function) {
  if (!answer.ok()) throw MorseError(answer.why, function);
}

bool ProxyState::OnData(const CCMorse::playerlink::DataMessage& message) {
  const std::lock_guard lock(mutex);
  if (!Take(message.subtype, message.body)) return false;
  valid = message.valid;
  if (!message.valid) return false;
  const bool newer = !received || message.time > time;
  if (newer) {
    elapsed = message.time - time;
    fresh = true;
  }
  received = true;
  time = message.time;
  return (newer && !subscribers.empty()) || Pending();
}

void ProxyState::Signal() {
  std::vector<std::pair<int, ClientProxy::read_signal_t>> called;
  {
    const std::lock_guard lock(mutex);
    if (subscribers.empty()) return;
    called = subscribers;
  }
  for (const auto& [id, subscriber] : called) subscriber();
}

ClientProxy::ClientProxy(PlayerClient* client, std::uint32_t index, const char* name,
                         const char* interface_name, std::shared_ptr<ProxyState> state,
                         const std::string& robot)
    : state_(std::move(state)),
      client_(client),
      index_(index),
      interface_(wire::InterfaceCode(interface_name).value_or(kUnknownInterface)) {
  const std::string function = std::string(name) + "::" + name + "()";
  if (client == nullptr) throw MorseError("the client is a null pointer", function);
  state_->core = client->core_;
  state_->mutex = client->mMutex;
  if (index > 0xFFFF) throw MorseError("could not subscribe", function);
  try {
    state_->link =
        state_->core->backend->Subscribe(static_cast<std::uint16_t>(interface_),
                                         static_cast<std::uint16_t>(index), robot, this, state_);
  } catch (const MorseError& error) {
    const std::string why = error.GetErrorStr();
    throw MorseError("could not subscribe" + (why.empty() ? "" : ": " + why), function,
                     error.GetErrorCode());
  }
}

ClientProxy::~ClientProxy() { state_->link.reset(); }

bool ClientProxy::IsValid() const { return In<ProxyState>()->valid; }
bool ClientProxy::IsFresh() const { return In<ProxyState>()->fresh; }
void ClientProxy::NotFresh() { In<ProxyState>()->fresh = false; }
std::string ClientProxy::GetDriverName() const { return state_->link->Driver(); }
double ClientProxy::GetDataTime() const { return In<ProxyState>()->time; }
double ClientProxy::GetElapsedTime() const { return In<ProxyState>()->elapsed; }
PlayerClient* ClientProxy::GetPlayerClient() const { return client_; }
std::uint32_t ClientProxy::GetIndex() const { return index_; }
std::uint32_t ClientProxy::GetInterface() const { return interface_; }

std::string ClientProxy::GetInterfaceStr() const {
  return interf_to_str(static_cast<std::uint16_t>(interface_));
}

void ClientProxy::SetReplaceRule(bool replace, int type, int subtype) {
  state_->link->SetReplaceRule(replace, type, subtype);
}

int ClientProxy::HasCapability(std::uint32_t type, std::uint32_t subtype) {
  wire::CapabilitiesReq request;
  request.type = type;
  request.subtype = subtype;
  return Ask(*state_, wire::kCapabilities, request).ok() ? 1 : 0;
}

int ClientProxy::GetBoolProp(const char* property, bool* value) {
  wire::BoolpropReq asked;
  const int result = Fetch(*state_, wire::kGetBool, property, asked);
  if (result == 0) *value = asked.value != 0;
  return result;
}

int ClientProxy::SetBoolProp(const char* property, bool value) {
  return Store<wire::BoolpropReq>(*state_, wire::kSetBool, property, Flag(value));
}

int ClientProxy::GetIntProp(const char* property, std::int32_t* value) {
  wire::IntpropReq asked;
  const int result = Fetch(*state_, wire::kGetInt, property, asked);
  if (result == 0) *value = asked.value;
  return result;
}

int ClientProxy::SetIntProp(const char* property, std::int32_t value) {
  return Store<wire::IntpropReq>(*state_, wire::kSetInt, property, value);
}

int ClientProxy::GetDblProp(const char* property, double* value) {
  wire::DblpropReq asked;
  const int result = Fetch(*state_, wire::kGetDouble, property, asked);
  if (result == 0) *value = asked.value;
  return result;
}

int ClientProxy::SetDblProp(const char* property, double value) {
  return Store<wire::DblpropReq>(*state_, wire::kSetDouble, property, value);
}

int ClientProxy::GetStrProp(const char* property, char** value) {
  wire::StrpropReq asked;
  const int result = Fetch(*state_, wire::kGetString, property, asked);
  if (result == 0) *value = strdup(asked.value.c_str());
  return result;
}

int ClientProxy::SetStrProp(const char* property, const char* value) {
  return Store<wire::StrpropReq>(*state_, wire::kSetString, property, value);
}

// Player's own types, without const.
int ClientProxy::GetBoolProp(char* property, bool* value) {
  return GetBoolProp(static_cast<const char*>(property), value);
}
int ClientProxy::SetBoolProp(char* property, bool value) {
  return SetBoolProp(static_cast<const char*>(property), value);
}
int ClientProxy::GetIntProp(char* property, std::int32_t* value) {
  return GetIntProp(static_cast<const char*>(property), value);
}
int ClientProxy::SetIntProp(char* property, std::int32_t value) {
  return SetIntProp(static_cast<const char*>(property), value);
}
int ClientProxy::GetDblProp(char* property, double* value) {
  return GetDblProp(static_cast<const char*>(property), value);
}
int ClientProxy::SetDblProp(char* property, double value) {
  return SetDblProp(static_cast<const char*>(property), value);
}
int ClientProxy::GetStrProp(char* property, char** value) {
  return GetStrProp(static_cast<const char*>(property), value);
}
int ClientProxy::SetStrProp(char* property, char* value) {
  return SetStrProp(static_cast<const char*>(property), static_cast<const char*>(value));
}

ClientProxy::connection_t ClientProxy::Connect(read_signal_t subscriber) {
  const auto state = In<ProxyState>();
  const int id = state->next_connection++;
  state->subscribers.emplace_back(id, std::move(subscriber));
  return id;
}

void ClientProxy::DisconnectReadSignal(connection_t subscriber) {
  const auto state = In<ProxyState>();
  std::erase_if(state->subscribers, [&](const auto& each) { return each.first == subscriber; });
}

CCMorse::MorseRobot& ClientProxy::GetRobot() const {
  CCMorse::MorseRobot* robot = state_->link->Robot();
  if (robot == nullptr) {
    throw MorseError("there is no simulated robot behind it", "ClientProxy::GetRobot()");
  }
  return *robot;
}

}  // namespace PlayerCc

const char* interf_to_str(std::uint16_t code) {
  const std::string_view name = ccmorse::wire::player::InterfaceName(code);
  return name.empty() ? "unknown" : name.data();  // of a literal, so it ends with a NUL
}

std::uint16_t str_to_interf(const char* name) {
  return ccmorse::wire::player::InterfaceCode(name).value_or(PlayerCc::kUnknownInterface);
}

const char* msgtype_to_str(std::uint32_t type) {
  switch (type) {
    case PLAYER_MSGTYPE_DATA:
      return "data";
    case PLAYER_MSGTYPE_CMD:
      return "command";
    case PLAYER_MSGTYPE_REQ:
      return "request";
    case PLAYER_MSGTYPE_RESP_ACK:
      return "ack";
    case PLAYER_MSGTYPE_SYNCH:
      return "synch";
    case PLAYER_MSGTYPE_RESP_NACK:
      return "nack";
    default:
      return "unknown";
  }
}
