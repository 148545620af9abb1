#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "servers/player/device.h"
#include "wire/player/frame.h"

namespace ccmorse::servers::player {

/// What bounds one client's session.
struct SessionLimits {
  std::size_t longest_body = 1U << 20;  ///< bytes of a message from the client
  std::size_t most_queued = 1024;       ///< messages waiting for the client; data beyond are lost
  std::size_t most_queued_bytes = 16U << 20;  ///< of them; data beyond are lost
  std::size_t most_rules = 256;               ///< replace rules
};

/// The server's side of one Player client (specs: player.md B): what it has subscribed to, its data
/// mode, its replace rules and the queue of what waits for it. Takes the client's bytes and writes
/// what is to be sent; knows no socket. One thread.
class PlayerSession : public Subscriber {
 public:
  /// `port` is what the addresses of messages call the robot; `now` gives simulated time, s. All
  /// that is referred to outlives the session.
  PlayerSession(const DeviceList& devices, std::uint32_t port, std::function<double()> now,
                const SessionLimits& limits = {});
  ~PlayerSession() override;
  PlayerSession(const PlayerSession&) = delete;
  PlayerSession& operator=(const PlayerSession&) = delete;

  /// The client's next bytes; ServeNext() works on them.
  void Take(std::string_view bytes) { reader_.Append(bytes); }
  /// Serves the next whole message; false when there is none. Not to be called after broken().
  bool ServeNext();
  /// What came is no stream of messages, or one is longer than the limit. The client is to be let
  /// go.
  bool broken() const { return reader_.broken(); }

  /// Appends what may be sent now. In the mode PUSH that is all there is; in PULL, after the client
  /// has asked for data, the same, and the SYNCH that ends a round once it held any data; else
  /// replies and what was queued before them (B.6).
  void Deliver(std::string& out);

  /// Has the client ever asked for data, as one does in the mode PULL?
  bool reads() const { return reads_; }
  /// It has, and there are none yet.
  bool waits() const { return asked_ && queue_.empty(); }
  /// It waits, and by simulated time `time`, s, data will be there if they go on to come at the
  /// distance of the last two.
  bool AwaitsDataAt(double time) const;

  /// Is there anything that Deliver() would send?
  bool pending() const { return replies_ > 0 || (!queue_.empty() && (!pull_ || asked_)); }

  void Data(const DataMessage& message) override;

  std::size_t queued() const { return queue_.size(); }        ///< messages
  std::size_t queued_bytes() const { return queued_bytes_; }  ///< of their bodies
  std::uint32_t dropped() const { return dropped_; }          ///< since the last SYNCH

 private:
  // Replace rules, by Player's numbers.
  enum class Rule : std::uint8_t { kAccept = 0, kReplace = 1, kIgnore = 2 };
  struct ReplaceRule {
    std::int32_t interface_code, index, type, subtype;  // -1: any
    Rule rule;
  };
  struct Queued {
    wire::Header header;
    std::shared_ptr<const wire::Bytes> body;  // nullptr: none
    bool is_data;
  };

  void Serve(const wire::Message& message);
  std::vector<std::pair<Device*, int>>::iterator FindSubscription(const Device* device);
  void ServePlayer(const wire::Message& message);
  void ServeSubscription(const wire::Message& message);
  void Acknowledge(const wire::Header& request, std::shared_ptr<const wire::Bytes> body = nullptr,
                   bool first = false);
  void Refuse(const wire::Header& request, std::shared_ptr<const wire::Bytes> body = nullptr);
  void Answer(const wire::Header& request, wire::MessageType type,
              std::shared_ptr<const wire::Bytes> body, bool first);
  template <typename Struct>
  void AcknowledgeWith(const wire::Header& request, const Struct& body);
  bool AddRule(const wire::Body& body);
  Rule RuleFor(const wire::Header& header) const;
  wire::Devaddr AddressOf(const Device& device) const;
  void Send(std::string& out);  // the first of the queue
  void Synchronise(std::string& out);

  const DeviceList& devices_;
  std::uint32_t port_;
  std::function<double()> now_;
  SessionLimits limits_;
  wire::FrameReader reader_;
  std::vector<ReplaceRule> rules_;
  std::vector<std::pair<Device*, int>> subscriptions_;  // and how often; in their order
  std::deque<Queued> queue_;
  std::size_t queued_bytes_ = 0;
  std::size_t replies_ = 0;  // in the queue
  std::uint32_t dropped_ = 0;
  bool pull_ = false;
  bool asked_ = false;
  bool sent_data_ = false;  // since it asked
  bool reads_ = false;
  // When data came, simulated, s: last, and how long after the time before.
  double newest_ = -std::numeric_limits<double>::infinity();
  double spacing_ = std::numeric_limits<double>::infinity();
};

}  // namespace ccmorse::servers::player
