#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <ostream>
#include <string>

#include "libCCMorse/Types.h"

namespace CCMorse {

class MorseClient;

/// The connection to a server, with the methods of Player's PlayerClient (thesis 3.1.3). It has no
/// state of its own: everything is redirected to the MorseClient of its address, which several
/// PlayerClients share; the last one that is deleted sends the commands that wait and closes the
/// connection. Owned by the program; proxies may be deleted before or after it. Any thread.
/// Each method is documented in MorseClient.h.
class PlayerClient {
 public:
  /// Connects; the port is the simulator's, 4000 for MORSE and ccmorse. For localhost with port
  /// 4000 or 6665 the environment's CCMORSE_HOST and CCMORSE_PORT are taken, where set, so that
  /// `ccmorse batch` can run many programs at once. Throws MorseError within 2 s when nobody
  /// answers.
  explicit PlayerClient(const std::string& host = "localhost", int port = 6665);
  ~PlayerClient();
  PlayerClient(const PlayerClient&) = delete;
  PlayerClient& operator=(const PlayerClient&) = delete;

  void Read();                                    ///< MorseClient::Read()
  bool Peek(int timeout_ms = 0);                  ///< MorseClient::Peek()
  void ReadIfWaiting();                           ///< MorseClient::ReadIfWaiting()
  bool Connected() const;                         ///< MorseClient::Connected()
  void StartThread();                             ///< MorseClient::StartThread()
  void StopThread();                              ///< MorseClient::StopThread()
  void Run(int timeout_ms = 10);                  ///< MorseClient::Run()
  void Stop();                                    ///< MorseClient::Stop()
  void SetRequestTimeout(std::uint32_t seconds);  ///< MorseClient::SetRequestTimeout()
  void SetRetryLimit(int limit);                  ///< MorseClient::SetRetryLimit()
  int GetRetryLimit() const;                      ///< MorseClient::GetRetryLimit()
  void SetRetryTime(double seconds);              ///< MorseClient::SetRetryTime()
  double GetRetryTime() const;                    ///< MorseClient::GetRetryTime()
  void SetDataMode(std::uint32_t mode);           ///< MorseClient::SetDataMode()
  /// MorseClient::SetReplaceRule()
  void SetReplaceRule(bool replace, int type = -1, int subtype = -1, int interf = -1);
  void RequestDeviceList();                                ///< MorseClient::RequestDeviceList()
  std::list<playerc_device_info_t> GetDeviceList() const;  ///< MorseClient::GetDeviceList()
  std::string GetHostname() const;                         ///< MorseClient::GetHostname()
  std::uint32_t GetPort() const;                           ///< MorseClient::GetPort()
  int LookupCode(const std::string& name) const;           ///< MorseClient::LookupCode()
  std::string LookupName(int code) const;                  ///< MorseClient::LookupName()
  std::uint32_t GetOverflowCount();                        ///< MorseClient::GetOverflowCount()

  /// The client that does the work.
  MorseClient& GetMorseClient() const { return *client_; }

 private:
  const std::shared_ptr<MorseClient> client_;
};

/// Prints "host: port", as Player does.
std::ostream& operator<<(std::ostream& out, const PlayerClient& client);

}  // namespace CCMorse
