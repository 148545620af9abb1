#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "libplayerc++/playerclient.h"

namespace CCMorse {
class MorseRobot;
}

namespace PlayerCc {

class ProxyState;
template <class State>
class Locked;

/// Base of all proxies (specs: player.md A.2, A.4). A proxy shows the data of a device as of the
/// last Read() of its client; getters give one consistent copy, zeros before the first data. Owned
/// by the program; it may outlive its client: then it keeps its last values and ignores commands.
/// Every method may be called from any thread. Methods with an index throw PlayerError when there
/// is no such element, unless they say otherwise; requests throw PlayerError when the server
/// refuses or does not answer, unless they say otherwise.
class ClientProxy {
 public:
  using connection_t = int;                       ///< number of a subscriber
  using scoped_lock_t = std::unique_lock<Mutex>;  ///< holds PlayerClient::mMutex
  using read_signal_t = std::function<void()>;    ///< what is called after new data

  virtual ~ClientProxy() = 0;
  ClientProxy(const ClientProxy&) = delete;
  ClientProxy& operator=(const ClientProxy&) = delete;

  virtual bool IsValid() const;       ///< whether sensible data arrived
  bool IsFresh() const;               ///< whether newer data arrived since NotFresh()
  void NotFresh();                    ///< marks the data as used
  std::string GetDriverName() const;  ///< name of the driver behind the device
  double GetDataTime() const;         ///< s, of the last data; 0 before the first
  /// Time between the last two data, s; the first count from 0.
  double GetElapsedTime() const;
  PlayerClient* GetPlayerClient() const;  ///< as given to the constructor
  std::uint32_t GetIndex() const;         ///< as given to the constructor
  std::uint32_t GetInterface() const;     ///< code of the interface
  std::string GetInterfaceStr() const;    ///< name of the interface, "position2d"

  /// PlayerClient::SetReplaceRule() for this device only.
  void SetReplaceRule(bool replace, int type = -1, int subtype = -1);
  /// 1 when the driver takes messages of this type and subtype, 0 when not.
  int HasCapability(std::uint32_t type, std::uint32_t subtype);

  // The driver's properties: 0, or -1 when it has none of that name and type.
  int GetBoolProp(char* property, bool* value);
  int SetBoolProp(char* property, bool value);
  int GetIntProp(char* property, std::int32_t* value);
  int SetIntProp(char* property, std::int32_t value);
  int GetDblProp(char* property, double* value);
  int SetDblProp(char* property, double value);
  /// The caller frees `*value` by free().
  int GetStrProp(char* property, char** value);
  int SetStrProp(char* property, char* value);
  int GetBoolProp(const char* property, bool* value);
  int SetBoolProp(const char* property, bool value);
  int GetIntProp(const char* property, std::int32_t* value);
  int SetIntProp(const char* property, std::int32_t value);
  int GetDblProp(const char* property, double* value);
  int SetDblProp(const char* property, double value);
  int GetStrProp(const char* property, char** value);
  int SetStrProp(const char* property, const char* value);

  /// Calls `subscriber`, anything that takes no arguments, in the reading thread after new data.
  template <typename T>
  connection_t ConnectReadSignal(T subscriber) {
    return Connect(read_signal_t(std::move(subscriber)));
  }
  /// Ends that; unknown numbers are ignored.
  void DisconnectReadSignal(connection_t subscriber);

  /// The simulated robot that carries the device; throws PlayerError when there is none.
  CCMorse::MorseRobot& GetRobot() const;

 protected:
  /// `name`: of the class, "LaserProxy"; `robot`: of the robot that is meant, empty for the first
  /// that has the index. Throws PlayerError "could not subscribe".
  ClientProxy(PlayerClient* client, std::uint32_t index, const char* name,
              const char* interface_name, std::shared_ptr<ProxyState> state,
              const std::string& robot = "");
  template <class State>
  Locked<State> In() const;

  std::shared_ptr<ProxyState> state_;  // may be held by a Read() when the proxy is gone

 private:
  connection_t Connect(read_signal_t subscriber);

  PlayerClient* const client_;
  const std::uint32_t index_;
  const std::uint32_t interface_;
};

}  // namespace PlayerCc

namespace std {
/// Prints "driver: interface(index)".
ostream& operator<<(ostream& out, const PlayerCc::ClientProxy& proxy);
}  // namespace std
