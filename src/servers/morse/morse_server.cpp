#include "servers/morse/morse_server.h"

#include <algorithm>
#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cmath>
#include <deque>
#include <functional>
#include <iterator>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "base/log.h"
#include "servers/fast_link/fast_link_session.h"
#include "servers/morse/stream_sender.h"
#include "servers/net/listener.h"
#include "servers/net/outbox.h"
#include "servers/net/stream_socket.h"
#include "servers/net/waiting.h"
#include "servers/net/warning_limit.h"
#include "sim/late_text.h"
#include "wire/fast_link.h"
#include "wire/morse_line.h"

namespace ccmorse::servers {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using sim::Outcome;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kFrameBlock = 128U << 10;       // a whole canvas at once
constexpr const char* kThisProgram = "this program";  // a client's address, in the log
constexpr auto kTurn = std::chrono::milliseconds(1);  // of one connection before others get theirs
constexpr Clock::duration kMostForAsking = std::chrono::milliseconds(5);  // see SendStreamsLater()

const char* StatusWord(Outcome outcome) {
  switch (outcome) {
    case Outcome::kSuccess:
      return "SUCCESS";
    case Outcome::kFailed:
      return "FAILED";
    case Outcome::kPreempted:
      break;
  }
  return "PREEMPTED";
}

// Clients are worked on in the order in which they came, not by where they lie in memory.
struct Earlier {
  template <typename Client>
  bool operator()(const Client& a, const Client& b) const {
    return a->arrival() < b->arrival();
  }
};

}  // namespace

// What all connections use. Connections hold it weakly or by reference through the server's
// lifetime; `closed` tells handlers that still run that the server has gone.
struct MorseServer::Shared : std::enable_shared_from_this<MorseServer::Shared> {
  Shared(asio::io_context& io_in, sim::Simulation& simulation_in, ServiceDirectory& directory_in,
         const Pace& pace_in, const MorseServerOptions& options_in)
      : io(io_in),
        simulation(simulation_in),
        pace(pace_in),
        options(options_in),
        directory(directory_in),
        sender(io_in, false),
        late_sender(io_in, pace_in.name == "realtime") {}

  // The tick at whose Sense() the n-th read of a connection is answered.
  std::uint64_t ReadTick(std::uint64_t n) const {
    const double ticks = simulation.scenario().time.frequency / pace.read_frequency;
    return static_cast<std::uint64_t>(std::ceil(static_cast<double>(n) * ticks - 1e-9));
  }
  // The newest read whose tick is not after `tick`.
  std::uint64_t ReadAt(std::uint64_t tick) const {
    const double ticks = simulation.scenario().time.frequency / pace.read_frequency;
    return static_cast<std::uint64_t>(std::floor(static_cast<double>(tick) / ticks + 1e-9));
  }

  // A new client of the services, called `name` in the log.
  void Take(StreamSocket socket, std::string name);

  // Answers what is due. Connections may come to their end by it.
  void TellConnections();
  std::size_t stream_clients() const {
    return sender.readers() + late_sender.readers() + stream_writers;
  }

  // Has the lines sent that streams have kept back, now or a little later.
  void SendStreams();
  void SendStreamsLater();

  asio::io_context& io;
  sim::Simulation& simulation;
  Pace pace;
  MorseServerOptions options;
  ServiceDirectory& directory;
  std::shared_ptr<Listener> listener;
  std::uint64_t arrivals = 0;  // of clients, so far
  std::set<std::shared_ptr<ServiceConnection>, Earlier> connections;
  std::vector<std::shared_ptr<ServiceConnection>> told;  // scratch of TellConnections()
  std::vector<std::shared_ptr<Stream>> streams;
  std::unordered_map<const sim::Component*, Stream*> stream_of;
  StreamSender sender;             // to the clients of sensors
  StreamSender late_sender;        // to those of sensors with long lines
  std::size_t stream_writers = 0;  // clients of actuators
  asio::steady_timer stream_timer{io};
  bool streams_wait = false;   // lines of the last Sense() have not been sent yet
  bool answered_late = false;  // an asynchronous service has ended since the last Sense()
  int readers_ever = 0;        // connections that have sent a read
  bool sensed_once = false;
  std::uint64_t sensed_tick = 0;  // of the last Sense()
  std::string ended;              // why reads fail, once the run is over
  WarningLimit warnings;
  bool closed = false;
};

// One client of the service port: lines, or, once it has asked for them, the fast link's frames.
// Requests are answered in order; a `read` holds back those behind it until its time has come.
class MorseServer::ServiceConnection
    : public std::enable_shared_from_this<MorseServer::ServiceConnection> {
 public:
  ServiceConnection(Shared& shared, StreamSocket socket, std::string name)
      : shared_(shared),
        socket_(std::move(socket)),
        peek_timer_(shared.io),
        outbox_(socket_),
        address_(std::move(name)),
        name_(address_),
        lines_(shared.options.longest_request),
        frames_(wire::kMostClientFrame),
        arrival_(++shared.arrivals) {}

  void Start() { Read(); }

  std::uint64_t arrival() const { return arrival_; }
  bool reads() const { return joined_; }
  bool waits() const { return read_waits_; }
  std::uint64_t read_tick() const { return shared_.ReadTick(next_read_); }
  /// When the outstanding read came.
  Clock::time_point waits_since() const { return read_since_; }
  /// When anything came.
  Clock::time_point heard() const { return heard_; }
  /// Address, port and what the client calls itself, for the log.
  const std::string& name() const { return name_; }

  // After a Sense(): the outstanding read or peek may be due now.
  void Sensed() {
    if (!held_back() || !DataAreDue()) return;
    if (peek_id_) {
      AnswerPeek(true);
    } else {
      AnswerRead();
    }
    Process();
  }

  void Close() {
    ErrorCode ignored;
    socket_.close(ignored);
    peek_timer_.cancel();
  }

  void Leave() {
    if (left_) return;
    left_ = true;
    Close();
    shared_.connections.erase(shared_from_this());
  }

 private:
  void Read() {
    reading_ = true;
    if (fast_ != nullptr) {
      socket_.async_wait(StreamSocket::wait_read, [self = shared_from_this()](ErrorCode error) {
        self->reading_ = false;
        if (self->shared_.closed || self->left_) return;
        if (error) return self->Leave();
        self->ReceiveFrames();
      });
      return;
    }
    block_.resize(kReadBlock);
    socket_.async_read_some(asio::buffer(block_),
                            [self = shared_from_this()](ErrorCode error, std::size_t size) {
                              self->reading_ = false;
                              if (self->shared_.closed || self->left_) return;
                              if (error) return self->Leave();
                              const std::string_view bytes(self->block_.data(), size);
                              if (self->fast_ != nullptr) {  // it became a fast link meanwhile
                                self->frames_.Append(bytes);
                              } else {
                                self->lines_.Append(bytes);
                              }
                              self->Received();
                            });
  }

  void ReceiveFrames() {
    ErrorCode error;
    const std::size_t size =
        socket_.read_some(asio::buffer(frames_.Space(kFrameBlock), kFrameBlock), error);
    if (error == asio::error::would_block) return KeepReading();
    if (error) return Leave();
    frames_.Commit(size);
    Received();
  }

  void Received() {
    heard_ = Clock::now();
    Process();
  }

  // Reads on unless the client floods us or does not fetch its replies.
  void KeepReading() {
    if (reading_ || !socket_.is_open()) return;
    if (outbox_.size() > shared_.options.most_unread) return;  // goes on when they are sent
    const std::size_t most = fast_ != nullptr ? wire::kFrameHeader + wire::kMostClientFrame
                                              : shared_.options.longest_request;
    if (lines_.buffered() + frames_.buffered() + queued_bytes_ > most + kReadBlock) return;
    Read();
  }

  // Answers requests until a read holds them back, the client's replies pile up or it had its turn.
  void Process() {
    if (shared_.closed || !socket_.is_open()) return;
    bool more = false;
    serving_ = true;
    const auto until = Clock::now() + kTurn;
    wire::Frame next;
    while (!left_ && !held_back() && outbox_.size() <= shared_.options.most_unread &&
           TakeNext(&next)) {
      if (next.type == wire::FrameType::kLines) {
        Serve(next.payload);
      } else {
        ServeFrame(next);
      }
      if (Clock::now() > until) {
        more = true;
        break;
      }
    }
    if (read_waits_) AnswerPings();
    serving_ = false;
    if (left_) return;
    Flush();
    if (more) {
      if (!turn_posted_) {
        turn_posted_ = true;
        asio::post(shared_.io, [self = shared_from_this()] {
          self->turn_posted_ = false;
          self->Process();
        });
      }
      return;
    }
    KeepReading();
  }

  bool held_back() const { return read_waits_ || peek_id_.has_value(); }

  // The next line (as kLines, without its end) or frame. The view is good until the next call.
  bool TakeNext(wire::Frame* next) {
    if (!queue_.empty()) {
      next->type = queue_.front().type;
      line_ = std::move(queue_.front().bytes);
      queue_.pop_front();
      queued_bytes_ -= line_.size();
      next->payload = line_;
      return true;
    }
    return Receive(next);
  }

  // The next one of those that were not set aside.
  bool Receive(wire::Frame* next) {
    for (;;) {
      if (TakeLine()) {
        *next = {wire::FrameType::kLines, line_};
        return true;
      }
      if (fast_ == nullptr) return false;
      switch (frames_.Next(next)) {
        case wire::FrameSplitter::Result::kFrame:
          if (next->type != wire::FrameType::kLines) return true;
          lines_.Append(next->payload);
          break;
        case wire::FrameSplitter::Result::kNeedMore:
          return false;
        case wire::FrameSplitter::Result::kBroken:
          Break();
          return false;
      }
    }
  }

  bool TakeLine() {
    std::string_view line;
    for (;;) {
      switch (lines_.Next(&line)) {
        case wire::LineSplitter::Result::kLine:
          line_ = line;
          return true;
        case wire::LineSplitter::Result::kTooLong:
          RefuseLongLine();
          break;
        case wire::LineSplitter::Result::kNeedMore:
          return false;
      }
    }
  }

  void RefuseLongLine() {
    shared_.warnings.Warn("MORSE client: a request longer than {} bytes was dropped",
                          shared_.options.longest_request);
    Reply("", {Outcome::kFailed, Json("Malformed request! A line may have at most " +
                                      std::to_string(shared_.options.longest_request) + " bytes")});
  }

  // Where the frames end there is no finding the next one.
  void Break() {
    shared_.warnings.Warn("client {} sent what is no frame of the fast link: it is let go", name_);
    Leave();
  }

  // While a read waits, requests are set aside, but for pings.
  void AnswerPings() {
    wire::Frame next;
    while (!left_ && Receive(&next)) {
      if (next.type == wire::FrameType::kLines) {
        const wire::MorseRequest request = wire::ParseMorseRequest(next.payload);
        if (request.component == "ccmorse" && request.service == "ping") {
          Reply(request.id, {Outcome::kSuccess, Json("pong")});
          continue;
        }
      }
      queued_bytes_ += next.payload.size();
      queue_.push_back({next.type, std::string(next.payload)});
    }
  }

  void ServeFrame(const wire::Frame& frame) {
    if (frame.type == wire::FrameType::kRead && frame.payload.empty()) {
      HoldRead("", true);
    } else if (!fast_->Take(frame)) {
      Break();
    }
  }

  void Serve(std::string_view line) {
    const wire::MorseRequest request = wire::ParseMorseRequest(line);
    switch (request.kind) {
      case wire::MorseRequest::Kind::kMalformed:
        Reply(request.id, {Outcome::kFailed, Json("Malformed request! ")});
        return;
      case wire::MorseRequest::Kind::kCancel:
        Cancel(std::string(request.id));
        return;
      case wire::MorseRequest::Kind::kCall:
        break;
    }
    if (request.component == "ccmorse" && ServeOwn(request)) return;
    std::string id(request.id);
    const std::string component(request.component);
    // The answer may come now or ticks later, or never when the client has left by then.
    const auto running = pending_.emplace(id, component);
    shared_.directory.Call(
        request.component, request.service, request.parameters,
        [weak = weak_from_this(), id = std::move(id), running](const sim::ServiceResult& result) {
          const auto self = weak.lock();
          if (!self || self->shared_.closed) return;
          self->pending_.erase(running);
          self->Reply(id, result);
          if (self->serving_) return;
          self->Flush();
          self->shared_.answered_late = true;
        });
    if (request.service == "get_local_data") {
      const auto* sensor = dynamic_cast<sim::Sensor*>(shared_.simulation.FindComponent(component));
      if (sensor != nullptr) shared_.directory.sample_use().Count(*sensor);
    }
  }

  // `id cancel` interrupts whatever runs under that id, for whichever client (specs: morse.md A.5).
  void Cancel(const std::string& id) {
    std::vector<std::string> components;
    for (const auto& connection : shared_.connections) {
      const auto [first, last] = connection->pending_.equal_range(id);
      for (auto entry = first; entry != last; ++entry) components.push_back(entry->second);
    }
    for (const std::string& name : components) shared_.directory.Interrupt(name);
  }

  // The services of docs/protocols/ccmorse-services.md.
  bool ServeOwn(const wire::MorseRequest& request) {
    if (request.service == "read") {
      HoldRead(request.id, false);
      return true;
    }
    if (request.service == "ping") {
      Reply(request.id, {Outcome::kSuccess, Json("pong")});
      return true;
    }
    if (request.service == "hello") {
      Reply(request.id,
            {Outcome::kSuccess,
             Json(Json::Object{{"server", "ccmorse " CCMORSE_VERSION},
                               {"protocol", 1},
                               {"fast_link", wire::kFastLinkVersion},
                               {"pace", shared_.pace.name},
                               {"frequency", shared_.simulation.scenario().time.frequency},
                               {"read_period", 1.0 / shared_.pace.read_frequency}})});
      TakeName(request.parameters);
      return true;
    }
    if (request.service == "clock") {
      ServeClock(request.id);
      return true;
    }
    if (request.service == "fast_link") {
      StartFastLink(request);
      return true;
    }
    if (request.service == "peek") {
      ServePeek(request);
      return true;
    }
    return false;
  }

  void ServeClock(std::string_view id) {
    Json clock = shared_.pace.clock ? shared_.pace.clock() : Json();
    if (clock.IsNull()) {
      return Reply(id, {Outcome::kFailed, Json("Only real time goes by a clock")});
    }
    clock.Set("sent", std::chrono::duration<double>(sent_.time_since_epoch()).count());
    Reply(id, {Outcome::kSuccess, std::move(clock)});
  }

  // hello's {"client": "text", "program": "text"}, for the log.
  void TakeName(std::string_view parameters) {
    try {
      const Json parsed = Json::Parse(parameters);
      if (!parsed.IsArray() || parsed.AsArray().empty()) return;
      name_ = address_;
      for (const char* key : {"client", "program"}) {
        const Json* text = parsed.AsArray()[0].Find(key);
        if (text == nullptr || !text->IsString()) continue;
        name_ += ' ' + Json(text->AsString().substr(0, 100)).Dump();
      }
    } catch (const JsonError&) {
      // A client without a name.
    }
  }

  // Answers in lines; from then on there are frames only, both ways.
  void StartFastLink(const wire::MorseRequest& request) {
    std::string wanted;
    try {
      const Json parsed = Json::Parse(request.parameters);
      wanted = parsed.IsArray() && parsed.AsArray().size() == 1 ? parsed.AsArray()[0].Dump() : "";
    } catch (const JsonError&) {
      // Answered below.
    }
    const std::string ours = std::to_string(wire::kFastLinkVersion);
    if (fast_ != nullptr || wanted != ours) {
      Reply(request.id,
            {Outcome::kFailed,
             Json(fast_ != nullptr ? "This is a fast link already"
                                   : "This server's fast link has version " + ours + " only")});
      return;
    }
    Reply(request.id, {Outcome::kSuccess, Json(wire::kFastLinkVersion)});
    fast_ = std::make_shared<FastLinkSession>(
        shared_.simulation, shared_.directory,
        [weak = weak_from_this()](std::uint16_t service, const Json& reason) {
          const auto self = weak.lock();
          if (!self || self->shared_.closed) return;
          self->Refuse(service, reason);
        });
  }

  void Refuse(std::uint16_t service, const Json& reason) {
    {
      wire::FrameWriter frame(outbox_.text(), wire::FrameType::kRefused);
      frame.Short(service);
      if (!reason.IsFalsy()) frame.Bytes(reason.Dump());
    }
    if (!serving_) Flush();
  }

  void HoldRead(std::string_view id, bool fast) {
    read_waits_ = true;
    read_id_ = id;
    read_is_fast_ = fast;
    read_since_ = Clock::now();
    if (!joined_) {
      joined_ = true;
      ++shared_.readers_ever;
      // The first read gets what the sensors show now, or will show first.
      next_read_ = shared_.sensed_once ? shared_.ReadAt(shared_.sensed_tick) : 0;
    } else if (shared_.pace.name != "lockstep") {
      // A client that was slow gets the newest data, not the ones that it missed.
      next_read_ = std::max(next_read_, shared_.ReadAt(shared_.sensed_tick));
    }
    if (DataAreDue()) AnswerRead();
  }

  bool DataAreDue() const {
    return !shared_.ended.empty() || (shared_.sensed_once && read_tick() <= shared_.sensed_tick);
  }

  // Answers the outstanding read. Precondition: its time has come.
  void AnswerRead() {
    read_waits_ = false;
    if (!shared_.ended.empty()) {
      if (!read_is_fast_) return Reply(read_id_, {Outcome::kFailed, Json(shared_.ended)});
      wire::FrameWriter frame(outbox_.text(), wire::FrameType::kReadFailed);
      frame.Bytes(Json(shared_.ended).Dump());
      return;
    }
    ++next_read_;
    sent_ = Clock::now();
    const double seconds =
        static_cast<double>(shared_.sensed_tick) / shared_.simulation.scenario().time.frequency;
    if (!read_is_fast_) {
      return Reply(read_id_, {Outcome::kSuccess, Json(Json::Object{{"time", seconds}})});
    }
    fast_->AppendData(outbox_.text(), seconds);
    for (const auto& subscription : fast_->subscriptions()) {
      shared_.directory.sample_use().Count(*subscription.sensor);
    }
  }

  void ServePeek(const wire::MorseRequest& request) {
    double timeout = 0.0;
    try {
      if (!request.parameters.empty()) {
        const Json parsed = Json::Parse(request.parameters);
        if (parsed.IsArray() && !parsed.AsArray().empty()) {
          timeout = sim::NumberArgument(parsed.AsArray(), 0, "timeout");
        }
      }
    } catch (const std::exception& error) {
      Reply(request.id, {Outcome::kFailed,
                         Json("Socket service manager: wrong parameter type for service peek. " +
                              std::string(error.what()))});
      return;
    }
    peek_id_ = std::string(request.id);
    if (DataAreDue()) return AnswerPeek(true);
    if (timeout <= 0.0) return AnswerPeek(false);
    peek_timer_.expires_after(std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(std::min(timeout, 3600.0))));
    peek_timer_.async_wait([self = shared_from_this()](ErrorCode error) {
      if (error || self->shared_.closed || !self->peek_id_) return;
      self->AnswerPeek(false);
      self->Process();
    });
  }

  void AnswerPeek(bool waiting) {
    const std::string id = *std::exchange(peek_id_, std::nullopt);
    peek_timer_.cancel();
    Reply(id, {Outcome::kSuccess, Json(waiting)});
  }

  void Reply(std::string_view id, const sim::ServiceResult& result) {
    std::optional<wire::FrameWriter> frame;
    if (fast_ != nullptr) frame.emplace(outbox_.text(), wire::FrameType::kLines);
    if (result.text.empty()) {
      wire::AppendMorseReply(outbox_.text(), id, StatusWord(result.outcome), result.value);
    } else {
      wire::AppendMorseReplyText(outbox_.text(), id, StatusWord(result.outcome), result.text);
    }
  }

  void Flush() {
    outbox_.Flush(shared_from_this(), [this](ErrorCode error) {
      if (shared_.closed) return;
      if (error) return Leave();
      Process();
    });
  }

  // A line, or a frame, that was set aside while a read waits.
  struct Held {
    wire::FrameType type;
    std::string bytes;
  };

  Shared& shared_;
  StreamSocket socket_;
  asio::steady_timer peek_timer_;
  Outbox outbox_;
  std::string address_;
  std::string name_;
  wire::LineSplitter lines_;
  wire::FrameSplitter frames_;
  const std::uint64_t arrival_;
  std::shared_ptr<FastLinkSession> fast_;  // nullptr: lines
  std::vector<char> block_;
  std::string line_;
  std::deque<Held> queue_;
  std::size_t queued_bytes_ = 0;
  std::multimap<std::string, std::string> pending_;  // id -> component, of running services
  bool read_waits_ = false;
  bool read_is_fast_ = false;  // it came as a frame
  std::string read_id_;        // it came as a line
  Clock::time_point read_since_{};
  Clock::time_point heard_ = Clock::now();
  Clock::time_point sent_{};  // the answer to the last read
  std::optional<std::string> peek_id_;
  std::uint64_t next_read_ = 0;
  bool joined_ = false;
  bool reading_ = false;
  bool serving_ = false;
  bool turn_posted_ = false;
  bool left_ = false;
};

void MorseServer::Shared::Take(StreamSocket socket, std::string name) {
  if (connections.size() >= options.most_clients) {
    warnings.Warn("more than {} connections to the service port, one was refused",
                  options.most_clients);
    return;
  }
  const auto connection =
      std::make_shared<ServiceConnection>(*this, std::move(socket), std::move(name));
  connections.insert(connection);
  connection->Start();
}

void MorseServer::Shared::TellConnections() {
  told.assign(connections.begin(), connections.end());
  for (const auto& connection : told) connection->Sensed();
  told.clear();
}

// The stream of one component: a sensor's lines go to every client, an actuator takes every
// client's newest line.
class MorseServer::Stream : public std::enable_shared_from_this<MorseServer::Stream> {
 public:
  Stream(Shared& shared, sim::Component& component)
      : shared_(shared),
        component_(component),
        sensor_(dynamic_cast<sim::Sensor*>(&component)),
        late_text_(dynamic_cast<sim::LateText*>(&component)),
        actuator_(dynamic_cast<sim::Actuator*>(&component)) {}

  void Open(int port) {
    listener_ = std::make_shared<Listener>(shared_.io,
                                           [this](tcp::socket socket) { Take(std::move(socket)); });
    listener_->Open(shared_.options.bind, port, true);
  }

  int port() const { return listener_->port(); }
  const sim::Component& component() const { return component_; }

  // Are its lines so long that the run does not wait for them?
  bool late() const { return late_text_ != nullptr; }

  // The sensor has new data for its clients.
  void Publish() {
    if (sensor_ == nullptr || !Wanted()) return;
    if (late()) {
      text_ = late_text_->TextLater();
    } else {
      text_ = [text = sensor_->LocalData()] { return text; };
    }
    shared_.directory.sample_use().Count(*sensor_);
  }

  // Adds what was published and not sent yet.
  void AppendLine(std::vector<StreamSender::Line>& lines) {
    if (text_) lines.push_back({readers_, std::exchange(text_, nullptr)});
  }

  void Apply() {
    if (actuator_ == nullptr || !actuator_->active()) return;
    for (const auto& client : clients_) {
      if (!client->newest) continue;
      const std::string line = *std::exchange(client->newest, std::nullopt);
      try {
        shared_.directory.Receive(*actuator_, Json::Parse(line));
      } catch (const std::exception& error) {
        // Each stream's own: one client in error hides no others.
        warnings_.Warn("{}: a stream message was ignored: {}", component_.full_name(),
                       error.what());
      }
    }
  }

  // The clients of a sensor are closed by the sender.
  void Close() {
    listener_->Close();
    for (const auto& client : clients_) {
      ErrorCode ignored;
      client->socket.close(ignored);
    }
    clients_.clear();
  }

 private:
  // Of an actuator.
  struct Client {
    Client(StreamSocket socket_in, std::size_t longest, std::uint64_t arrival_in)
        : socket(std::move(socket_in)), lines(longest), number(arrival_in) {}
    std::uint64_t arrival() const { return number; }
    StreamSocket socket;
    wire::LineSplitter lines;
    std::array<char, 4096> block{};
    std::uint64_t number;  // among the arrivals
    std::optional<std::string> newest;
  };

  void Take(tcp::socket socket) {
    if (shared_.stream_clients() >= shared_.options.most_stream_clients) {
      shared_.warnings.Warn("{}: more than {} stream connections, one was refused",
                            component_.full_name(), shared_.options.most_stream_clients);
      return;
    }
    ++shared_.arrivals;
    if (actuator_ == nullptr) {
      StreamSender& sender = late() ? shared_.late_sender : shared_.sender;
      return AddReader(sender.Take(std::move(socket)));
    }
    ++shared_.stream_writers;
    auto client = std::make_shared<Client>(std::move(socket), shared_.options.longest_stream_line,
                                           shared_.arrivals);
    clients_.insert(client);
    Read(client);
  }

  // The sender may be at work for the list that is.
  void AddReader(std::shared_ptr<StreamReader> reader) {
    auto readers = Connected();
    readers.push_back(std::move(reader));
    readers_ = std::make_shared<const StreamSender::Readers>(std::move(readers));
  }

  StreamSender::Readers Connected() const {
    StreamSender::Readers connected;
    std::copy_if(readers_->begin(), readers_->end(), std::back_inserter(connected),
                 [](const auto& reader) { return reader->connected(); });
    return connected;
  }

  // Would anybody take a line?
  bool Wanted() {
    bool wanted = false;
    bool all_there = true;
    for (const auto& reader : *readers_) {
      wanted = wanted || reader->ready();
      all_there = all_there && reader->connected();
    }
    if (!all_there) readers_ = std::make_shared<const StreamSender::Readers>(Connected());
    return wanted;
  }

  void Read(const std::shared_ptr<Client>& client) {
    client->socket.async_read_some(
        asio::buffer(client->block),
        [self = shared_from_this(), client](ErrorCode error, std::size_t size) {
          if (self->shared_.closed) return;
          if (error) return self->Drop(client);
          self->TakeBytes(*client, size);
          self->Read(client);
        });
  }

  void TakeBytes(Client& client, std::size_t size) {
    client.lines.Append(std::string_view(client.block.data(), size));
    std::string_view line;
    for (;;) {
      switch (client.lines.Next(&line)) {
        case wire::LineSplitter::Result::kLine:
          client.newest = std::string(line);
          break;
        case wire::LineSplitter::Result::kTooLong:
          shared_.warnings.Warn("{}: a stream message longer than {} bytes was dropped",
                                component_.full_name(), shared_.options.longest_stream_line);
          break;
        case wire::LineSplitter::Result::kNeedMore:
          return;
      }
    }
  }

  void Drop(const std::shared_ptr<Client>& client) {
    if (clients_.erase(client) == 0) return;
    --shared_.stream_writers;
    ErrorCode ignored;
    client->socket.close(ignored);
  }

  Shared& shared_;
  sim::Component& component_;
  sim::Sensor* sensor_;
  sim::LateText* late_text_;  // nullptr: its text is short
  sim::Actuator* actuator_;
  std::shared_ptr<Listener> listener_;
  WarningLimit warnings_;
  std::set<std::shared_ptr<Client>, Earlier> clients_;  // of an actuator
  std::shared_ptr<const StreamSender::Readers> readers_ =
      std::make_shared<const StreamSender::Readers>();  // of a sensor, in the order they came
  std::function<std::string()> text_;                   // of the line to be sent; or none
};

void MorseServer::Shared::SendStreams() {
  streams_wait = false;
  std::vector<StreamSender::Line> lines;
  std::vector<StreamSender::Line> late_lines;
  for (const auto& stream : streams) stream->AppendLine(stream->late() ? late_lines : lines);
  late_sender.Send(std::move(late_lines));
  sender.Send(std::move(lines));
}

// A client that has slept until now asks for a sensor's next line, and means that of this tick
// (specs: morse.md E.6): it gets the time to ask.
void MorseServer::Shared::SendStreamsLater() {
  streams_wait = true;
  const std::chrono::duration<double> quarter(0.25 / simulation.scenario().time.frequency);
  stream_timer.expires_after(
      std::min(std::chrono::duration_cast<Clock::duration>(quarter), kMostForAsking));
  stream_timer.async_wait([shared = shared_from_this()](ErrorCode error) {
    if (!error && !shared->closed) shared->SendStreams();
  });
}

MorseServer::MorseServer(asio::io_context& io, sim::Simulation& simulation,
                         ServiceDirectory& directory, const Pace& pace,
                         const MorseServerOptions& options) {
  shared_ = std::make_shared<Shared>(io, simulation, directory, pace, options);
  shared_->listener = std::make_shared<Listener>(io, [shared = shared_.get()](tcp::socket socket) {
    std::string name = PeerName(socket);
    shared->Take(std::move(socket), std::move(name));
  });
  if (!options.listen) return;
  if (options.listen_socket >= 0) {
    shared_->listener->Adopt(options.listen_socket);
  } else {
    shared_->listener->Open(options.bind, options.port, false);
  }
  // Ports go in the order of the components' names, as MORSE's builder writes them.
  int next_port = options.first_stream_port;
  for (sim::Component* component : simulation.components()) {
    if (!ServiceDirectory::HasStream(*component)) continue;
    auto stream = std::make_shared<Stream>(*shared_, *component);
    stream->Open(next_port);
    if (next_port != 0) next_port = stream->port() + 1;
    shared_->stream_of[component] = stream.get();
    shared_->streams.push_back(std::move(stream));
  }
}

MorseServer::~MorseServer() { Close(); }

void MorseServer::Close() {
  shared_->closed = true;
  shared_->stream_timer.cancel();
  shared_->listener->Close();
  for (const auto& stream : shared_->streams) stream->Close();
  shared_->sender.Close();
  shared_->late_sender.Close();
  for (const auto& connection : shared_->connections) connection->Close();
  shared_->connections.clear();
  // Handlers of the closed sockets still refer to what is ours: let them run before it goes.
  shared_->io.restart();
  shared_->io.poll();
}

int MorseServer::Connect() {
  auto [server, client] = ConnectedPair(shared_->io);
  asio::post(shared_->io, [shared = shared_, socket = std::move(server)]() mutable {
    if (!shared->closed) shared->Take(std::move(socket), kThisProgram);
  });
  return client;
}

int MorseServer::port() const { return shared_->options.listen ? shared_->listener->port() : 0; }

int MorseServer::StreamPort(const sim::Component& component) const {
  const auto found = shared_->stream_of.find(&component);
  return found != shared_->stream_of.end() ? found->second->port() : 0;
}

std::pair<int, int> MorseServer::stream_ports() const {
  if (shared_->streams.empty()) return {0, 0};
  std::pair<int, int> range{65536, 0};
  for (const auto& stream : shared_->streams) {
    range = {std::min(range.first, stream->port()), std::max(range.second, stream->port())};
  }
  return range;
}

void MorseServer::Sensed() {
  shared_->sensed_once = true;
  shared_->sensed_tick = shared_->simulation.tick();
  // Those of the last tick come first.
  if (shared_->streams_wait) {
    shared_->stream_timer.cancel();
    shared_->SendStreams();
  }
  for (const sim::Sensor* sensor : shared_->simulation.sampled()) {
    const auto stream = shared_->stream_of.find(sensor);
    if (stream != shared_->stream_of.end() && sensor->HasNews()) stream->second->Publish();
  }
  if (std::exchange(shared_->answered_late, false) && shared_->pace.name == "realtime") {
    shared_->SendStreamsLater();
  } else {
    shared_->SendStreams();
  }
  shared_->TellConnections();
}

void MorseServer::ApplyInputs() {
  for (const auto& stream : shared_->streams) stream->Apply();
}

int MorseServer::ReadersEver() const { return shared_->readers_ever; }

bool MorseServer::ReadersAreWaiting() const {
  return std::all_of(shared_->connections.begin(), shared_->connections.end(),
                     [](const auto& c) { return !c->reads() || c->waits(); });
}

bool MorseServer::HasReaders() const {
  return std::any_of(shared_->connections.begin(), shared_->connections.end(),
                     [](const auto& c) { return c->reads(); });
}

bool MorseServer::AwaitsNext() const {
  const std::uint64_t next = shared_->sensed_tick + 1;
  return std::any_of(shared_->connections.begin(), shared_->connections.end(),
                     [next](const auto& c) { return c->waits() && c->read_tick() <= next; });
}

bool MorseServer::HasClients() const {
  return !shared_->connections.empty() || shared_->stream_clients() > 0;
}

void MorseServer::EndReads(const std::string& reason) {
  shared_->ended = reason;
  shared_->TellConnections();
}

std::optional<Clock::time_point> MorseServer::WaitingSince() const {
  return servers::WaitingSince(shared_->connections);
}

std::optional<Clock::time_point> MorseServer::LetHangingGo(Clock::time_point waiting_since,
                                                           Clock::duration limit) {
  return servers::LetHangingGo(shared_->connections, waiting_since, limit, "client");
}

std::uint64_t MorseServer::SamplesUsed(const std::string& full_name) const {
  return shared_->directory.sample_use().count(full_name);
}

}  // namespace ccmorse::servers
