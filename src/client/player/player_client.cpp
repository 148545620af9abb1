#include "libCCMorse/MorseClient.h"
#include "libCCMorse/PlayerClient.h"

namespace CCMorse {

PlayerClient::PlayerClient(const std::string& host, int port)
    : client_(MorseClient::Share(host, port)) {}
PlayerClient::~PlayerClient() = default;

void PlayerClient::Read() { client_->Read(); }
bool PlayerClient::Peek(int timeout_ms) { return client_->Peek(timeout_ms); }
void PlayerClient::ReadIfWaiting() { client_->ReadIfWaiting(); }
bool PlayerClient::Connected() const { return client_->Connected(); }
void PlayerClient::StartThread() { client_->StartThread(); }
void PlayerClient::StopThread() { client_->StopThread(); }
void PlayerClient::Run(int timeout_ms) { client_->Run(timeout_ms); }
void PlayerClient::Stop() { client_->Stop(); }
void PlayerClient::SetRequestTimeout(std::uint32_t seconds) { client_->SetRequestTimeout(seconds); }
void PlayerClient::SetRetryLimit(int limit) { client_->SetRetryLimit(limit); }
int PlayerClient::GetRetryLimit() const { return client_->GetRetryLimit(); }
void PlayerClient::SetRetryTime(double seconds) { client_->SetRetryTime(seconds); }
double PlayerClient::GetRetryTime() const { return client_->GetRetryTime(); }

void PlayerClient::SetDataMode(std::uint32_t mode) { client_->SetDataMode(static_cast<int>(mode)); }

void PlayerClient::SetReplaceRule(bool replace, int type, int subtype, int interf) {
  client_->SetReplaceRule(replace, type, subtype, interf);
}

void PlayerClient::RequestDeviceList() { client_->RequestDeviceList(); }

std::list<playerc_device_info_t> PlayerClient::GetDeviceList() const {
  return client_->GetDeviceList();
}

std::string PlayerClient::GetHostname() const { return client_->GetHostname(); }
std::uint32_t PlayerClient::GetPort() const { return client_->GetPort(); }
int PlayerClient::LookupCode(const std::string& name) const { return client_->LookupCode(name); }
std::string PlayerClient::LookupName(int code) const { return client_->LookupName(code); }
std::uint32_t PlayerClient::GetOverflowCount() { return client_->GetOverflowCount(); }

std::ostream& operator<<(std::ostream& out, const PlayerClient& client) {
  return out << client.GetHostname() << ": " << client.GetPort();
}

}  // namespace CCMorse
