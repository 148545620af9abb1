#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/line_client.h"
#include "wire/player/frame.h"
#include "wire/player/messages.h"
#include "wire/player/xdr.h"

namespace ccmorse::testing {

/// A bare, blocking Player client for tests. Not thread safe. Throws std::runtime_error where the
/// server falls silent.
class PlayerWireClient {
 public:
  struct Message {
    wire::player::Header header;
    wire::player::Bytes body;

    /// The body as `Struct`. Throws when it is none.
    template <typename Struct>
    Struct As() const {
      Struct out;
      if (!wire::player::Decode(std::span(body), out)) Fail("a body is not what it should be");
      return out;
    }
  };

  /// Connects to 127.0.0.1 and reads the banner.
  explicit PlayerWireClient(int port);

  const std::string& banner() const { return banner_; }
  LineClient& socket() { return socket_; }

  void Send(wire::player::MessageType type, std::uint16_t interface_code, std::uint16_t index,
            std::uint8_t subtype, const wire::player::Bytes& body = {});
  template <typename Struct>
  void Command(std::uint16_t interface_code, std::uint16_t index, std::uint8_t subtype,
               const Struct& body) {
    Send(wire::player::MessageType::kCommand, interface_code, index, subtype,
         wire::player::Encode(body));
  }

  /// The next message; nothing when none comes in time or the server has closed.
  std::optional<Message> Receive(
      std::chrono::milliseconds timeout = std::chrono::milliseconds(10000));

  /// Sends a request and waits for its ACK or NACK; data that come before are kept for Read().
  Message Request(std::uint16_t interface_code, std::uint16_t index, std::uint8_t subtype,
                  const wire::player::Bytes& body = {});
  template <typename Struct>
  Message RequestWith(std::uint16_t interface_code, std::uint16_t index, std::uint8_t subtype,
                      const Struct& body) {
    return Request(interface_code, index, subtype, wire::player::Encode(body));
  }
  /// Its ACK's body. Throws on NACK.
  template <typename Struct>
  Struct Get(std::uint16_t interface_code, std::uint16_t index, std::uint8_t subtype,
             const wire::player::Bytes& body = {}) {
    const Message reply = Request(interface_code, index, subtype, body);
    if (reply.header.type != wire::player::MessageType::kAck) Fail("a request was refused");
    return reply.As<Struct>();
  }

  /// The name of the driver. Throws when the server refuses.
  std::string Subscribe(std::uint16_t interface_code, std::uint16_t index);
  void Unsubscribe(std::uint16_t interface_code, std::uint16_t index);
  void SetPull(bool pull);

  /// PULL: asks for data and returns what comes, up to and with the SYNCH.
  std::vector<Message> Read();
  /// The same, until a round holds data of that interface: the last of them.
  Message ReadUntil(std::uint16_t interface_code, std::uint16_t index);

 private:
  [[noreturn]] static void Fail(const char* what);
  Message Next();

  LineClient socket_;
  std::string banner_;
  std::deque<Message> kept_;
};

}  // namespace ccmorse::testing
