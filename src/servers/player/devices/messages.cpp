#include "servers/player/devices/messages.h"

#include <chrono>
#include <cmath>

#include "base/json.h"
#include "base/log.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

constexpr std::size_t kLongest = 200;  // bytes of a line in the log
constexpr int kPerSecond = 5;

}  // namespace

Speech::Speech(const std::string& robot, std::uint16_t index)
    : Device(wire::kSpeech, index, "ccmorse", {{MessageType::kCommand, wire::kSpeechCmdSay}}),
      robot_(robot) {}

void Speech::Tell(std::uint8_t /*subtype*/, const wire::Body& body) {
  wire::SpeechCmd command;
  if (!body.To(command)) return;
  const double now = std::floor(
      std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count());
  if (now != second_) said_ = 0;
  second_ = now;
  if (++said_ > kPerSecond) return;
  // As JSON, which has a form for whatever bytes there are.
  LogInfo("{} says {}", robot_, Json(command.string.substr(0, kLongest)).Dump());
}

Opaque::Opaque(DeviceContext context, std::uint16_t index)
    : Device(wire::kOpaque, index, "ccmorse",
             {{MessageType::kData, wire::kOpaqueDataState},
              {MessageType::kCommand, wire::kOpaqueCmdData},
              {MessageType::kRequest, wire::kOpaqueReqData}}),
      context_(context) {}

void Opaque::Tell(std::uint8_t /*subtype*/, const wire::Body& body) {
  wire::OpaqueData data;
  if (!body.To(data)) return;
  Publish(wire::kOpaqueDataState, context_.simulation.time(), wire::Body::Of(data));
}

bool Opaque::Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) {
  wire::OpaqueData data;
  if (!body.To(data)) return false;
  Tell(subtype, body);
  reply.Set(std::move(data));
  return true;
}

}  // namespace ccmorse::servers::player
