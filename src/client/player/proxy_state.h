#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "client/player/backend.h"
#include "libCCMorse/MorseError.h"
#include "libplayerc++/clientproxy.h"

namespace PlayerCc {

namespace wire = ccmorse::wire::player;
using CCMorse::MorseError;
using CCMorse::playerlink::Answer;

/// The length of a list, as Player's messages count it.
template <typename Items>
std::uint32_t Count(const Items& items) {
  return static_cast<std::uint32_t>(items.size());
}

/// A number as most of Player's messages carry it.
inline float Single(double value) { return static_cast<float>(value); }

/// What PlayerClient and its proxies share, so that either may go first.
class ClientCore {
 public:
  explicit ClientCore(std::unique_ptr<CCMorse::playerlink::PlayerBackend> b)
      : backend(std::move(b)) {}
  const std::unique_ptr<CCMorse::playerlink::PlayerBackend> backend;
};

/// What a proxy knows. It is apart from the proxy, so that a Read() in another thread never touches
/// a proxy that is being deleted. Fields are under `mutex` unless said otherwise.
class ProxyState : public CCMorse::playerlink::DataSink {
 public:
  bool OnData(const CCMorse::playerlink::DataMessage& message) final;
  void Signal() override;

  Mutex mutex;                                            // the client's; fixed
  std::shared_ptr<ClientCore> core;                       // fixed; outlives the link
  std::unique_ptr<CCMorse::playerlink::DeviceLink> link;  // fixed once subscribed
  bool valid = false;
  bool fresh = false;
  bool received = false;  // any valid data at all
  double time = 0.0;
  double elapsed = 0.0;
  int next_connection = 1;
  std::vector<std::pair<int, ClientProxy::read_signal_t>> subscribers;

 protected:
  /// Takes a message of the device, `mutex` held; false when it is none that the proxy knows, or
  /// broken.
  virtual bool Take(std::uint8_t subtype, const wire::Body& body) = 0;
  /// Whether Signal() is due although the data are no newer; `mutex` held.
  virtual bool Pending() const { return false; }
};

/// The state of a proxy that never gets data.
class NoState : public ProxyState {
 protected:
  bool Take(std::uint8_t /*subtype*/, const wire::Body& /*body*/) override { return false; }
};

/// Decodes a body into `value`, which stays as it is when the body is something else.
template <typename Struct>
bool Keep(const wire::Body& body, Struct& value) {
  thread_local Struct next;  // keeps the capacity of its arrays
  if (!body.To(next)) return false;
  std::swap(next, value);
  return true;
}

/// The state of a proxy with one kind of data.
template <typename Data, std::uint8_t kSubtype>
class SimpleState : public ProxyState {
 public:
  Data data;

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    return subtype == kSubtype && Keep(body, data);
  }
};

/// Access to a proxy's state with its mutex held for as long as this lives.
template <class State>
class Locked {
 public:
  explicit Locked(State& state) : lock_(state.mutex), state_(state) {}
  State* operator->() const { return &state_; }
  State& operator*() const { return state_; }

 private:
  const std::unique_lock<Mutex> lock_;
  State& state_;
};

template <class State>
Locked<State> ClientProxy::In() const {
  return Locked<State>(static_cast<State&>(*state_));
}

// --- Messages of a proxy

template <typename Struct>
void Command(ProxyState& state, std::uint8_t subtype, const Struct& body) {
  state.link->Command(subtype, wire::Body::Of(body));
}
inline void Command(ProxyState& state, std::uint8_t subtype) {
  state.link->Command(subtype, wire::Body());
}

inline Answer Ask(ProxyState& state, std::uint8_t subtype) {
  return state.link->Request(subtype, wire::Body(), [](const wire::Body&) {});
}
template <typename Struct>
Answer Ask(ProxyState& state, std::uint8_t subtype, const Struct& body) {
  return state.link->Request(subtype, wire::Body::Of(body), [](const wire::Body&) {});
}
/// A request whose answer is taken into `reply`; one that cannot be read counts as refused.
template <typename Reply>
Answer AskFor(ProxyState& state, std::uint8_t subtype, const wire::Body& body, Reply& reply) {
  bool read = false;
  Answer answer =
      state.link->Request(subtype, body, [&](const wire::Body& bytes) { read = bytes.To(reply); });
  if (answer.ok() && !read) answer = {Answer::Kind::kNack, "the answer cannot be read"};
  return answer;
}
template <typename Reply>
Answer AskFor(ProxyState& state, std::uint8_t subtype, Reply& reply) {
  return AskFor(state, subtype, wire::Body(), reply);
}
/// Throws MorseError from `function` unless it was answered well.
void Require(const Answer& answer, const char* function);

/// Element `index`; throws MorseError from `function` when there is none.
template <typename Items>
const auto& At(const Items& items, std::size_t index, const char* function) {
  if (index >= items.size()) {
    throw MorseError("index " + std::to_string(index) + " of " + std::to_string(items.size()),
                     function);
  }
  return items[index];
}

// --- Player's structs and ours

inline player_point_2d_t ToC(const wire::Point2d& v) { return {v.px, v.py}; }
inline player_point_3d_t ToC(const wire::Point3d& v) { return {v.px, v.py, v.pz}; }
inline player_orientation_3d_t ToC(const wire::Orientation3d& v) {
  return {v.proll, v.ppitch, v.pyaw};
}
inline player_pose2d_t ToC(const wire::Pose2d& v) { return {v.px, v.py, v.pa}; }
inline player_pose3d_t ToC(const wire::Pose3d& v) {
  return {v.px, v.py, v.pz, v.proll, v.ppitch, v.pyaw};
}
inline player_bbox2d_t ToC(const wire::Bbox2d& v) { return {v.sw, v.sl}; }
inline player_bbox3d_t ToC(const wire::Bbox3d& v) { return {v.sw, v.sl, v.sh}; }
inline player_color_t ToC(const wire::Color& v) { return {v.alpha, v.red, v.green, v.blue}; }

inline wire::Pose2d FromC(const player_pose2d_t& v) { return {v.px, v.py, v.pa}; }
inline wire::Pose3d FromC(const player_pose3d_t& v) {
  return {v.px, v.py, v.pz, v.proll, v.ppitch, v.pyaw};
}
inline wire::Color FromC(const player_color_t& v) { return {v.alpha, v.red, v.green, v.blue}; }
inline std::uint8_t Flag(bool value) { return value ? 1 : 0; }

}  // namespace PlayerCc
