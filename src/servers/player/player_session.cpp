#include "servers/player/player_session.h"

#include <algorithm>
#include <utility>

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

constexpr std::uint32_t kThisMachine = 0x0100007fU;  // 127.0.0.1 as the server packs it (B.2)
constexpr std::uint8_t kOpen = 1;
constexpr std::uint8_t kClose = 2;
constexpr std::uint8_t kError = 3;
constexpr std::uint8_t kPush = 1;
constexpr std::uint8_t kPull = 2;
constexpr int kMostTimes = 1000;  // that a client may subscribe to one device

std::shared_ptr<const wire::Bytes> Shared(wire::Bytes bytes) {
  return std::make_shared<const wire::Bytes>(std::move(bytes));
}

}  // namespace

PlayerSession::PlayerSession(const DeviceList& devices, std::uint32_t port,
                             std::function<double()> now, const SessionLimits& limits)
    : devices_(devices),
      port_(port),
      now_(std::move(now)),
      limits_(limits),
      reader_(limits.longest_body) {}

PlayerSession::~PlayerSession() {
  for (const auto& [device, times] : subscriptions_) {
    for (int i = 0; i < times; ++i) device->Unsubscribe(*this);
  }
}

bool PlayerSession::ServeNext() {
  const std::optional<wire::Message> message = reader_.Next();
  if (!message) return false;
  Serve(*message);
  return true;
}

void PlayerSession::Serve(const wire::Message& message) {
  const wire::Header& header = message.header;
  const bool request = header.type == MessageType::kRequest;
  // Answers, data and marks are the server's to send.
  if (!request && header.type != MessageType::kCommand) return;
  if (header.address.interf == wire::kPlayer) {
    if (request) ServePlayer(message);
    return;
  }
  Device* const device = devices_.Find(header.address.interf, header.address.index);
  if (!request) {
    // Only who has subscribed may drive: when the last one leaves, the robot must stop (H10).
    if (device != nullptr && FindSubscription(device) != subscriptions_.end()) {
      device->Command(header.subtype, wire::Body(message.body));
    }
    return;
  }
  Reply reply;
  if (device == nullptr || !device->Request(header.subtype, wire::Body(message.body), reply)) {
    return Refuse(header);
  }
  Acknowledge(header, reply.body().empty() ? nullptr : Shared(reply.body().ToBytes()));
}

void PlayerSession::ServePlayer(const wire::Message& message) {
  const wire::Header& header = message.header;
  const wire::Body body(message.body);
  switch (header.subtype) {
    case wire::kPlayerReqDevlist: {
      wire::DeviceDevlist list;
      for (const auto& device : devices_.all()) list.devices.push_back(AddressOf(*device));
      return AcknowledgeWith(header, list);
    }
    case wire::kPlayerReqDriverinfo: {
      wire::DeviceDriverinfo info;
      if (!body.To(info)) return Refuse(header);
      const Device* const device = devices_.Find(info.addr.interf, info.addr.index);
      if (device == nullptr) return Refuse(header);
      info.addr = AddressOf(*device);
      info.driver_name = device->driver();
      return AcknowledgeWith(header, info);
    }
    case wire::kPlayerReqDev:
      return ServeSubscription(message);
    case wire::kPlayerReqData:
      if (!pull_) return Refuse(header);
      reads_ = asked_ = true;
      sent_data_ = false;
      return Acknowledge(header, nullptr, true);
    case wire::kPlayerReqDatamode: {
      wire::DeviceDatamodeReq wanted;
      if (!body.To(wanted) || (wanted.mode != kPush && wanted.mode != kPull)) return Refuse(header);
      pull_ = wanted.mode == kPull;
      if (!pull_) asked_ = false;
      reads_ = reads_ && pull_;
      return Acknowledge(header);
    }
    case wire::kPlayerReqAddReplaceRule:
      return AddRule(body) ? Acknowledge(header) : Refuse(header);
    default:
      return Refuse(header);
  }
}

void PlayerSession::ServeSubscription(const wire::Message& message) {
  wire::DeviceReq wanted;
  const bool whole = wire::Body(message.body).To(wanted);
  Device* const device = devices_.Find(wanted.addr.interf, wanted.addr.index);
  if (!whole || device == nullptr || (wanted.access != kOpen && wanted.access != kClose)) {
    // As the real server refuses (B.5): the address, access 3 and a driver without a name.
    wire::Bytes refusal;
    wire::XdrWriter writer(refusal);
    writer.Value(wanted.addr);
    writer.Value(kError);
    writer.Value(std::uint32_t{0});
    writer.Value(std::uint32_t{0});
    return Refuse(message.header, Shared(std::move(refusal)));
  }
  if (wanted.access == kOpen) {
    const auto found = FindSubscription(device);
    if (found != subscriptions_.end() && found->second >= kMostTimes) return Refuse(message.header);
    if (found == subscriptions_.end()) {
      subscriptions_.emplace_back(device, 1);
    } else {
      ++found->second;
    }
    device->Subscribe(*this);
  } else if (const auto found = FindSubscription(device); found != subscriptions_.end()) {
    if (--found->second == 0) subscriptions_.erase(found);
    device->Unsubscribe(*this);
  }
  wanted.addr = AddressOf(*device);
  wanted.driver_name = device->driver();
  AcknowledgeWith(message.header, wanted);
}

std::vector<std::pair<Device*, int>>::iterator PlayerSession::FindSubscription(
    const Device* device) {
  return std::find_if(subscriptions_.begin(), subscriptions_.end(),
                      [&](const auto& each) { return each.first == device; });
}

bool PlayerSession::AddRule(const wire::Body& body) {
  wire::AddReplaceRuleReq wanted;
  if (!body.To(wanted) || wanted.replace < 0 || wanted.replace > 2) return false;
  const ReplaceRule rule{wanted.interf, wanted.index, wanted.type, wanted.subtype,
                         static_cast<Rule>(wanted.replace)};
  for (ReplaceRule& each : rules_) {
    if (each.interface_code == rule.interface_code && each.index == rule.index &&
        each.type == rule.type && each.subtype == rule.subtype) {
      each.rule = rule.rule;
      return true;
    }
  }
  if (rules_.size() >= limits_.most_rules) return false;
  rules_.push_back(rule);
  return true;
}

PlayerSession::Rule PlayerSession::RuleFor(const wire::Header& header) const {
  const auto matches = [](std::int32_t pattern, std::int32_t value) {
    return pattern == -1 || pattern == value;
  };
  for (const ReplaceRule& each : rules_) {
    if (matches(each.interface_code, header.address.interf) &&
        matches(each.index, header.address.index) &&
        matches(each.type, static_cast<std::int32_t>(header.type)) &&
        matches(each.subtype, header.subtype)) {
      return each.rule;
    }
  }
  return Rule::kAccept;
}

bool PlayerSession::AwaitsDataAt(double time) const {
  constexpr double kRounding = 1e-6;
  return waits() && time > newest_ + spacing_ - kRounding;
}

void PlayerSession::Data(const DataMessage& message) {
  if (const double now = now_(); now > newest_) {
    spacing_ = now - newest_;
    newest_ = now;
  }
  wire::Header header;
  header.address = AddressOf(message.device());
  header.type = MessageType::kData;
  header.subtype = message.subtype();
  header.time = message.time();
  const Rule rule = RuleFor(header);
  if (rule == Rule::kIgnore) return;
  if (rule == Rule::kReplace) {
    const auto old = std::find_if(queue_.begin(), queue_.end(), [&](const Queued& each) {
      return each.is_data && each.header.address == header.address &&
             each.header.subtype == header.subtype;
    });
    if (old != queue_.end()) {
      queued_bytes_ -= old->body->size();
      queue_.erase(old);
    }
  }
  if (queue_.size() >= limits_.most_queued ||
      queued_bytes_ + message.bytes()->size() > limits_.most_queued_bytes) {
    ++dropped_;
    return;
  }
  queued_bytes_ += message.bytes()->size();
  queue_.push_back({header, message.bytes(), true});
}

void PlayerSession::Acknowledge(const wire::Header& request,
                                std::shared_ptr<const wire::Bytes> body, bool first) {
  Answer(request, MessageType::kAck, std::move(body), first);
}

void PlayerSession::Refuse(const wire::Header& request, std::shared_ptr<const wire::Bytes> body) {
  Answer(request, MessageType::kNack, std::move(body), false);
}

template <typename Struct>
void PlayerSession::AcknowledgeWith(const wire::Header& request, const Struct& body) {
  Acknowledge(request, Shared(wire::Encode(body)));
}

void PlayerSession::Answer(const wire::Header& request, MessageType type,
                           std::shared_ptr<const wire::Bytes> body, bool first) {
  Queued reply;
  reply.header.address = {kThisMachine, port_, request.address.interf, request.address.index};
  reply.header.type = type;
  reply.header.subtype = request.subtype;
  reply.header.time = now_();
  reply.body = std::move(body);
  reply.is_data = false;
  if (reply.body != nullptr) queued_bytes_ += reply.body->size();
  ++replies_;
  if (first) {
    queue_.push_front(std::move(reply));
  } else {
    queue_.push_back(std::move(reply));
  }
}

wire::Devaddr PlayerSession::AddressOf(const Device& device) const {
  return {kThisMachine, port_, device.interface_code(), device.index()};
}

void PlayerSession::Send(std::string& out) {
  const Queued& next = queue_.front();
  if (next.is_data) {
    sent_data_ = true;
  } else {
    --replies_;
  }
  if (next.body != nullptr) {
    queued_bytes_ -= next.body->size();
    wire::Append(next.header, *next.body, out);
  } else {
    wire::Append(next.header, {}, out);
  }
  queue_.pop_front();
}

void PlayerSession::Synchronise(std::string& out) {
  wire::Header mark;
  mark.address = {kThisMachine, port_, wire::kPlayer, 0};
  mark.type = MessageType::kSynch;
  mark.subtype = dropped_ > 0 ? wire::kPlayerSynchOverflow : wire::kPlayerSynchOk;
  mark.time = now_();
  if (dropped_ > 0) {
    wire::Append(mark, wire::Encode(wire::Overflow{dropped_}), out);
  } else {
    wire::Append(mark, {}, out);
  }
  dropped_ = 0;
}

void PlayerSession::Deliver(std::string& out) {
  if (!pull_ || asked_) {
    while (!queue_.empty()) Send(out);
    // Never a mark without data: the client would take it for an error (H3).
    if (asked_ && sent_data_) {
      asked_ = false;
      Synchronise(out);
    }
    return;
  }
  while (replies_ > 0) Send(out);
}

}  // namespace ccmorse::servers::player
