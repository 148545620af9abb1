#include "client/core/connection.h"

#include <array>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <future>
#include <mutex>
#include <string_view>
#include <thread>
#include <unordered_map>
#include <utility>

#include "libCCMorse/MorseError.h"

namespace CCMorse::core {

namespace asio = boost::asio;
using asio::ip::tcp;
using Clock = std::chrono::steady_clock;
using ErrorCode = boost::system::error_code;

namespace {

constexpr char kConnectFunction[] = "MorseClient::MorseClient()";
constexpr auto kConnectLimit = std::chrono::milliseconds(1900);
constexpr auto kSilenceBeforePing = std::chrono::seconds(1);
constexpr auto kSilenceAfterPing = std::chrono::milliseconds(1900);
// The pumping thread wakes at least this often, so that no missed wake-up can cost more.
constexpr auto kLongestSleep = std::chrono::milliseconds(500);

Clock::duration Seconds(double seconds) {
  // Held within a day: a longer time might overflow the clock's range.
  const double held = seconds < 0.0 ? 0.0 : (seconds < 86400.0 ? seconds : 86400.0);
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(held));
}

[[noreturn]] void ThrowConnect(const std::string& address, const std::string& reason) {
  throw MorseError("cannot connect to " + address + ": " + reason +
                       "; is the simulator running? (ccmorse listens on port 4000 by default)",
                   kConnectFunction);
}

// The system's look-up of names has no time limit, so it runs in a thread that may be left behind.
std::vector<tcp::endpoint> Resolve(const std::string& host, int port, const std::string& address) {
  if (host == "localhost") {  // always this machine (RFC 6761), known to its resolver or not
    const auto number = static_cast<std::uint16_t>(port);
    return {{asio::ip::address_v4::loopback(), number}, {asio::ip::address_v6::loopback(), number}};
  }
  struct Answer {
    ErrorCode error;
    std::vector<tcp::endpoint> endpoints;
  };
  auto promise = std::make_shared<std::promise<Answer>>();
  std::future<Answer> future = promise->get_future();
  std::thread([promise, host, port] {
    Answer answer;
    asio::io_context io;
    tcp::resolver resolver(io);
    for (const auto& entry : resolver.resolve(host, std::to_string(port), answer.error)) {
      answer.endpoints.push_back(entry.endpoint());
    }
    promise->set_value(std::move(answer));
  }).detach();
  if (future.wait_for(kConnectLimit) != std::future_status::ready) {
    ThrowConnect(address, "the host name was not resolved in time");
  }
  Answer answer = future.get();
  if (answer.error) ThrowConnect(address, answer.error.message());
  if (answer.endpoints.empty()) ThrowConnect(address, "the host has no address");
  return std::move(answer.endpoints);
}

std::string_view NextToken(std::string_view& line) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t begin = line.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) {
    line = {};
    return {};
  }
  const std::size_t end = line.find_first_of(kBlank, begin);
  const std::string_view token = line.substr(begin, end - begin);
  line = end == std::string_view::npos ? std::string_view() : line.substr(end);
  return token;
}

std::string_view Trim(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

}  // namespace

// Locking: `mutex_` guards every field but the socket and io_. The thread that has set `pumping_`
// runs handlers, without the mutex between them; while nobody pumps, whoever holds the mutex may
// touch the socket. Either way one thread at a time touches it.
struct Connection::Impl {
  // What an id was given to.
  struct Pending {
    std::shared_ptr<Batch> batch;  // nullptr: a command, or a ping when component is empty
    std::size_t index = 0;
    std::string component;
    std::string service;
  };

  Impl(const std::string& host, int port) : address(host + ":" + std::to_string(port)) {
    if (port < 1 || port > 65535) {
      throw MorseError("cannot connect to " + address + ": a port is a number from 1 to 65535",
                       kConnectFunction);
    }
    const auto deadline = Clock::now() + kConnectLimit;
    const std::vector<tcp::endpoint> endpoints = Resolve(host, port, address);
    ErrorCode outcome = asio::error::would_block;
    asio::async_connect(socket, endpoints,
                        [&outcome](const ErrorCode& ec, const tcp::endpoint&) { outcome = ec; });
    io.run_until(deadline);
    if (outcome == asio::error::would_block) {
      ErrorCode ignored;
      socket.close(ignored);
      io.restart();
      io.run();  // the cancelled connect still refers to `outcome`
      ThrowConnect(address, "no answer within 2 s");
    }
    if (outcome) ThrowConnect(address, outcome.message());
    // Without it, the kernel holds small requests back for up to 40 ms.
    socket.set_option(tcp::no_delay(true), outcome);
    last_heard = Clock::now();
    io.restart();
    StartRead();
  }

  ~Impl() {
    // Handlers that never ran are destroyed with io, after the socket: they hold plain pointers
    // only.
    ErrorCode ignored;
    socket.close(ignored);
  }

  // --- Called by the pumping thread, or under the mutex while nobody pumps.

  void StartRead() {
    socket.async_read_some(asio::buffer(chunk), [this](const ErrorCode& ec, std::size_t count) {
      {
        const std::lock_guard lock(mutex);
        if (!error.empty()) return;
        if (ec) {
          Fail(ec == asio::error::eof ? "the simulator closed the connection to " + address
                                      : "the connection to " + address + " broke: " + ec.message());
          return;
        }
        TakeBytes(std::string_view(chunk.data(), count));
        changed.notify_all();
        if (!error.empty()) return;
      }
      StartRead();
    });
  }

  void StartWrite() {  // mutex held
    if (writing || outgoing.empty() || !error.empty()) return;
    writing = true;
    in_flight.swap(outgoing);
    outgoing.clear();
    asio::async_write(socket, asio::buffer(in_flight), [this](const ErrorCode& ec, std::size_t) {
      const std::lock_guard lock(mutex);
      writing = false;
      in_flight.clear();
      // A broken connection is reported by the read, after what still comes in was taken.
      if (ec) {
        outgoing.clear();
        write_failed = true;
      }
      StartWrite();
      changed.notify_all();
    });
  }

  // --- Mutex held.

  void Fail(const std::string& what) {
    if (error.empty()) error = what;
    pending.clear();
    queued.clear();
    outgoing.clear();
    commands_open = 0;
    changed.notify_all();
  }

  void TakeBytes(std::string_view bytes) {
    std::size_t end = bytes.find('\n');
    if (end == std::string_view::npos) {
      last_heard = Clock::now();  // a long line is on its way
      incoming.append(bytes);
      if (incoming.size() > kMaxLine) {
        ErrorCode ignored;
        socket.close(ignored);
        Fail("the simulator at " + address + " sent a line longer than " +
             std::to_string(kMaxLine >> 20) + " MiB");
      }
      return;
    }
    if (!incoming.empty()) {
      incoming.append(bytes.substr(0, end));
      TakeLine(incoming);
      incoming.clear();
      bytes.remove_prefix(end + 1);
      end = bytes.find('\n');
    }
    while (end != std::string_view::npos) {
      TakeLine(bytes.substr(0, end));
      bytes.remove_prefix(end + 1);
      end = bytes.find('\n');
    }
    incoming.append(bytes);
  }

  // "id STATUS [value]". What is no such line, or answers nothing that was asked, is left alone: it
  // cannot be told whom it was meant for.
  void TakeLine(std::string_view line) {
    const std::string_view token = NextToken(line);
    const std::string_view status = NextToken(line);
    std::uint64_t id = 0;
    const auto parsed = std::from_chars(token.data(), token.data() + token.size(), id);
    if (token.empty() || parsed.ec != std::errc() || parsed.ptr != token.data() + token.size())
      return;
    const bool success = status == "SUCCESS";
    if (!success && status != "FAILED" && status != "PREEMPTED") return;
    const auto found = pending.find(id);
    if (found == pending.end()) return;
    last_heard = Clock::now();
    const Pending entry = std::move(found->second);
    pending.erase(found);
    line = Trim(line);
    if (entry.batch) {
      Reply& reply = entry.batch->replies[entry.index];
      reply.done = true;
      reply.success = success;
      reply.text = std::string(line);
      reply.preempted = status == "PREEMPTED";
      --entry.batch->missing;
    } else if (!entry.component.empty()) {
      --commands_open;
      if (!success && !refusal)
        refusal = Refusal{entry.component, entry.service, std::string(line)};
    }
  }

  static void AppendRequest(std::string& out, std::uint64_t id, const Request& request) {
    out += std::to_string(id);
    out += ' ';
    out += request.component;
    out += ' ';
    out += request.service;
    if (!request.args.empty()) {
      out += ' ';
      out += request.args;
    }
    out += '\n';
  }

  void MoveQueued() {
    outgoing += queued;
    queued.clear();
  }

  // Gets `outgoing` onto the socket: here when nobody pumps, else by the pumping thread.
  void Write() {
    if (pumping) {
      asio::post(io, [this] {
        const std::lock_guard lock(mutex);
        StartWrite();
      });
    } else {
      StartWrite();
    }
  }

  void SendPing() {
    const std::uint64_t id = next_id++;
    pending.emplace(id, Pending());
    outgoing += std::to_string(id) + ' ' + ping + '\n';
    Write();
  }

  // Waits, pumping when nobody else does, until `done()` or `until`; true when done. `lock` is held
  // on entry and exit. Returns on any event, so callers loop.
  void PumpOnce(std::unique_lock<std::mutex>& lock, Clock::time_point until) {
    until = std::min(until, Clock::now() + kLongestSleep);
    if (pumping) {
      changed.wait_until(lock, until);
      return;
    }
    pumping = true;
    lock.unlock();
    if (io.stopped()) io.restart();
    io.run_one_until(until);
    lock.lock();
    pumping = false;
    changed.notify_all();  // another waiting thread takes over
  }

  const std::string address;
  asio::io_context io;
  tcp::socket socket{io};
  std::array<char, 65536> chunk{};

  mutable std::mutex mutex;
  std::condition_variable changed;
  bool pumping = false;
  std::string error;  // why the connection is down; empty while it stands
  std::uint64_t next_id = 1;
  std::unordered_map<std::uint64_t, Pending> pending;
  std::size_t commands_open = 0;  // commands without an answer, queued ones included
  std::string queued;             // commands that wait for the next Send() or Flush()
  std::string outgoing;           // to be written next
  std::string in_flight;          // being written
  bool writing = false;
  bool write_failed = false;
  std::string incoming;  // the start of a line
  Clock::time_point last_heard;
  std::string ping;
  bool reading = false;
  std::optional<Refusal> refusal;
};

Connection::Connection(const std::string& host, int port)
    : impl_(std::make_unique<Impl>(host, port)) {}

Connection::~Connection() = default;

bool Connection::Alive() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->error.empty();
}

void Connection::SetPing(const std::string& request) {
  const std::lock_guard lock(impl_->mutex);
  impl_->ping = request;
}

void Connection::SetReading(bool reading) {
  const std::lock_guard lock(impl_->mutex);
  impl_->reading = reading;
}

void Connection::Queue(const Request& command) {
  bool full = false;
  {
    const std::lock_guard lock(impl_->mutex);
    if (!impl_->error.empty()) return;
    const std::uint64_t id = impl_->next_id++;
    Impl::Pending entry;
    entry.component = command.component;
    entry.service = command.service;
    impl_->pending.emplace(id, std::move(entry));
    ++impl_->commands_open;
    Impl::AppendRequest(impl_->queued, id, command);
    full = impl_->queued.size() > kMaxQueued;
  }
  if (full) Flush(5.0);
}

std::shared_ptr<Batch> Connection::Send(const std::vector<Request>& requests) {
  auto batch = std::make_shared<Batch>();
  batch->replies.resize(requests.size());
  batch->missing = requests.size();
  const std::lock_guard lock(impl_->mutex);
  if (!impl_->error.empty()) return batch;  // Wait() reports it
  impl_->MoveQueued();
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const std::uint64_t id = impl_->next_id++;
    Impl::Pending entry;
    entry.batch = batch;
    entry.index = i;
    impl_->pending.emplace(id, std::move(entry));
    Impl::AppendRequest(impl_->outgoing, id, requests[i]);
  }
  impl_->Write();
  return batch;
}

void Connection::Flush(double patience) {
  std::unique_lock lock(impl_->mutex);
  if (!impl_->error.empty()) return;
  impl_->MoveQueued();
  impl_->Write();
  const auto deadline = Clock::now() + Seconds(patience);
  while (impl_->error.empty() && impl_->outgoing.size() > kMaxQueued) {
    if (Clock::now() >= deadline) {
      impl_->Fail("the simulator at " + impl_->address + " takes no commands any more");
      return;
    }
    impl_->PumpOnce(lock, deadline);
  }
}

Connection::Outcome Connection::Wait(const std::shared_ptr<Batch>& batch, const Patience& patience,
                                     const char* function) {
  std::unique_lock lock(impl_->mutex);
  const auto start = Clock::now();
  auto deadline = start + Seconds(patience.timeout);
  Clock::time_point pinged{};  // when the last ping left; before last_heard when it was answered
  while (batch->missing > 0) {
    if (!impl_->error.empty()) throw MorseError(impl_->error, function);
    if (patience.abandon && *patience.abandon) return Outcome::kAbandoned;
    const auto now = Clock::now();
    const auto heard = std::max(start, impl_->last_heard);
    Clock::time_point until;
    if (patience.timeout > 0.0) {
      if (impl_->reading) deadline = now + Seconds(patience.timeout);
      if (now >= deadline) return Outcome::kTimeout;
      until = deadline;
    } else if (patience.silence > 0.0) {
      until = heard + Seconds(patience.silence);
      if (now >= until) return Outcome::kTimeout;
    } else if (pinged > heard) {
      until = pinged + kSilenceAfterPing;
      if (now >= until) {
        impl_->Fail("the simulator at " + impl_->address + " does not answer any more");
        continue;
      }
    } else {
      until = heard + kSilenceBeforePing;
      if (now >= until) {
        impl_->SendPing();
        pinged = now;
        until = pinged + kSilenceAfterPing;
      }
    }
    impl_->PumpOnce(lock, until);
  }
  return Outcome::kDone;
}

void Connection::Wake() {
  const std::lock_guard lock(impl_->mutex);
  impl_->changed.notify_all();
  if (impl_->pumping) asio::post(impl_->io, [] {});
}

std::optional<Refusal> Connection::TakeRefusal() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->refusal, std::nullopt);
}

void Connection::Close(double patience) noexcept {
  try {
    std::unique_lock lock(impl_->mutex);
    if (impl_->error.empty()) {
      impl_->MoveQueued();
      impl_->Write();
      // Closing with answers unread would reset the connection, and the simulator might lose the
      // commands that are still on their way to it.
      const auto deadline = Clock::now() + Seconds(patience);
      while (impl_->error.empty() && !impl_->write_failed &&
             (impl_->commands_open > 0 || impl_->writing) && Clock::now() < deadline) {
        impl_->PumpOnce(lock, deadline);
      }
    }
    impl_->Fail("the client is closed");
    // Other threads may still pump: they leave when they see the error.
    if (impl_->pumping) asio::post(impl_->io, [] {});
    const auto deadline = Clock::now() + Seconds(1.0);
    while (impl_->pumping && Clock::now() < deadline) impl_->changed.wait_until(lock, deadline);
    if (!impl_->pumping) {
      ErrorCode ignored;
      impl_->socket.shutdown(tcp::socket::shutdown_both, ignored);
      impl_->socket.close(ignored);
    }
  } catch (const std::exception&) {
    // Out of memory, or the mutex failed: the socket closes with the process at the latest.
  }
}

}  // namespace CCMorse::core
