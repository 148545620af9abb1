#include "client/player/player_wire_backend.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "client/core/address.h"
#include "client/core/tcp_connect.h"
#include "libCCMorse/MorseError.h"
#include "wire/player/frame.h"

namespace CCMorse::playerlink {

using Clock = std::chrono::steady_clock;

namespace {

constexpr auto kConnectLimit = std::chrono::seconds(5);
constexpr auto kGreetingLimit = std::chrono::seconds(2);
constexpr auto kCloseLimit = std::chrono::seconds(1);  // for all devices together
// Whoever waits on the socket wakes at least this often, so that no missed wake-up can cost more.
constexpr auto kLongestWait = std::chrono::milliseconds(500);
constexpr std::size_t kLongestQueue = 512;  // messages that came during requests
constexpr char kConstructor[] = "PlayerClient::PlayerClient()";

using Key = std::pair<std::uint16_t, std::uint16_t>;  // interface, index

wire::Devaddr Address(const Key& key) { return {0, 0, key.first, key.second}; }

Clock::duration Seconds(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(std::clamp(seconds, 0.0, 86400.0)));
}

class WireBackend;

class WireLink final : public DeviceLink {
 public:
  WireLink(WireBackend& backend, Key key, std::string driver, const std::shared_ptr<DataSink>& sink)
      : backend_(backend), key_(key), driver_(std::move(driver)), sink_(sink) {}
  ~WireLink() override;
  WireLink(const WireLink&) = delete;
  WireLink& operator=(const WireLink&) = delete;

  void Command(std::uint8_t subtype, const wire::Body& body) override;
  Answer Request(std::uint8_t subtype, const wire::Body& body, const TakeReply& take) override;
  void SetReplaceRule(bool replace, int type, int subtype) override;
  std::string Driver() const override { return driver_; }

 private:
  WireBackend& backend_;
  const Key key_;
  const std::string driver_;
  const std::weak_ptr<DataSink> sink_;
};

// Locking: `mutex_` guards every field that has no other remark. One thread at a time, the one that
// has set pumping_, receives, without the mutex; the others that wait sleep on changed_. Order:
// read_mutex_ or request_mutex_, then mutex_.
class WireBackend final : public PlayerBackend {
 public:
  WireBackend(std::string host, std::uint32_t port, std::shared_ptr<core::TcpStream> stream,
              const std::string& received)
      : host_(std::move(host)), port_(port) {
    if (port < 1 || port > 65535)
      throw MorseError("a port is a number from 1 to 65535", kConstructor);
    stream_ = stream ? std::move(stream) : Dial();
    Greet(*stream_, received);
    const Answer answer = SendDataMode(PLAYER_DATAMODE_PULL);
    if (!answer.ok()) throw MorseError(Where() + answer.why, kConstructor);
  }
  ~WireBackend() override { Close(); }
  WireBackend(const WireBackend&) = delete;
  WireBackend& operator=(const WireBackend&) = delete;

  std::unique_ptr<DeviceLink> Subscribe(std::uint16_t interface_code, std::uint16_t index,
                                        const std::string& /*robot*/,
                                        PlayerCc::ClientProxy* /*proxy*/,
                                        std::shared_ptr<DataSink> sink) override {
    const Key key(interface_code, index);
    // A second subscription would make the server send everything twice (B.5).
    const std::lock_guard subscribing(subscribe_mutex_);
    std::string driver;
    {
      const std::lock_guard lock(mutex_);
      Device& device = devices_[key];
      if (++device.users > 1) {
        device.sinks.push_back(sink);
        driver = device.driver;
        return std::make_unique<WireLink>(*this, key, driver, sink);
      }
    }
    const std::optional<std::string> opened = Open(key);
    const std::lock_guard lock(mutex_);
    if (!opened) {
      devices_.erase(key);
      throw MorseError("", "PlayerBackend::Subscribe()");
    }
    devices_[key].driver = *opened;
    devices_[key].sinks.push_back(sink);
    return std::make_unique<WireLink>(*this, key, *opened, sink);
  }

  void Unsubscribe(const Key& key, const std::weak_ptr<DataSink>& sink) {
    const std::lock_guard subscribing(subscribe_mutex_);
    {
      const std::lock_guard lock(mutex_);
      const auto device = devices_.find(key);
      if (device == devices_.end()) return;
      std::erase_if(device->second.sinks, [&](const auto& each) {
        return !each.owner_before(sink) && !sink.owner_before(each);
      });
      if (--device->second.users > 0) return;
      devices_.erase(device);
      if (closed_ || lost_) return;
    }
    Shut(key, Clock::now() + Seconds(RequestTimeout()));
  }

  void Close() noexcept override {
    try {
      stop_run_ = true;
      StopThread();
      std::vector<Key> open;
      {
        const std::lock_guard lock(mutex_);
        if (closed_) return;
        for (const auto& [key, device] : devices_) open.push_back(key);
      }
      // The answers show that what was sent before has arrived (H11).
      const auto deadline = Clock::now() + kCloseLimit;
      for (const Key& key : open) Shut(key, deadline);
    } catch (...) {
      // The connection ends anyhow.
    }
    const std::lock_guard lock(mutex_);
    closed_ = true;
    stream_->Shutdown();
    stream_->Wake();
    changed_.notify_all();
  }

  bool Connected() override {
    const std::lock_guard lock(mutex_);
    return !closed_ && !lost_;
  }

  void Read() override { ReadOnce(nullptr); }

  bool Peek(std::uint32_t timeout_ms) override {
    std::unique_lock lock(mutex_);
    RequestRound(lock);
    const bool waiting = WaitUntil(lock, Clock::now() + std::chrono::milliseconds(timeout_ms),
                                   nullptr, [&] { return !incoming_.empty(); });
    if (!waiting && (lost_ || closed_)) {
      throw MorseError(Where() + "the connection is lost", "PlayerClient::Peek()");
    }
    return waiting;
  }

  void Run(std::uint32_t timeout_ms) override {
    stop_run_ = false;
    while (!stop_run_) {
      Read();
      std::this_thread::sleep_for(std::chrono::milliseconds(timeout_ms));
    }
  }

  void Stop() override {
    stop_run_ = true;
    stop_thread_ = true;
  }

  void StartThread() override {
    const std::lock_guard lock(thread_mutex_);
    if (thread_.joinable()) {
      if (!stop_thread_ && !thread_ended_) return;
      Wake();
      thread_.join();
    }
    stop_thread_ = false;
    thread_ended_ = false;
    thread_ = std::thread([this] {
      try {
        while (!stop_thread_) ReadOnce(&stop_thread_);
      } catch (const PlayerCc::PlayerError&) {
        // The program's next Read() meets it itself.
      }
      thread_ended_ = true;
    });
  }

  void StopThread() override {
    const std::lock_guard lock(thread_mutex_);
    stop_thread_ = true;
    Wake();
    if (!thread_.joinable()) return;
    if (thread_.get_id() == std::this_thread::get_id()) return;  // from a read signal
    thread_.join();
  }

  void SetRequestTimeout(double seconds) override {
    const std::lock_guard lock(mutex_);
    request_timeout_ = seconds;
  }
  void SetRetryLimit(int limit) override {
    const std::lock_guard lock(mutex_);
    retry_limit_ = limit;
  }
  int GetRetryLimit() override {
    const std::lock_guard lock(mutex_);
    return retry_limit_;
  }
  void SetRetryTime(double seconds) override {
    const std::lock_guard lock(mutex_);
    retry_time_ = seconds;
  }
  double GetRetryTime() override {
    const std::lock_guard lock(mutex_);
    return retry_time_;
  }

  void SetDataMode(std::uint32_t mode) override {
    constexpr char kFunction[] = "PlayerClient::SetDataMode()";
    if (mode != PLAYER_DATAMODE_PUSH && mode != PLAYER_DATAMODE_PULL) {
      throw MorseError("a data mode is 1, push, or 2, pull", kFunction);
    }
    const Answer answer = SendDataMode(static_cast<std::uint8_t>(mode));
    if (!answer.ok()) throw MorseError(answer.why, kFunction);
  }

  void SetReplaceRule(bool replace, int type, int subtype, int interface_code) override {
    AddRule({interface_code, -1, type, subtype, replace ? 1 : 0}, "PlayerClient::SetReplaceRule()");
  }

  void AddRule(const wire::AddReplaceRuleReq& rule, const char* function) {
    const Answer answer = SendRule(rule);
    if (!answer.ok()) throw MorseError(answer.why, function);
    const std::lock_guard lock(mutex_);
    rules_.push_back(rule);
  }

  void RequestDeviceList() override {
    constexpr char kFunction[] = "PlayerClient::RequestDeviceList()";
    wire::DeviceDevlist list;
    const Answer answer = Ask({PLAYER_PLAYER_CODE, 0}, PLAYER_PLAYER_REQ_DEVLIST, wire::Body(),
                              [&](const wire::Body& body) { body.To(list); });
    if (!answer.ok()) throw MorseError(answer.why, kFunction);
    std::list<playerc_device_info_t> found;
    for (const wire::Devaddr& address : list.devices) {
      wire::DeviceDriverinfo info;
      info.addr = address;
      const Answer driver =
          Ask({PLAYER_PLAYER_CODE, 0}, PLAYER_PLAYER_REQ_DRIVERINFO, wire::Body::Of(info),
              [&](const wire::Body& body) { body.To(info); });
      if (!driver.ok()) throw MorseError(driver.why, kFunction);
      playerc_device_info_t& entry = found.emplace_back();
      entry = {};
      entry.addr = {address.host, address.robot, address.interf, address.index};
      std::strncpy(entry.drivername, info.driver_name.c_str(), sizeof(entry.drivername) - 1);
    }
    const std::lock_guard lock(mutex_);
    device_list_ = std::move(found);
  }

  std::list<playerc_device_info_t> GetDeviceList() override {
    const std::lock_guard lock(mutex_);
    return device_list_;
  }

  std::string GetHostname() const override { return host_; }
  std::uint32_t GetPort() const override { return port_; }

  std::uint32_t GetOverflowCount() override {
    const std::lock_guard lock(mutex_);
    return std::exchange(overflow_, 0);
  }

  void Send(const Key& key, wire::MessageType type, std::uint8_t subtype, const wire::Body& body) {
    wire::Header header;
    header.address = Address(key);
    header.type = type;
    header.subtype = subtype;
    std::string bytes;
    wire::Append(header, body.empty() ? wire::Bytes() : body.ToBytes(), bytes);
    std::shared_ptr<core::TcpStream> stream;
    {
      const std::lock_guard lock(mutex_);
      if (lost_ || closed_) return;
      stream = stream_;
    }
    const std::lock_guard sending(send_mutex_);
    if (stream->Send(bytes)) return;
    const std::lock_guard lock(mutex_);
    if (stream == stream_) lost_ = true;
    changed_.notify_all();
  }

  Answer Ask(const Key& key, std::uint8_t subtype, const wire::Body& body, const TakeReply& take) {
    return Ask(key, subtype, body, take, Clock::now() + Seconds(RequestTimeout()));
  }

  Answer Ask(const Key& key, std::uint8_t subtype, const wire::Body& body, const TakeReply& take,
             Clock::time_point deadline) {
    const std::lock_guard asking(request_mutex_);  // one request at a time (B.2)
    Waiting waiting{key, subtype, {}, {}};
    {
      const std::lock_guard lock(mutex_);
      if (lost_ || closed_) return {Answer::Kind::kLost, "the connection is lost"};
      waiting_ = &waiting;
    }
    Send(key, wire::MessageType::kRequest, subtype, body);
    std::unique_lock lock(mutex_);
    const bool answered =
        WaitUntil(lock, deadline, nullptr, [&] { return waiting.type.has_value(); });
    waiting_ = nullptr;
    if (!answered && (lost_ || closed_)) return {Answer::Kind::kLost, "the connection is lost"};
    if (!answered) return {Answer::Kind::kTimeout, "no answer in time"};
    lock.unlock();
    if (*waiting.type == wire::MessageType::kNack) {
      return {Answer::Kind::kNack, "the server refused the request"};
    }
    take(wire::Body(waiting.body));
    return {};
  }

 private:
  struct Device {
    int users = 0;
    std::string driver;
    std::vector<std::weak_ptr<DataSink>> sinks;
  };
  struct Waiting {
    Key key;
    std::uint8_t subtype;
    std::optional<wire::MessageType> type;  // of the answer, once it is here
    wire::Bytes body;
  };
  struct Queued {
    wire::Header header;
    wire::Bytes body;
  };

  std::string Where() const { return core::AddressText(host_, static_cast<int>(port_)) + ": "; }

  std::shared_ptr<core::TcpStream> Dial() const {
    return std::make_shared<core::TcpStream>(host_, static_cast<int>(port_), kConnectLimit,
                                             kConstructor);
  }

  // Takes the server's first bytes; what follows them is messages.
  void Greet(core::TcpStream& stream, std::string received) {
    const auto deadline = Clock::now() + kGreetingLimit;
    while (received.size() < wire::kBannerSize) {
      const core::TcpStream::Wait outcome = stream.WaitFor(deadline);
      if (outcome == core::TcpStream::Wait::kReady && stream.Receive(received)) continue;
      if (outcome == core::TcpStream::Wait::kWoken) continue;
      throw MorseError(Where() + "no Player server greets there", kConstructor);
    }
    const std::lock_guard lock(mutex_);
    reader_ = wire::FrameReader();
    reader_.Append(std::string_view(received).substr(wire::kBannerSize));
  }

  double RequestTimeout() {
    const std::lock_guard lock(mutex_);
    return request_timeout_;
  }

  Answer SendDataMode(std::uint8_t mode) {
    const Answer answer =
        Ask({PLAYER_PLAYER_CODE, 0}, PLAYER_PLAYER_REQ_DATAMODE,
            wire::Body::Of(wire::DeviceDatamodeReq{mode}), [](const wire::Body&) {});
    const std::lock_guard lock(mutex_);
    if (answer.ok()) {
      mode_ = mode;
      round_requested_ = false;
    }
    return answer;
  }

  Answer SendRule(const wire::AddReplaceRuleReq& rule) {
    return Ask({PLAYER_PLAYER_CODE, 0}, PLAYER_PLAYER_REQ_ADD_REPLACE_RULE, wire::Body::Of(rule),
               [](const wire::Body&) {});
  }

  // The driver's name, or nothing when the server refuses.
  std::optional<std::string> Open(const Key& key) {
    wire::DeviceReq request;
    request.addr = Address(key);
    request.access = PLAYER_OPEN_MODE;
    wire::DeviceReq reply;
    const Answer answer =
        Ask({PLAYER_PLAYER_CODE, 0}, PLAYER_PLAYER_REQ_DEV, wire::Body::Of(request),
            [&](const wire::Body& body) { body.To(reply); });
    if (!answer.ok() || reply.access == PLAYER_ERROR_MODE) return {};
    return reply.driver_name;
  }

  void Shut(const Key& key, Clock::time_point deadline) {
    wire::DeviceReq request;
    request.addr = Address(key);
    request.access = PLAYER_CLOSE_MODE;
    Ask(
        {PLAYER_PLAYER_CODE, 0}, PLAYER_PLAYER_REQ_DEV, wire::Body::Of(request),
        [](const wire::Body&) {}, deadline);
  }

  void Wake() {
    const std::lock_guard lock(mutex_);
    stream_->Wake();
    changed_.notify_all();
  }

  // In PULL: asks for a round, unless one is on its way.
  void RequestRound(std::unique_lock<std::mutex>& lock) {
    if (mode_ != PLAYER_DATAMODE_PULL || round_requested_) return;
    round_requested_ = true;
    lock.unlock();
    Send({PLAYER_PLAYER_CODE, 0}, wire::MessageType::kRequest, PLAYER_PLAYER_REQ_DATA,
         wire::Body());
    lock.lock();
  }

  // Waits until `done`; false when it is not at `deadline`, on `abandon`, or without a connection.
  // Looks at the socket at least once.
  template <typename Done>
  bool WaitUntil(std::unique_lock<std::mutex>& lock, Clock::time_point deadline,
                 const std::atomic<bool>* abandon, Done done) {
    for (bool looked = false;; looked = true) {
      if (done()) return true;
      if (lost_ || closed_ || (abandon != nullptr && *abandon)) return false;
      const auto now = Clock::now();
      if (looked && now >= deadline) return false;
      const auto until = std::min(deadline, now + kLongestWait);
      if (pumping_) {
        changed_.wait_until(lock, until);
        continue;
      }
      pumping_ = true;
      const std::shared_ptr<core::TcpStream> stream = stream_;
      lock.unlock();
      received_.clear();
      const core::TcpStream::Wait outcome = stream->WaitFor(until);
      const bool alive = outcome == core::TcpStream::Wait::kReady
                             ? stream->Receive(received_)
                             : outcome != core::TcpStream::Wait::kLost;
      lock.lock();
      pumping_ = false;
      reader_.Append(received_);
      TakeMessages();
      if (!alive || reader_.broken()) lost_ = true;
      changed_.notify_all();
    }
  }

  void TakeMessages() {
    while (const std::optional<wire::Message> message = reader_.Next()) {
      const wire::Header& header = message->header;
      switch (header.type) {
        case wire::MessageType::kData:
        case wire::MessageType::kSynch:
          incoming_.push_back({header, {message->body.begin(), message->body.end()}});
          break;
        case wire::MessageType::kAck:
        case wire::MessageType::kNack: {
          const Key key(header.address.interf, header.address.index);
          if (waiting_ != nullptr && !waiting_->type && waiting_->key == key &&
              waiting_->subtype == header.subtype) {
            waiting_->type = header.type;
            waiting_->body.assign(message->body.begin(), message->body.end());
          }
          break;
        }
        default:
          break;  // what only a server gets
      }
    }
    if (reading_) return;  // it takes them out at once
    while (incoming_.size() > kLongestQueue) {
      const auto oldest = std::find_if(incoming_.begin(), incoming_.end(), [](const Queued& each) {
        return each.header.type == wire::MessageType::kData;
      });
      if (oldest == incoming_.end()) break;
      incoming_.erase(oldest);
      if (!std::exchange(warned_, true)) {
        std::cerr << "warning : queue overflow; discarding packets\n";
      }
    }
  }

  void ReadOnce(const std::atomic<bool>* abandon) {
    const std::lock_guard reading(read_mutex_);
    std::vector<std::shared_ptr<DataSink>> signals;
    std::unique_lock lock(mutex_);
    reading_ = true;
    warned_ = false;
    for (bool more = true; more;) {
      RequestRound(lock);
      if (!WaitUntil(lock, Clock::time_point::max(), abandon, [&] { return !incoming_.empty(); })) {
        if (abandon != nullptr && *abandon && !lost_ && !closed_) break;
        if (!closed_ && retry_limit_ != 0 && Reconnect(lock, abandon)) continue;
        reading_ = false;
        throw MorseError(Where() + "the connection is lost", "PlayerClient::Read()");
      }
      Queued message = std::move(incoming_.front());
      incoming_.pop_front();
      if (message.header.type == wire::MessageType::kSynch) {
        wire::Overflow dropped;
        if (message.header.subtype == PLAYER_PLAYER_SYNCH_OVERFLOW &&
            wire::Decode(message.body, dropped)) {
          overflow_ += dropped.dropped;
        }
        if (mode_ == PLAYER_DATAMODE_PULL) {
          round_requested_ = false;
          more = false;
        }
        continue;
      }
      Dispatch(lock, message, signals);
      if (mode_ == PLAYER_DATAMODE_PUSH) more = false;
    }
    reading_ = false;
    const bool overflow = overflow_ > 0;
    lock.unlock();
    for (const std::shared_ptr<DataSink>& sink : signals) sink->Signal();
    if (overflow) throw MorseError("Overflow on server", "PlayerClient::Read()");
  }

  void Dispatch(std::unique_lock<std::mutex>& lock, const Queued& message,
                std::vector<std::shared_ptr<DataSink>>& signals) {
    const auto device =
        devices_.find(Key(message.header.address.interf, message.header.address.index));
    if (device == devices_.end()) return;
    std::vector<std::shared_ptr<DataSink>> sinks;
    for (const auto& each : device->second.sinks) {
      if (std::shared_ptr<DataSink> sink = each.lock()) sinks.push_back(std::move(sink));
    }
    lock.unlock();
    const wire::Body body{message.body};
    const DataMessage data{message.header.subtype, message.header.time, message.header.time != 0.0,
                           body};
    for (const std::shared_ptr<DataSink>& sink : sinks) {
      if (sink->OnData(data) && std::find(signals.begin(), signals.end(), sink) == signals.end()) {
        signals.push_back(sink);
      }
    }
    lock.lock();
  }

  // Connects again and subscribes everything anew; false when that failed too often.
  bool Reconnect(std::unique_lock<std::mutex>& lock, const std::atomic<bool>* abandon) {
    for (int attempt = 0; retry_limit_ < 0 || attempt < retry_limit_; ++attempt) {
      const auto again = Clock::now() + Seconds(retry_time_);
      lock.unlock();
      if (Restore()) {
        lock.lock();
        return true;
      }
      lock.lock();
      while (Clock::now() < again && !closed_ && !(abandon != nullptr && *abandon)) {
        changed_.wait_until(lock, std::min(again, Clock::now() + kLongestWait));
      }
      if (closed_ || (abandon != nullptr && *abandon)) return false;
    }
    return false;
  }

  bool Restore() {
    try {
      std::shared_ptr<core::TcpStream> stream = Dial();
      Greet(*stream, "");
      std::vector<Key> keys;
      std::vector<wire::AddReplaceRuleReq> rules;
      std::uint8_t mode = PLAYER_DATAMODE_PULL;
      {
        const std::lock_guard lock(mutex_);
        if (closed_) return false;
        stream_ = std::move(stream);
        incoming_.clear();
        round_requested_ = false;
        lost_ = false;
        mode = mode_;
        rules = rules_;
        for (const auto& [key, device] : devices_) keys.push_back(key);
      }
      bool restored = SendDataMode(mode).ok();
      for (const wire::AddReplaceRuleReq& rule : rules) restored = SendRule(rule).ok() && restored;
      for (const Key& key : keys) restored = Open(key).has_value() && restored;
      if (restored) return true;
      const std::lock_guard lock(mutex_);
      lost_ = true;
    } catch (const MorseError&) {
      // The next attempt may do better.
    }
    return false;
  }

  const std::string host_;
  const std::uint32_t port_;

  std::mutex read_mutex_;       // held for a whole Read()
  std::mutex request_mutex_;    // held for a whole request
  std::mutex subscribe_mutex_;  // held while a device is opened or given up
  std::mutex send_mutex_;       // held while bytes go out
  std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<core::TcpStream> stream_;
  wire::FrameReader reader_;
  std::string received_;  // of the thread that pumps
  bool pumping_ = false;
  bool reading_ = false;
  bool warned_ = false;
  bool lost_ = false;
  bool closed_ = false;
  std::deque<Queued> incoming_;  // data and synch messages in their order
  Waiting* waiting_ = nullptr;
  std::uint8_t mode_ = PLAYER_DATAMODE_PUSH;  // the server's own default
  bool round_requested_ = false;
  std::uint32_t overflow_ = 0;
  std::map<Key, Device> devices_;
  std::vector<wire::AddReplaceRuleReq> rules_;
  std::list<playerc_device_info_t> device_list_;
  double request_timeout_ = 5.0;
  int retry_limit_ = 0;
  double retry_time_ = 2.0;

  std::mutex thread_mutex_;  // thread_
  std::thread thread_;
  std::atomic<bool> stop_thread_{false};
  std::atomic<bool> thread_ended_{false};
  std::atomic<bool> stop_run_{false};
};

WireLink::~WireLink() { backend_.Unsubscribe(key_, sink_); }

void WireLink::Command(std::uint8_t subtype, const wire::Body& body) {
  backend_.Send(key_, wire::MessageType::kCommand, subtype, body);
}

Answer WireLink::Request(std::uint8_t subtype, const wire::Body& body, const TakeReply& take) {
  return backend_.Ask(key_, subtype, body, take);
}

void WireLink::SetReplaceRule(bool replace, int type, int subtype) {
  backend_.AddRule({key_.first, key_.second, type, subtype, replace ? 1 : 0},
                   "ClientProxy::SetReplaceRule()");
}

}  // namespace

std::unique_ptr<PlayerBackend> OpenPlayerServer(const std::string& host, std::uint32_t port,
                                                std::shared_ptr<core::TcpStream> stream,
                                                const std::string& received) {
  return std::make_unique<WireBackend>(host, port, std::move(stream), received);
}

}  // namespace CCMorse::playerlink
