#include "tests/support/player_wire_client.h"

#include <stdexcept>

namespace ccmorse::testing {

namespace wire = ccmorse::wire::player;

PlayerWireClient::PlayerWireClient(int port) : socket_(port) {
  const auto banner = socket_.ReadBytes(wire::kBannerSize);
  if (!banner) Fail("no banner");
  banner_ = *banner;
}

void PlayerWireClient::Fail(const char* what) {
  throw std::runtime_error(std::string("Player client: ") + what);
}

void PlayerWireClient::Send(wire::MessageType type, std::uint16_t interface_code,
                            std::uint16_t index, std::uint8_t subtype, const wire::Bytes& body) {
  wire::Header header;
  header.address = {0, 0, interface_code, index};
  header.type = type;
  header.subtype = subtype;
  std::string bytes;
  wire::Append(header, body, bytes);
  socket_.Send(bytes);
}

std::optional<PlayerWireClient::Message> PlayerWireClient::Receive(
    std::chrono::milliseconds timeout) {
  const auto head = socket_.ReadBytes(wire::kHeaderSize, timeout);
  if (!head) return {};
  const wire::Bytes bytes(head->begin(), head->end());
  wire::XdrReader reader(bytes);
  Message message;
  std::uint8_t type = 0;
  reader.Value(message.header.address);
  reader.Value(type);
  reader.Value(message.header.subtype);
  reader.Value(message.header.time);
  reader.Value(message.header.sequence);
  reader.Value(message.header.size);
  message.header.type = static_cast<wire::MessageType>(type);
  if (message.header.size > 0) {
    const auto body = socket_.ReadBytes(message.header.size, timeout);
    if (!body) Fail("a message is cut short");
    message.body.assign(body->begin(), body->end());
  }
  return message;
}

PlayerWireClient::Message PlayerWireClient::Next() {
  auto message = Receive();
  if (!message) Fail("the server is silent");
  return *message;
}

PlayerWireClient::Message PlayerWireClient::Request(std::uint16_t interface_code,
                                                    std::uint16_t index, std::uint8_t subtype,
                                                    const wire::Bytes& body) {
  Send(wire::MessageType::kRequest, interface_code, index, subtype, body);
  for (;;) {
    Message message = Next();
    if (message.header.type != wire::MessageType::kAck &&
        message.header.type != wire::MessageType::kNack) {
      kept_.push_back(std::move(message));
      continue;
    }
    if (message.header.address.interf != interface_code || message.header.address.index != index ||
        message.header.subtype != subtype) {
      Fail("a reply to another request");
    }
    return message;
  }
}

std::string PlayerWireClient::Subscribe(std::uint16_t interface_code, std::uint16_t index) {
  wire::DeviceReq wanted;
  wanted.addr = {0, 0, interface_code, index};
  wanted.access = 1;
  return Get<wire::DeviceReq>(wire::kPlayer, 0, wire::kPlayerReqDev, wire::Encode(wanted))
      .driver_name;
}

void PlayerWireClient::Unsubscribe(std::uint16_t interface_code, std::uint16_t index) {
  wire::DeviceReq wanted;
  wanted.addr = {0, 0, interface_code, index};
  wanted.access = 2;
  Get<wire::DeviceReq>(wire::kPlayer, 0, wire::kPlayerReqDev, wire::Encode(wanted));
}

void PlayerWireClient::SetPull(bool pull) {
  wire::DeviceDatamodeReq wanted;
  wanted.mode = pull ? 2 : 1;
  if (RequestWith(wire::kPlayer, 0, wire::kPlayerReqDatamode, wanted).header.type !=
      wire::MessageType::kAck) {
    Fail("no data mode");
  }
}

std::vector<PlayerWireClient::Message> PlayerWireClient::Read() {
  Send(wire::MessageType::kRequest, wire::kPlayer, 0, wire::kPlayerReqData);
  std::vector<Message> round(kept_.begin(), kept_.end());
  kept_.clear();
  bool acknowledged = false;
  for (;;) {
    Message message = Next();
    if (message.header.type == wire::MessageType::kAck) {
      if (acknowledged) Fail("two ACKs in a round");
      acknowledged = true;
      continue;
    }
    if (!acknowledged) Fail("a round without ACK");
    round.push_back(std::move(message));
    if (round.back().header.type == wire::MessageType::kSynch) return round;
  }
}

PlayerWireClient::Message PlayerWireClient::ReadUntil(std::uint16_t interface_code,
                                                      std::uint16_t index) {
  constexpr int kMostRounds = 200;
  for (int i = 0; i < kMostRounds; ++i) {
    const std::vector<Message> round = Read();
    for (auto message = round.rbegin(); message != round.rend(); ++message) {
      if (message->header.type == wire::MessageType::kData &&
          message->header.address.interf == interface_code &&
          message->header.address.index == index) {
        return *message;
      }
    }
  }
  Fail("no data of a device");
}

}  // namespace ccmorse::testing
