#pragma once

#include <cstdint>
#include <iosfwd>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "libplayerc++/utility.h"
#include "libplayerc/playerc.h"

namespace CCMorse {
class MorseClient;
}

namespace PlayerCc {

class ClientCore;

/// Guards the data of a client and its proxies. A handle: it stays good when the client is gone.
/// The thread that holds it may call any getter.
class Mutex {
 public:
  Mutex() : mutex_(std::make_shared<std::recursive_mutex>()) {}
  void lock() const { mutex_->lock(); }
  void unlock() const { mutex_->unlock(); }
  bool try_lock() const { return mutex_->try_lock(); }

 private:
  std::shared_ptr<std::recursive_mutex> mutex_;
};

/// The connection to a server (specs: player.md A.4). The address decides what is spoken:
/// "player://HOST:PORT" Player's protocol, "morse://HOST:PORT" that of ccmorse and MORSE;
/// "sim:SCENARIO?option=value" is a simulation within the program (docs/player.md). With a
/// plain host and port a server that greets as Player's do is one, anything else is a simulator;
/// see docs/player.md.
///
/// Owned by the program; proxies may be deleted before or after it. Every method may be called from
/// any thread. Data are locked only while they are taken over, not while Read() waits.
class PlayerClient {
 public:
  /// Connects at once; throws PlayerError within 5 s when nobody answers. A Player server is set to
  /// PULL. `transport`: PLAYERC_TRANSPORT_TCP; PLAYERC_TRANSPORT_UDP is refused by a PlayerError.
  explicit PlayerClient(const std::string& hostname = PLAYER_HOSTNAME,
                        std::uint32_t port = PLAYER_PORTNUM, int transport = PLAYERC_TRANSPORT_TCP);
  /// Ends the thread, sends what waits, gives the devices up and closes the connection. Proxies
  /// that are left keep their last data and ignore commands.
  virtual ~PlayerClient();
  PlayerClient(const PlayerClient&) = delete;
  PlayerClient& operator=(const PlayerClient&) = delete;

  /// Held while data are taken over; hold it to read several values of one moment.
  Mutex mMutex;  // NOLINT(readability-identifier-naming): Player's name

  bool Connected();  ///< whether the connection stands
  /// Starts a thread that reads in a loop, until StopThread() or an error, which the next Read()
  /// then meets itself. Nothing happens when it runs already.
  void StartThread();
  /// Ends that thread, even when its Read() waits, and joins it.
  void StopThread();
  /// Reads in a loop in the calling thread, with `timeout` ms between reads, until Stop().
  void Run(std::uint32_t timeout = 10);
  /// Ends Run() and the thread's loop after the current Read().
  void Stop();
  /// Whether data wait, or come within `timeout` ms. Throws PlayerError when the connection broke.
  bool Peek(std::uint32_t timeout = 0);

  /// How long a request may take, s (default 5).
  void SetRequestTimeout(std::uint32_t seconds);
  /// How often to try to connect again after the connection broke: 0 never (default), -1 for ever.
  void SetRetryLimit(int limit);
  int GetRetryLimit();             ///< as set
  void SetRetryTime(double time);  ///< s between two attempts (default 2)
  double GetRetryTime();           ///< s, as set

  /// PULL: takes all that came since the last round, and waits when that is nothing. PUSH: takes
  /// one message. Throws PlayerError when the connection breaks, and "Overflow on server" after the
  /// server dropped messages, until GetOverflowCount().
  void Read();
  /// Read() if Peek(0).
  void ReadIfWaiting();
  /// PLAYER_DATAMODE_PULL or PLAYER_DATAMODE_PUSH; throws PlayerError for anything else.
  void SetDataMode(std::uint32_t mode);
  /// How the server queues messages for this client: true keeps only the newest of each kind. -1
  /// stands for any. Without effect on MORSE, which keeps the newest only.
  void SetReplaceRule(bool replace, int type = -1, int subtype = -1, int interf = -1);
  /// Asks for the devices; throws PlayerError when there is no answer.
  void RequestDeviceList();
  /// The devices as of RequestDeviceList(); those of a simulator are known from the start.
  std::list<playerc_device_info_t> GetDeviceList();

  std::string GetHostname() const;         ///< without the "player://"; "sim:..." all of it
  std::uint32_t GetPort() const;           ///< the server's port
  int LookupCode(std::string name) const;  ///< 6 for "laser"; 0xFFFF when there is no such
  std::string LookupName(int code) const;  ///< "laser" for 6; "unknown" when there is no such
  /// Messages that the server dropped since the last call.
  std::uint32_t GetOverflowCount();

  /// The simulator's client behind this one; throws PlayerError when it is a Player server.
  CCMorse::MorseClient& GetMorseClient() const;

 protected:
  /// As the public constructor; `simulator`: at a plain address on this machine, a simulator is
  /// tried before the server's greeting is waited for.
  PlayerClient(const std::string& hostname, std::uint32_t port, bool simulator);

 private:
  friend class ClientProxy;
  std::shared_ptr<ClientCore> core_;
};

}  // namespace PlayerCc

namespace std {
/// Prints "host: port".
ostream& operator<<(ostream& out, const PlayerCc::PlayerClient& client);
}  // namespace std
