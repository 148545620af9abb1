#include "servers/morse/morse_server.h"

#include <algorithm>
#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <cmath>
#include <deque>
#include <optional>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/log.h"
#include "wire/morse_line.h"

namespace ccmorse::servers {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using ErrorCode = boost::system::error_code;
using sim::Outcome;

constexpr std::size_t kReadBlock = 64U << 10;
constexpr auto kTurn = std::chrono::milliseconds(1);  // of one connection before others get theirs
constexpr auto kAcceptPause = std::chrono::milliseconds(100);

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

// Lets a few warnings a second through, so that garbage from the network cannot fill a disk.
class WarningLimit {
 public:
  template <typename... Args>
  void Warn(fmt::format_string<Args...> format, Args&&... args) {
    const auto now = std::chrono::steady_clock::now();
    if (now - since_ > std::chrono::seconds(1)) {
      if (count_ > kPerSecond) LogWarning("... and {} more like these", count_ - kPerSecond);
      since_ = now;
      count_ = 0;
    }
    if (++count_ <= kPerSecond) LogWarning(format, std::forward<Args>(args)...);
  }

 private:
  static constexpr int kPerSecond = 5;
  std::chrono::steady_clock::time_point since_{};
  int count_ = 0;
};

// A listening socket that hands on every accepted one, and waits a little when the system has no
// more file handles, instead of asking without end.
class Listener : public std::enable_shared_from_this<Listener> {
 public:
  using Taker = std::function<void(tcp::socket)>;

  Listener(asio::io_context& io, Taker take) : acceptor_(io), pause_(io), take_(std::move(take)) {}

  // Port 0 takes any free one. With `search`, taken ports are passed over.
  void Open(const std::string& address, int port, bool search) {
    ErrorCode error;
    const auto ip = asio::ip::make_address(address, error);
    if (error) throw Error("cannot listen on '" + address + "': it is not an IP address");
    for (;; ++port) {
      const tcp::endpoint endpoint(ip, static_cast<std::uint16_t>(port));
      acceptor_.open(endpoint.protocol());
      acceptor_.set_option(tcp::acceptor::reuse_address(true));
      acceptor_.bind(endpoint, error);
      if (!error) acceptor_.listen(tcp::acceptor::max_listen_connections, error);
      if (!error) break;
      acceptor_.close();
      if (!search || error != asio::error::address_in_use || port >= 65535) {
        throw Error("cannot listen on " + address + " port " + std::to_string(port) + ": " +
                    error.message() +
                    (error == asio::error::address_in_use
                         ? "; another simulation may be running there, choose another with --port"
                         : ""));
      }
    }
    Accept();
  }

  int port() const {
    ErrorCode ignored;
    return acceptor_.local_endpoint(ignored).port();
  }

  void Close() {
    ErrorCode ignored;
    acceptor_.close(ignored);
    pause_.cancel();
    take_ = nullptr;
  }

 private:
  void Accept() {
    acceptor_.async_accept([self = shared_from_this()](ErrorCode error, tcp::socket socket) {
      if (!self->take_ || error == asio::error::operation_aborted) return;
      if (error) {
        self->warnings_.Warn("cannot accept a connection: {}", error.message());
        self->pause_.expires_after(kAcceptPause);
        self->pause_.async_wait([self](ErrorCode stopped) {
          if (!stopped && self->take_) self->Accept();
        });
        return;
      }
      ErrorCode ignored;
      socket.set_option(tcp::no_delay(true), ignored);
      socket.non_blocking(true, ignored);
      self->take_(std::move(socket));
      self->Accept();
    });
  }

  tcp::acceptor acceptor_;
  asio::steady_timer pause_;
  Taker take_;
  WarningLimit warnings_;
};

// Bytes on their way out of one socket. What the socket takes at once goes at once; the rest
// follows as the peer reads.
class Outbox {
 public:
  explicit Outbox(tcp::socket& socket) : socket_(socket) {}

  std::string& text() { return waiting_; }
  std::size_t size() const { return waiting_.size() + sending_.size() - sent_; }
  bool busy() const { return busy_; }

  // `keep` holds the owner alive; `done` is called after each completed write, with its error.
  template <typename Done>
  void Flush(std::shared_ptr<void> keep, Done done) {
    if (busy_ || waiting_.empty()) return;
    sending_.swap(waiting_);
    waiting_.clear();
    ErrorCode error;
    sent_ = socket_.write_some(asio::buffer(sending_), error);
    if (error && error != asio::error::would_block) {
      sending_.clear();
      sent_ = 0;
      return done(error);
    }
    if (error) sent_ = 0;
    if (sent_ == sending_.size()) {
      sending_.clear();
      sent_ = 0;
      return;
    }
    busy_ = true;
    asio::async_write(socket_, asio::buffer(sending_) + sent_,
                      [this, keep = std::move(keep), done](ErrorCode failed, std::size_t) {
                        busy_ = false;
                        sending_.clear();
                        sent_ = 0;
                        done(failed);
                      });
  }

 private:
  tcp::socket& socket_;
  std::string waiting_;
  std::string sending_;
  std::size_t sent_ = 0;
  bool busy_ = false;
};

}  // namespace

// What all connections use. Connections hold it weakly or by reference through the server's
// lifetime; `closed` tells handlers that still run that the server has gone.
struct MorseServer::Shared : std::enable_shared_from_this<MorseServer::Shared> {
  Shared(asio::io_context& io_in, sim::Simulation& simulation_in, RunControl control,
         const Pace& pace_in, const MorseServerOptions& options_in)
      : io(io_in),
        simulation(simulation_in),
        pace(pace_in),
        options(options_in),
        directory(simulation_in, std::move(control)) {}

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

  void CountUse(const sim::Sensor& sensor) {
    Use& use = uses[sensor.full_name()];
    if (sensor.samples() == use.last_sample) return;
    use.last_sample = sensor.samples();
    ++use.count;
  }

  struct Use {
    std::uint64_t last_sample = 0;
    std::uint64_t count = 0;
  };

  asio::io_context& io;
  sim::Simulation& simulation;
  Pace pace;
  MorseServerOptions options;
  ServiceDirectory directory;
  std::shared_ptr<Listener> listener;
  std::set<std::shared_ptr<ServiceConnection>> connections;
  std::vector<std::shared_ptr<StreamPort>> streams;
  std::size_t stream_clients = 0;
  int readers_ever = 0;  // connections that have sent a read
  bool sensed_once = false;
  std::uint64_t sensed_tick = 0;  // of the last Sense()
  std::string ended;              // why reads fail, once the run is over
  std::map<std::string, Use> uses;
  WarningLimit warnings;
  bool closed = false;
};

// One client of the service port. Requests are answered in order; a `read` holds back those behind
// it until its time has come.
class MorseServer::ServiceConnection
    : public std::enable_shared_from_this<MorseServer::ServiceConnection> {
 public:
  ServiceConnection(Shared& shared, tcp::socket socket)
      : shared_(shared),
        socket_(std::move(socket)),
        peek_timer_(shared.io),
        outbox_(socket_),
        lines_(shared.options.longest_request) {}

  void Start() { Read(); }

  bool reads() const { return joined_; }
  bool read_outstanding() const { return read_id_.has_value(); }
  std::uint64_t read_tick() const { return shared_.ReadTick(next_read_); }

  // After a Sense(): the outstanding read or peek may be due now.
  void Sensed() {
    if (!DataAreDue()) return;
    if (peek_id_) {
      AnswerPeek(true);
    } else if (!read_id_ || !AnswerRead()) {
      return;
    }
    Process();
  }

  void Close() {
    ErrorCode ignored;
    socket_.close(ignored);
    peek_timer_.cancel();
  }

 private:
  void Read() {
    reading_ = true;
    block_.resize(kReadBlock);
    socket_.async_read_some(asio::buffer(block_),
                            [self = shared_from_this()](ErrorCode error, std::size_t size) {
                              self->reading_ = false;
                              if (self->shared_.closed) return;
                              if (error) return self->Leave();
                              self->lines_.Append(std::string_view(self->block_.data(), size));
                              if (self->read_id_) self->AnswerPings();
                              self->Process();
                            });
  }

  // Reads on unless the client floods us or does not fetch its replies.
  void KeepReading() {
    if (reading_ || !socket_.is_open()) return;
    if (outbox_.size() > shared_.options.most_unread) return;  // goes on when they are sent
    if (lines_.buffered() + queued_bytes_ > shared_.options.longest_request + kReadBlock) return;
    Read();
  }

  // Answers requests until a read holds them back, the client's replies pile up or it had its turn.
  void Process() {
    if (shared_.closed || !socket_.is_open()) return;
    bool more = false;
    serving_ = true;
    const auto until = std::chrono::steady_clock::now() + kTurn;
    while (!held_back() && outbox_.size() <= shared_.options.most_unread) {
      if (std::chrono::steady_clock::now() > until) {
        more = true;
        break;
      }
      if (!TakeLine()) break;
      Serve(line_);
    }
    serving_ = false;
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

  bool held_back() const { return read_id_.has_value() || peek_id_.has_value(); }

  bool TakeLine() {
    if (!queue_.empty()) {
      line_ = std::move(queue_.front());
      queue_.pop_front();
      queued_bytes_ -= line_.size();
      return true;
    }
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
    wire::AppendMorseReply(outbox_.text(), "", "FAILED",
                           Json("Malformed request! A line may have at most " +
                                std::to_string(shared_.options.longest_request) + " bytes"));
  }

  // While a read waits, lines are set aside, but for pings.
  void AnswerPings() {
    std::string_view line;
    for (;;) {
      const auto result = lines_.Next(&line);
      if (result == wire::LineSplitter::Result::kNeedMore) break;
      if (result == wire::LineSplitter::Result::kTooLong) {
        RefuseLongLine();
        continue;
      }
      const wire::MorseRequest request = wire::ParseMorseRequest(line);
      if (request.component == "ccmorse" && request.service == "ping") {
        Reply(request.id, {Outcome::kSuccess, Json("pong")});
      } else {
        queued_bytes_ += line.size();
        queue_.emplace_back(line);
      }
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
          if (!self->serving_) self->Flush();
        });
    if (request.service == "get_local_data") {
      const auto* sensor = dynamic_cast<sim::Sensor*>(shared_.simulation.FindComponent(component));
      if (sensor != nullptr) shared_.CountUse(*sensor);
    }
  }

  // `id cancel` interrupts whatever runs under that id, for whichever client (specs: morse.md A.5).
  void Cancel(const std::string& id) {
    std::vector<std::string> components;
    for (const auto& connection : shared_.connections) {
      const auto [first, last] = connection->pending_.equal_range(id);
      for (auto entry = first; entry != last; ++entry) components.push_back(entry->second);
    }
    for (const std::string& name : components) {
      sim::Component* component = shared_.simulation.FindComponent(name);
      if (component != nullptr) component->Interrupt();
    }
  }

  // The services of docs/protocols/ccmorse-services.md.
  bool ServeOwn(const wire::MorseRequest& request) {
    if (request.service == "read") {
      read_id_ = std::string(request.id);
      if (!joined_) {
        joined_ = true;
        ++shared_.readers_ever;
        // The first read gets what the sensors show now, or will show first.
        next_read_ = shared_.sensed_once ? shared_.ReadAt(shared_.sensed_tick) : 0;
      } else if (shared_.pace.name != "lockstep") {
        // A client that was slow gets the newest data, not the ones that it missed.
        next_read_ = std::max(next_read_, shared_.ReadAt(shared_.sensed_tick));
      }
      AnswerRead();
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
                               {"pace", shared_.pace.name},
                               {"frequency", shared_.simulation.scenario().time.frequency},
                               {"read_period", 1.0 / shared_.pace.read_frequency}})});
      return true;
    }
    if (request.service == "peek") {
      ServePeek(request);
      return true;
    }
    return false;
  }

  bool DataAreDue() const {
    return !shared_.ended.empty() || (shared_.sensed_once && read_tick() <= shared_.sensed_tick);
  }

  // Answers the outstanding read if its time has come.
  bool AnswerRead() {
    if (!DataAreDue()) return false;
    const std::string id = *std::exchange(read_id_, std::nullopt);
    if (!shared_.ended.empty()) {
      Reply(id, {Outcome::kFailed, Json(shared_.ended)});
      return true;
    }
    ++next_read_;
    const double seconds =
        static_cast<double>(shared_.sensed_tick) / shared_.simulation.scenario().time.frequency;
    Reply(id, {Outcome::kSuccess, Json(Json::Object{{"time", seconds}})});
    return true;
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
    peek_timer_.expires_after(std::chrono::duration_cast<std::chrono::steady_clock::duration>(
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

  void Leave() {
    if (left_) return;
    left_ = true;
    Close();
    shared_.connections.erase(shared_from_this());
  }

  Shared& shared_;
  tcp::socket socket_;
  asio::steady_timer peek_timer_;
  Outbox outbox_;
  wire::LineSplitter lines_;
  std::vector<char> block_;
  std::string line_;
  std::deque<std::string> queue_;  // lines set aside while a read waits
  std::size_t queued_bytes_ = 0;
  std::multimap<std::string, std::string> pending_;  // id -> component, of running services
  std::optional<std::string> read_id_;
  std::optional<std::string> peek_id_;
  std::uint64_t next_read_ = 0;
  bool joined_ = false;
  bool reading_ = false;
  bool serving_ = false;
  bool turn_posted_ = false;
  bool left_ = false;
};

// The stream of one component: a sensor's lines go to every client, an actuator takes every
// client's newest line.
class MorseServer::StreamPort : public std::enable_shared_from_this<MorseServer::StreamPort> {
 public:
  StreamPort(Shared& shared, sim::Component& component)
      : shared_(shared),
        component_(component),
        sensor_(dynamic_cast<sim::Sensor*>(&component)),
        actuator_(dynamic_cast<sim::Actuator*>(&component)) {}

  void Open(int port) {
    listener_ = std::make_shared<Listener>(shared_.io,
                                           [this](tcp::socket socket) { Take(std::move(socket)); });
    listener_->Open(shared_.options.bind, port, true);
  }

  int port() const { return listener_->port(); }
  const sim::Component& component() const { return component_; }

  void Publish() {
    if (sensor_ == nullptr || clients_.empty()) return;
    const std::string& data = sensor_->LocalData();
    bool sent = false;
    for (const auto& client : std::vector(clients_.begin(), clients_.end())) {
      // A slow reader misses lines; it never holds up the simulation (specs: morse.md A.3).
      if (client->outbox.busy()) continue;
      client->outbox.text() += data;
      client->outbox.text() += '\n';
      client->outbox.Flush(client, [this, client](ErrorCode error) {
        if (error) Drop(client);
      });
      sent = true;
    }
    if (sent) shared_.CountUse(*sensor_);
  }

  void Apply() {
    if (actuator_ == nullptr || !actuator_->active()) return;
    for (const auto& client : clients_) {
      if (!client->newest) continue;
      const std::string line = *std::exchange(client->newest, std::nullopt);
      try {
        actuator_->Receive(Json::Parse(line));
      } catch (const std::exception& error) {
        shared_.warnings.Warn("{}: a stream message was ignored: {}", component_.full_name(),
                              error.what());
      }
    }
  }

  void Close() {
    listener_->Close();
    for (const auto& client : clients_) {
      ErrorCode ignored;
      client->socket.close(ignored);
    }
    clients_.clear();
  }

 private:
  struct Client {
    Client(tcp::socket socket_in, std::size_t longest)
        : socket(std::move(socket_in)), outbox(socket), lines(longest) {}
    tcp::socket socket;
    Outbox outbox;
    wire::LineSplitter lines;
    std::array<char, 4096> block{};
    std::optional<std::string> newest;
  };

  void Take(tcp::socket socket) {
    if (shared_.stream_clients >= shared_.options.most_stream_clients) {
      shared_.warnings.Warn("{}: more than {} stream connections, one was refused",
                            component_.full_name(), shared_.options.most_stream_clients);
      return;
    }
    ++shared_.stream_clients;
    auto client = std::make_shared<Client>(std::move(socket), shared_.options.longest_stream_line);
    clients_.insert(client);
    Read(client);
  }

  // What a client writes to a sensor's port is read and forgotten; so we notice when it leaves.
  void Read(const std::shared_ptr<Client>& client) {
    client->socket.async_read_some(
        asio::buffer(client->block),
        [self = shared_from_this(), client](ErrorCode error, std::size_t size) {
          if (self->shared_.closed) return;
          if (error) return self->Drop(client);
          if (self->actuator_ != nullptr) self->TakeBytes(*client, size);
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
    --shared_.stream_clients;
    ErrorCode ignored;
    client->socket.close(ignored);
  }

  Shared& shared_;
  sim::Component& component_;
  sim::Sensor* sensor_;
  sim::Actuator* actuator_;
  std::shared_ptr<Listener> listener_;
  std::set<std::shared_ptr<Client>> clients_;
};

MorseServer::MorseServer(asio::io_context& io, sim::Simulation& simulation, RunControl control,
                         const Pace& pace, const MorseServerOptions& options) {
  control.stream_port = [this](const sim::Component& component) {
    for (const auto& stream : shared_->streams) {
      if (&stream->component() == &component) return stream->port();
    }
    return 0;
  };
  shared_ = std::make_shared<Shared>(io, simulation, std::move(control), pace, options);
  shared_->listener = std::make_shared<Listener>(io, [shared = shared_.get()](tcp::socket socket) {
    if (shared->connections.size() >= shared->options.most_clients) {
      shared->warnings.Warn("more than {} connections to the service port, one was refused",
                            shared->options.most_clients);
      return;
    }
    const auto connection = std::make_shared<ServiceConnection>(*shared, std::move(socket));
    shared->connections.insert(connection);
    connection->Start();
  });
  shared_->listener->Open(options.bind, options.port, false);
  // Ports go in the order of the components' names, as MORSE's builder writes them.
  int next_port = options.first_stream_port;
  for (sim::Component* component : simulation.components()) {
    if (!ServiceDirectory::HasStream(*component)) continue;
    auto stream = std::make_shared<StreamPort>(*shared_, *component);
    stream->Open(next_port);
    if (next_port != 0) next_port = stream->port() + 1;
    shared_->streams.push_back(std::move(stream));
  }
}

MorseServer::~MorseServer() { Close(); }

void MorseServer::Close() {
  shared_->closed = true;
  shared_->listener->Close();
  for (const auto& stream : shared_->streams) stream->Close();
  for (const auto& connection : shared_->connections) connection->Close();
  shared_->connections.clear();
  // Handlers of the closed sockets still refer to what is ours: let them run before it goes.
  shared_->io.restart();
  shared_->io.poll();
}

int MorseServer::port() const { return shared_->listener->port(); }

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
  const auto& sampled = shared_->simulation.sampled();
  for (const auto& stream : shared_->streams) {
    if (std::find(sampled.begin(), sampled.end(), &stream->component()) != sampled.end()) {
      stream->Publish();
    }
  }
  const std::vector connections(shared_->connections.begin(), shared_->connections.end());
  for (const auto& connection : connections) connection->Sensed();
}

void MorseServer::ApplyStreams() {
  for (const auto& stream : shared_->streams) stream->Apply();
}

void MorseServer::TimeAdvanced() { shared_->directory.TimeAdvanced(); }

bool MorseServer::ClientsAreWaiting(int clients) const {
  return HasReaders() && shared_->readers_ever >= clients &&
         std::all_of(shared_->connections.begin(), shared_->connections.end(),
                     [](const auto& c) { return !c->reads() || c->read_outstanding(); });
}

bool MorseServer::HasReaders() const {
  return std::any_of(shared_->connections.begin(), shared_->connections.end(),
                     [](const auto& c) { return c->reads(); });
}

bool MorseServer::HasClients() const {
  return !shared_->connections.empty() || shared_->stream_clients > 0;
}

void MorseServer::EndReads(const std::string& reason) {
  shared_->ended = reason;
  const std::vector connections(shared_->connections.begin(), shared_->connections.end());
  for (const auto& connection : connections) connection->Sensed();
}

std::uint64_t MorseServer::SamplesUsed(const std::string& full_name) const {
  const auto use = shared_->uses.find(full_name);
  return use == shared_->uses.end() ? 0 : use->second.count;
}

}  // namespace ccmorse::servers
