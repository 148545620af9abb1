#include <chrono>
#include <string_view>

#include "client/core/address.h"
#include "client/core/tcp_connect.h"
#include "client/core/tcp_stream.h"
#include "client/player/morse_backend.h"
#include "client/player/player_wire_backend.h"
#include "client/player/proxy_state.h"
#include "libCCMorse/MorseClient.h"
#include "libCCMorse/PlayerClient.h"
#include "libplayerc++/playerc++.h"
#include "wire/player/frame.h"

namespace CCMorse::playerlink {

namespace {

constexpr char kAskedBy[] = "PlayerClient::PlayerClient()";
constexpr auto kProbeConnectLimit = std::chrono::seconds(5);
// A Player server speaks at once, a simulator when it is spoken to.
constexpr auto kProbeLimit = std::chrono::milliseconds(200);
static_assert(core::kPlayerPort == PlayerCc::PLAYER_PORTNUM);

std::unique_ptr<PlayerBackend> OpenInProcess(const std::string& address) {
  if (core::ParseInProcess(address, kAskedBy).protocol == "player") {
    return OpenPlayerServer(address, PlayerCc::PLAYER_PORTNUM);
  }
  return OpenSimulator(address, 0);
}

}  // namespace

std::unique_ptr<PlayerBackend> OpenBackend(const std::string& address, std::uint32_t port,
                                           bool simulator) {
  const core::Location asked = core::ParseAddress(address, static_cast<int>(port), kAskedBy);
  if (asked.scheme == "sim") return OpenInProcess(asked.host);
  if (asked.scheme == "morse") return OpenSimulator(asked.host, asked.port);
  if (asked.scheme == "player") {
    return OpenPlayerServer(asked.host, static_cast<std::uint32_t>(asked.port));
  }
  const auto [host, number] = core::AddressFor(asked.host, asked.port);
  if (core::IsInProcess(host)) return OpenInProcess(host);
  const bool here = host == "localhost" || host == "127.0.0.1";
  if (here && (simulator || number == core::kMorsePort)) {
    try {
      return OpenSimulator(host, number);
    } catch (const MorseError& error) {
      if (!error.GetErrorStr().ends_with(core::kPlayerServerThere)) throw;
      return OpenPlayerServer(host, static_cast<std::uint32_t>(number));
    }
  }
  if (number < 1 || number > 65535) {
    throw MorseError("a port is a number from 1 to 65535", kAskedBy);
  }
  auto stream = std::make_shared<core::TcpStream>(host, number, kProbeConnectLimit, kAskedBy);
  std::string received;
  const auto deadline = std::chrono::steady_clock::now() + kProbeLimit;
  while (received.size() < core::kPlayerGreeting.size() &&
         stream->WaitFor(deadline) == core::TcpStream::Wait::kReady && stream->Receive(received)) {
  }
  if (received.starts_with(core::kPlayerGreeting)) {
    return OpenPlayerServer(host, static_cast<std::uint32_t>(number), std::move(stream), received);
  }
  stream.reset();
  return OpenSimulator(host, number);
}

}  // namespace CCMorse::playerlink

namespace PlayerCc {

PlayerClient::PlayerClient(const std::string& hostname, std::uint32_t port, int transport) {
  if (transport != PLAYERC_TRANSPORT_TCP) {
    throw MorseError("only TCP is supported", "PlayerClient::PlayerClient()");
  }
  core_ = std::make_shared<ClientCore>(CCMorse::playerlink::OpenBackend(hostname, port, false));
}

PlayerClient::PlayerClient(const std::string& hostname, std::uint32_t port, bool simulator)
    : core_(std::make_shared<ClientCore>(
          CCMorse::playerlink::OpenBackend(hostname, port, simulator))) {}

PlayerClient::~PlayerClient() { core_->backend->Close(); }

bool PlayerClient::Connected() { return core_->backend->Connected(); }
void PlayerClient::StartThread() { core_->backend->StartThread(); }
void PlayerClient::StopThread() { core_->backend->StopThread(); }
void PlayerClient::Run(std::uint32_t timeout) { core_->backend->Run(timeout); }
void PlayerClient::Stop() { core_->backend->Stop(); }
bool PlayerClient::Peek(std::uint32_t timeout) { return core_->backend->Peek(timeout); }
void PlayerClient::SetRequestTimeout(std::uint32_t seconds) {
  core_->backend->SetRequestTimeout(seconds);
}
void PlayerClient::SetRetryLimit(int limit) { core_->backend->SetRetryLimit(limit); }
int PlayerClient::GetRetryLimit() { return core_->backend->GetRetryLimit(); }
void PlayerClient::SetRetryTime(double time) { core_->backend->SetRetryTime(time); }
double PlayerClient::GetRetryTime() { return core_->backend->GetRetryTime(); }
void PlayerClient::Read() { core_->backend->Read(); }
void PlayerClient::ReadIfWaiting() {
  if (Peek(0)) Read();
}
void PlayerClient::SetDataMode(std::uint32_t mode) { core_->backend->SetDataMode(mode); }
void PlayerClient::SetReplaceRule(bool replace, int type, int subtype, int interf) {
  core_->backend->SetReplaceRule(replace, type, subtype, interf);
}
void PlayerClient::RequestDeviceList() { core_->backend->RequestDeviceList(); }
std::list<playerc_device_info_t> PlayerClient::GetDeviceList() {
  return core_->backend->GetDeviceList();
}
std::string PlayerClient::GetHostname() const { return core_->backend->GetHostname(); }
std::uint32_t PlayerClient::GetPort() const { return core_->backend->GetPort(); }
// NOLINTNEXTLINE(performance-unnecessary-value-param): Player's own type
int PlayerClient::LookupCode(std::string name) const { return str_to_interf(name.c_str()); }
std::string PlayerClient::LookupName(int code) const {
  return code < 0 || code > 0xFFFF ? "unknown" : interf_to_str(static_cast<std::uint16_t>(code));
}
std::uint32_t PlayerClient::GetOverflowCount() { return core_->backend->GetOverflowCount(); }

CCMorse::MorseClient& PlayerClient::GetMorseClient() const {
  CCMorse::MorseClient* const client = core_->backend->Morse();
  if (client == nullptr) {
    throw MorseError("it is a Player server, no simulator", "PlayerClient::GetMorseClient()");
  }
  return *client;
}

}  // namespace PlayerCc

namespace CCMorse {

PlayerClient::PlayerClient(const std::string& host, int port)
    : PlayerCc::PlayerClient(host, static_cast<std::uint32_t>(port), true) {}
PlayerClient::~PlayerClient() = default;

}  // namespace CCMorse
