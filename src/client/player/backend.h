#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>

#include "libplayerc/playerc.h"
#include "wire/player/body.h"
#include "wire/player/messages.h"

namespace PlayerCc {
class ClientProxy;
}

namespace CCMorse {
class MorseClient;
class MorseRobot;
}  // namespace CCMorse

namespace CCMorse::playerlink {

namespace wire = ccmorse::wire::player;

/// A data message on its way to a proxy.
struct DataMessage {
  std::uint8_t subtype = 0;
  double time = 0.0;       ///< s
  bool valid = true;       ///< whether the data make sense; false: time says nothing
  const wire::Body& body;  // NOLINT(cppcoreguidelines-avoid-const-or-ref-data-members): a view
};

/// Takes the data of one device. Called by the thread that reads, with no lock of the back end
/// held.
class DataSink {
 public:
  virtual ~DataSink() = default;
  /// True when Signal() is to follow, once all data of the round were taken.
  virtual bool OnData(const DataMessage& message) = 0;
  virtual void Signal() = 0;
};

/// What became of a request.
struct Answer {
  enum class Kind { kAck, kNack, kTimeout, kLost };
  Kind kind = Kind::kAck;
  std::string why;  ///< a sentence for people, unless it is kAck
  bool ok() const { return kind == Kind::kAck; }
};

/// Takes the body of an answer, which lives only as long as the call.
using TakeReply = std::function<void(const wire::Body&)>;

/// A subscribed device; deleting it gives the device up. Any thread. After the back end was closed,
/// commands are ignored and requests answered by kLost.
class DeviceLink {
 public:
  virtual ~DeviceLink() = default;
  /// Sends a command; throws MorseError when it makes no sense.
  virtual void Command(std::uint8_t subtype, const wire::Body& body) = 0;
  virtual Answer Request(std::uint8_t subtype, const wire::Body& body, const TakeReply& take) = 0;
  /// A queue rule for this device; -1 for any.
  virtual void SetReplaceRule(bool /*replace*/, int /*type*/, int /*subtype*/) {}
  /// Name of the driver or device behind it.
  virtual std::string Driver() const = 0;
  /// The simulated robot that carries it; null when there is none.
  virtual MorseRobot* Robot() const { return nullptr; }
};

/// The window on the simulation's canvas, which Player has no interface for.
inline constexpr std::uint16_t kWindowInterface = 0xFFFF;

/// What lies beneath PlayerClient and all proxies: a connection to a Player server or a simulator.
/// Messages are Player's; their bodies are bytes or structs, so that nothing is packed, and no
/// double rounded, on the way to a simulator's data. The methods are PlayerClient's and documented
/// there; errors are MorseErrors. Any thread.
class PlayerBackend {
 public:
  virtual ~PlayerBackend() = default;
  /// Subscribes a device for `sink`. `robot`: name of the simulated robot, empty for any; `proxy`
  /// is only handed back by MorseRobot::GetProxies(). Throws MorseError that says why not.
  virtual std::unique_ptr<DeviceLink> Subscribe(std::uint16_t interface_code, std::uint16_t index,
                                                const std::string& robot,
                                                PlayerCc::ClientProxy* proxy,
                                                std::shared_ptr<DataSink> sink) = 0;
  /// Ends threads, gives all devices up and closes the connection. Never throws.
  virtual void Close() noexcept = 0;

  virtual bool Connected() = 0;
  virtual void Read() = 0;
  virtual bool Peek(std::uint32_t timeout_ms) = 0;
  virtual void Run(std::uint32_t timeout_ms) = 0;
  virtual void Stop() = 0;
  virtual void StartThread() = 0;
  virtual void StopThread() = 0;
  virtual void SetRequestTimeout(double seconds) = 0;
  virtual void SetRetryLimit(int limit) = 0;
  virtual int GetRetryLimit() = 0;
  virtual void SetRetryTime(double seconds) = 0;
  virtual double GetRetryTime() = 0;
  virtual void SetDataMode(std::uint32_t mode) = 0;
  virtual void SetReplaceRule(bool replace, int type, int subtype, int interface_code) = 0;
  virtual void RequestDeviceList() = 0;
  virtual std::list<playerc_device_info_t> GetDeviceList() = 0;
  virtual std::string GetHostname() const = 0;
  virtual std::uint32_t GetPort() const = 0;
  virtual std::uint32_t GetOverflowCount() = 0;
  /// The simulator's client; null for a Player server.
  virtual MorseClient* Morse() const { return nullptr; }
};

/// The back end that an address asks for (PlayerClient's constructor). `simulator`: a plain address
/// on this machine is tried as a simulator first. Throws MorseError.
std::unique_ptr<PlayerBackend> OpenBackend(const std::string& address, std::uint32_t port,
                                           bool simulator);

}  // namespace CCMorse::playerlink
