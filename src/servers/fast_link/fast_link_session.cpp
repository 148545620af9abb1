#include "servers/fast_link/fast_link_session.h"

#include <algorithm>
#include <utility>

#include "wire/canvas_code.h"

namespace ccmorse::servers {
namespace {

wire::DataForm FormOf(const sim::Sensor& sensor) {
  switch (sensor.number_form()) {
    case sim::NumberForm::kPose:
      return wire::DataForm::kPose;
    case sim::NumberForm::kOdometry:
      return wire::DataForm::kOdometry;
    case sim::NumberForm::kScan:
      return wire::DataForm::kScan;
    case sim::NumberForm::kNone:
      break;
  }
  return wire::DataForm::kText;
}

}  // namespace

FastLinkSession::FastLinkSession(sim::Simulation& simulation, ServiceDirectory& directory,
                                 Refuse refuse)
    : simulation_(simulation), directory_(directory), refuse_(std::move(refuse)) {}

bool FastLinkSession::Take(const wire::Frame& frame) {
  switch (frame.type) {
    case wire::FrameType::kCommand:
      return TakeCommand(frame.payload);
    case wire::FrameType::kDeclare:
      return TakeDeclare(frame.payload);
    case wire::FrameType::kSubscribe:
      return TakeSubscribe(frame.payload);
    case wire::FrameType::kImage:
      return TakeImage(frame.payload);
    case wire::FrameType::kPixels:
      return TakePixels(frame.payload);
    default:
      return false;
  }
}

const FastLinkSession::Declared* FastLinkSession::Find(std::uint16_t service) const {
  return service < declared_.size() ? declared_[service].get() : nullptr;
}

bool FastLinkSession::TakeDeclare(std::string_view payload) {
  wire::DeclareMessage message;
  if (!wire::ParseDeclare(payload, &message) || Find(message.id) != nullptr) return false;
  if (message.id >= declared_.size()) declared_.resize(std::size_t{message.id} + 1);
  auto declared = std::make_unique<Declared>();
  declared->target = directory_.Find(message.component, message.service);
  declared->name = message.service;
  // A service that takes its time may end when the client has long left.
  declared->done = [weak = weak_from_this(), id = message.id](const sim::ServiceResult& result) {
    if (result.outcome == sim::Outcome::kSuccess) return;
    if (const auto self = weak.lock()) self->refuse_(id, result.value);
  };
  declared_[message.id] = std::move(declared);
  return true;
}

bool FastLinkSession::TakeCommand(std::string_view payload) {
  wire::CommandMessage message;
  if (!wire::ParseCommand(payload, &message)) return false;
  const Declared* const declared = Find(message.service);
  if (declared == nullptr) return false;
  if (declared->target.service == nullptr) {
    refuse_(message.service, Json(ServiceDirectory::NotRegistered(declared->name)));
    return true;
  }
  arguments_.resize(message.count);
  std::copy_n(message.numbers.begin(), message.count, arguments_.begin());
  directory_.Run(declared->target, arguments_, declared->done);
  return true;
}

bool FastLinkSession::TakeSubscribe(std::string_view payload) {
  wire::SubscribeMessage message;
  if (!wire::ParseSubscribe(payload, &message)) return false;
  auto* const sensor = message.form == wire::DataForm::kNone
                           ? nullptr
                           : dynamic_cast<sim::Sensor*>(simulation_.FindComponent(message.device));
  // A number stands for one device, and a device has one number: the newest.
  std::erase_if(subscriptions_, [&](const Subscription& subscription) {
    return subscription.id == message.id || subscription.sensor == sensor;
  });
  if (sensor == nullptr) return true;  // what has no data is left out
  const bool as_numbers = message.form != wire::DataForm::kText && message.form == FormOf(*sensor);
  subscriptions_.push_back({message.id, as_numbers ? message.form : wire::DataForm::kText, sensor});
  return true;
}

void FastLinkSession::RunBytes(const Declared& declared, std::string_view bytes) {
  if (declared.target.service == nullptr) {
    declared.done({sim::Outcome::kFailed, Json(ServiceDirectory::NotRegistered(declared.name))});
    return;
  }
  directory_.RunBytes(declared.target, bytes, declared.done);
}

bool FastLinkSession::TakeImage(std::string_view payload) {
  wire::ByteReader reader(payload);
  const Declared* const declared = Find(reader.Short());
  const int width = reader.Short();
  const int height = reader.Short();
  const std::size_t cells = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (!reader.ok() || declared == nullptr || cells > wire::kMostCells) return false;
  if (width != image_width_ || height != image_height_) {
    image_.assign(cells * wire::kCellBytes, 0);
    image_width_ = width;
    image_height_ = height;
  }
  if (!wire::ApplyChanges(reader.rest(), image_, width, height)) return false;
  RunBytes(*declared, {reinterpret_cast<const char*>(image_.data()), image_.size()});
  return true;
}

bool FastLinkSession::TakePixels(std::string_view payload) {
  wire::ByteReader reader(payload);
  const Declared* const declared = Find(reader.Short());
  plain_.clear();
  if (!reader.ok() || declared == nullptr || !wire::ExpandRectangles(reader.rest(), &plain_)) {
    return false;
  }
  RunBytes(*declared, plain_);
  return true;
}

void FastLinkSession::AppendData(std::string& out, double time) {
  wire::FrameWriter frame(out, wire::FrameType::kData);
  frame.Double(time);
  for (const Subscription& subscription : subscriptions_) {
    frame.Short(subscription.id);
    frame.Byte(static_cast<std::uint8_t>(subscription.form));
    if (subscription.form == wire::DataForm::kText) {
      const std::string& text = subscription.sensor->LocalData();
      frame.Long(static_cast<std::uint32_t>(text.size()));
      frame.Double(subscription.sensor->timestamp());
      frame.Bytes(text);
    } else {
      numbers_.clear();
      subscription.sensor->AppendNumbers(numbers_);
      frame.Long(static_cast<std::uint32_t>(numbers_.size() * sizeof(double)));
      frame.Double(subscription.sensor->timestamp());
      frame.Doubles(numbers_.data(), numbers_.size());
    }
  }
}

}  // namespace ccmorse::servers
