#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "wire/player/body.h"
#include "wire/player/frame.h"

namespace ccmorse::servers::player {

namespace wire = ccmorse::wire::player;

class Device;

/// What a request is answered with: a body, or none.
class Reply {
 public:
  template <typename Struct>
  void Set(Struct value) {
    const auto held = std::make_shared<Struct>(std::move(value));
    body_ = wire::Body::Of(*held);
    held_ = held;
  }
  /// A body that is packed already.
  void SetBytes(wire::Bytes bytes) {
    const auto held = std::make_shared<wire::Bytes>(std::move(bytes));
    body_ = wire::Body(std::span<const std::uint8_t>(*held));
    held_ = held;
  }
  /// Valid as long as the reply.
  const wire::Body& body() const { return body_; }

 private:
  wire::Body body_;
  std::shared_ptr<const void> held_;
};

/// Data that a device publishes; it lives for the call that hands it on.
class DataMessage {
 public:
  DataMessage(const Device& device, std::uint8_t subtype, double time, const wire::Body& body)
      : device_(device), subtype_(subtype), time_(time), body_(body) {}

  const Device& device() const { return device_; }
  std::uint8_t subtype() const { return subtype_; }
  double time() const { return time_; }  ///< s, simulated
  const wire::Body& body() const { return body_; }
  /// The body as bytes, packed once for all who want it so.
  const std::shared_ptr<const wire::Bytes>& bytes() const {
    if (bytes_ == nullptr) bytes_ = std::make_shared<const wire::Bytes>(body_.ToBytes());
    return bytes_;
  }

 private:
  const Device& device_;
  std::uint8_t subtype_;
  double time_;
  const wire::Body& body_;
  mutable std::shared_ptr<const wire::Bytes> bytes_;
};

/// Whoever has subscribed to devices: a connection, or a driver.
class Subscriber {
 public:
  virtual ~Subscriber() = default;
  virtual void Data(const DataMessage& message) = 0;
};

/// One interface at one index (specs: player.md A.2, B.2): what a Player client subscribes to. It
/// may show a robot's sensor, do to the simulation what services can, or be provided by a driver.
/// Requests and commands come from connections as bytes, from within the program as structs; both
/// are a wire::Body. Used by the thread of the run only.
class Device {
 public:
  /// Messages that the device understands, for the capability request (B.4).
  using Capabilities = std::initializer_list<std::pair<wire::MessageType, std::uint8_t>>;

  /// `driver`: the name that clients are told.
  Device(std::uint16_t interface_code, std::uint16_t index, std::string driver,
         Capabilities capabilities);
  virtual ~Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  std::uint16_t interface_code() const { return interface_; }
  std::uint16_t index() const { return index_; }
  const std::string& driver() const { return driver_; }
  bool HasCapability(wire::MessageType type, std::uint8_t subtype) const;

  /// A subscriber is counted as often as it subscribes, and gets each message once. The device and
  /// the subscriber must part by Unsubscribe() before either goes.
  void Subscribe(Subscriber& subscriber);
  /// Nothing when it has not subscribed.
  void Unsubscribe(Subscriber& subscriber);
  bool IsSubscribed(const Subscriber& subscriber) const;
  bool subscribed() const { return !subscribers_.empty(); }

  /// False: NACK. Handles the universal requests, properties, and hands on the others that
  /// capabilities name.
  bool Request(std::uint8_t subtype, const wire::Body& body, Reply& reply);
  /// One that is wrong is dropped: commands have no answer.
  void Command(std::uint8_t subtype, const wire::Body& body);

  /// After each Simulation::Sense() while anyone is subscribed: acts on what the sensors show and
  /// publishes what is new.
  virtual void Step() {}

 protected:
  /// Sends data to all subscribers, stamped with simulated time (s). As clients take a message for
  /// new only by its time (H4), that is raised a little where it would not grow.
  void Publish(std::uint8_t subtype, double time, const wire::Body& body);

  /// One more message that it understands.
  void AddCapability(wire::MessageType type, std::uint8_t subtype) {
    if (!HasCapability(type, subtype)) capabilities_.emplace_back(type, subtype);
  }

  virtual bool Ask(std::uint8_t /*subtype*/, const wire::Body& /*body*/, Reply& /*reply*/) {
    return false;
  }
  virtual void Tell(std::uint8_t /*subtype*/, const wire::Body& /*body*/) {}
  virtual void FirstSubscribed() {}
  /// There is no other watchdog: whatever drives stops now (H10).
  virtual void LastLeft() {}

 private:
  using Property = std::variant<std::int32_t, double, std::string, bool>;
  struct Listener {
    Subscriber* subscriber;
    int times;
  };

  bool Universal(std::uint8_t subtype, const wire::Body& body, Reply& reply);
  template <typename Struct, typename Value>
  bool GetProperty(const wire::Body& body, Reply& reply) const;
  template <typename Struct, typename Value>
  bool SetProperty(const wire::Body& body);

  std::uint16_t interface_;
  std::uint16_t index_;
  std::string driver_;
  std::vector<std::pair<wire::MessageType, std::uint8_t>> capabilities_;
  std::vector<Listener> subscribers_;
  double last_time_ = 0.0;
  std::map<std::string, Property> properties_;
};

/// The devices of one port.
class DeviceList {
 public:
  /// Throws Error when its address is there already.
  void Add(std::shared_ptr<Device> device);
  /// nullptr when there is none.
  Device* Find(std::uint16_t interface_code, std::uint16_t index) const;
  const std::vector<std::shared_ptr<Device>>& all() const { return devices_; }

 private:
  std::vector<std::shared_ptr<Device>> devices_;
};

}  // namespace ccmorse::servers::player
