#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "wire/player/frame.h"

namespace ccmorse::test {

/// A Player server that follows a script (specs: player.md B): it listens on a port of its own on
/// 127.0.0.1, has the devices that it was given, and notes every message that comes in. It answers
/// what B.5 tells; other requests as Answer() says, else by NACK. It runs a thread of its own;
/// every method may be called from any thread.
class PlayerDouble {
 public:
  struct Device {
    std::uint16_t interf;
    std::uint16_t index;
    std::string driver;
  };
  struct Noted {
    wire::player::Header header;
    wire::player::Bytes body;
  };

  explicit PlayerDouble(std::vector<Device> devices);
  ~PlayerDouble();
  PlayerDouble(const PlayerDouble&) = delete;
  PlayerDouble& operator=(const PlayerDouble&) = delete;

  std::uint16_t port() const;
  /// Data for the client; in PULL they wait for its next request.
  template <typename Body>
  void Data(std::uint16_t interf, std::uint16_t index, std::uint8_t subtype, double time,
            const Body& body) {
    Queue(interf, index, subtype, time, wire::player::Encode(body));
  }
  void Queue(std::uint16_t interf, std::uint16_t index, std::uint8_t subtype, double time,
             wire::player::Bytes body);
  /// Says with the next SYNCH that `count` messages were dropped.
  void Overflow(std::uint32_t count);
  /// Answers requests of this kind by ACK and this body from now on.
  template <typename Body>
  void Answer(std::uint16_t interf, std::uint8_t subtype, const Body& body) {
    AnswerBytes(interf, subtype, wire::player::Encode(body));
  }
  void AnswerBytes(std::uint16_t interf, std::uint8_t subtype, wire::player::Bytes body);
  /// Answers every request that nothing is said of by ACK without a body, instead of NACK.
  void AgreeToAll();
  /// Answers no request but those of B.5 from now on.
  void FallSilent();
  /// Closes the connections; new ones are taken.
  void Disconnect();

  /// What came in, in order.
  std::vector<Noted> Messages() const;
  /// How many messages of this kind came in.
  std::size_t Count(std::uint16_t interf, wire::player::MessageType type,
                    std::uint8_t subtype) const;
  /// Waits up to 10 s until as many came in.
  bool WaitFor(std::uint16_t interf, wire::player::MessageType type, std::uint8_t subtype,
               std::size_t count = 1) const;
  /// Devices that are subscribed now, over all connections.
  std::size_t Subscribed() const;

 private:
  struct Impl;
  const std::unique_ptr<Impl> impl_;
};

}  // namespace ccmorse::test
