#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace CCMorse {

class MorseClient;
class MorseDevice;
class MorseRobot;
class PlayerClient;
struct MorseSubscription;

/// Base of all proxies (thesis 3.1.3): what Player's ClientProxy does. A proxy shows the data of
/// devices of one robot. Its owner is the program; it keeps the client's data alive, so it may be
/// deleted before or after its client: afterwards it gives the last values and ignores commands.
/// Every method may be called from any thread.
class MorseProxy {
 public:
  /// Number of a read signal's subscriber, as Player has it.
  using connection_t = int;

  virtual ~MorseProxy() = 0;
  MorseProxy(const MorseProxy&) = delete;
  MorseProxy& operator=(const MorseProxy&) = delete;

  /// Whether sensible data arrived. Set by the library alone (thesis 3.3).
  bool IsValid() const;
  /// Whether a Read() brought newer data since NotFresh() (thesis 3.3).
  bool IsFresh() const;
  /// Marks the data as used.
  void NotFresh();
  /// Simulated time of the data, s; 0 before the first.
  double GetDataTime() const;
  /// Simulated time between the last two data, s; as in Player, the first counts from 0.
  double GetElapsedTime() const;

  std::uint32_t GetIndex() const { return index_; }                 ///< as given to the constructor
  PlayerClient* GetPlayerClient() const { return player_client_; }  ///< as given to the constructor
  MorseRobot& GetRobot() const { return *robot_; }                  ///< the robot it belongs to
  std::uint32_t GetInterface() const;                         ///< Player's code of the interface
  std::string GetInterfaceStr() const { return interface_; }  ///< "position2d", "laser"
  /// Name of the device that gives the data, "s1r.hokuyo".
  std::string GetDriverName() const;

  /// No effect: only the latest data are ever kept.
  void SetReplaceRule(bool replace, int type = -1, int subtype = -1);
  /// 0: MORSE's devices have none of Player's optional capabilities.
  int HasCapability(std::uint32_t type, std::uint32_t subtype) const;
  // Player's property bags, which MORSE's devices do not have: each returns -1 and changes nothing.
  int GetBoolProp(const char* property, bool* value) const;
  int SetBoolProp(const char* property, bool value);
  int GetIntProp(const char* property, std::int32_t* value) const;
  int SetIntProp(const char* property, std::int32_t value);
  int GetDblProp(const char* property, double* value) const;
  int SetDblProp(const char* property, double value);
  int GetStrProp(const char* property, char** value) const;
  int SetStrProp(const char* property, const char* value);

  /// Calls `subscriber` in the reading thread whenever a Read() brought fresh data. It must not
  /// delete a proxy.
  connection_t ConnectReadSignal(std::function<void()> subscriber);
  /// Ends that; unknown numbers are ignored.
  void DisconnectReadSignal(connection_t connection);

 protected:
  /// A proxy over `device`, whose data decide over valid and fresh.
  MorseProxy(PlayerClient* client, std::uint32_t index, std::string interface, MorseDevice& device);

  /// Guards what a proxy computes from; not to be held while a device's or robot's method is
  /// called.
  std::mutex& ProxyMutex() const { return mutex_; }
  MorseClient& Client() const { return *client_; }

 private:
  PlayerClient* const player_client_;
  const std::uint32_t index_;
  const std::string interface_;
  const std::shared_ptr<MorseClient> client_;  // keeps robot and device alive
  MorseDevice* const device_;
  MorseRobot* const robot_;
  const std::shared_ptr<MorseSubscription> subscription_;
  mutable std::mutex mutex_;
};

}  // namespace CCMorse
