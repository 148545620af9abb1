#include "client/core/connection.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string_view>
#include <system_error>
#include <thread>
#include <unordered_map>
#include <utility>

#include "client/core/address.h"
#include "client/core/in_process.h"
#include "client/core/tcp_connect.h"
#include "client/core/vigil.h"
#include "libCCMorse/MorseError.h"
#include "wire/fast_link.h"

namespace CCMorse::core {

using Clock = std::chrono::steady_clock;

namespace {

constexpr char kConnectFunction[] = "MorseClient::MorseClient()";
constexpr auto kConnectLimit = std::chrono::milliseconds(1900);
constexpr auto kSilenceBeforePing = std::chrono::seconds(1);
constexpr auto kSilenceAfterPing = std::chrono::milliseconds(1900);
// The pumping thread wakes at least this often, so that no missed wake-up can cost more.
constexpr auto kLongestSleep = std::chrono::milliseconds(500);
constexpr std::size_t kReadBlock = std::size_t{64} << 10;

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

// Locking: `mutex` guards every field but those of the pumping thread, which is the one that has
// set `pumping`: it alone receives, without the mutex. Whoever holds the mutex may send.
struct Connection::Impl {
  // What an id was given to.
  struct Pending {
    std::shared_ptr<Batch> batch;  // nullptr: a command, or a ping when component is empty
    std::size_t index = 0;
    std::string component;
    std::string service;
  };

  Impl(const std::string& host, int port)
      : address(AddressText(host, port)), wake_handle(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    try {
      if (wake_handle < 0) ThrowConnect(address, SystemText(errno));
      Open(host, port);
    } catch (...) {
      if (wake_handle >= 0) ::close(wake_handle);
      throw;
    }
    last_heard = Clock::now();
  }

  ~Impl() {
    if (wake_handle >= 0) ::close(wake_handle);
    CloseHandle();
  }

  void Open(const std::string& host, int port) {
    if (IsInProcess(host)) {
      InProcessSocket socket = ConnectInProcess(host, false, kConnectFunction);
      handle = socket.handle;
      simulation = std::move(socket.simulation);
      return;
    }
    if (port < 1 || port > 65535) {
      throw MorseError("cannot connect to " + address + ": a port is a number from 1 to 65535",
                       kConnectFunction);
    }
    std::string reason;
    handle = ConnectTcp(host, port, kConnectLimit, &reason);
    if (handle < 0) ThrowConnect(address, reason);
  }

  // Nobody else uses the handle.
  void CloseHandle() {
    if (handle >= 0) ::close(std::exchange(handle, -1));
    simulation.reset();  // which sees that its client has left
  }

  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  static std::string SystemText(int code) { return std::system_category().message(code); }

  // --- The pumping thread, without the mutex.

  enum class Came { kBytes, kEnd, kError, kNothing };

  // Waits for bytes, for room to send with `to_send`, for Wake() or until the time has come.
  Came Receive(Clock::time_point until, Clock::time_point expected, bool to_send) {
    vigil.Begin(until, expected);
    bool slept = false;
    for (;;) {
      const ssize_t size = splitter ? ReceiveTo(splitter->Space(kReadBlock), kReadBlock)
                                    : ReceiveTo(chunk.data(), chunk.size());
      if (size >= 0) {
        received = static_cast<std::size_t>(size);
        return size == 0 ? Came::kEnd : Came::kBytes;
      }
      if (errno != EAGAIN && errno != EWOULDBLOCK) {
        receive_error = errno;
        return Came::kError;
      }
      if (slept || woken.exchange(false)) return Came::kNothing;
      if (vigil.StaysAwake()) continue;
      Sleep(vigil.sleep_until(), to_send);
      slept = true;
    }
  }

  ssize_t ReceiveTo(char* to, std::size_t size) const {
    for (;;) {
      const ssize_t got = ::recv(handle, to, size, MSG_DONTWAIT);
      if (got >= 0 || errno != EINTR) return got;
    }
  }

  void Sleep(Clock::time_point until, bool to_send) const {
    const auto left = std::chrono::nanoseconds(until - Clock::now()).count();
    if (left <= 0) return;
    const timespec limit{left / 1'000'000'000, left % 1'000'000'000};
    pollfd handles[2] = {{handle, static_cast<short>(to_send ? POLLIN | POLLOUT : POLLIN), 0},
                         {wake_handle, POLLIN, 0}};
    if (::ppoll(handles, 2, &limit, nullptr) <= 0 || handles[1].revents == 0) return;
    std::uint64_t ignored = 0;
    if (::read(wake_handle, &ignored, sizeof ignored) < 0) return;  // another took it
  }

  // --- Mutex held.

  // Has the pumping thread look around.
  void WakePump() {
    woken = true;
    const std::uint64_t one = 1;
    if (::write(wake_handle, &one, sizeof one) < 0) return;  // it is awake as often as can be
  }

  bool unsent() const { return sent < outgoing.size(); }

  // Sends what the socket takes now.
  void SendSome() {
    while (error.empty() && unsent()) {
      const ssize_t size = ::send(handle, outgoing.data() + sent, outgoing.size() - sent,
                                  MSG_DONTWAIT | MSG_NOSIGNAL);
      if (size >= 0) {
        sent += static_cast<std::size_t>(size);
        continue;
      }
      if (errno == EINTR) continue;
      if (errno == EAGAIN || errno == EWOULDBLOCK) {
        outgoing.erase(0, sent);
        sent = 0;
        return;
      }
      // A broken connection is reported by the read, after what still comes in was taken.
      write_failed = true;
      break;
    }
    outgoing.clear();
    sent = 0;
  }

  // Gets `outgoing` onto the socket; what does not fit at once follows as the socket takes it.
  void Write() {
    SendSome();
    if (unsent() && pumping) WakePump();
  }

  void Fail(const std::string& what) {
    if (error.empty()) error = what;
    pending.clear();
    pending_read.reset();
    queued.clear();
    outgoing.clear();
    sent = 0;
    commands_open = 0;
    changed.notify_all();
  }

  // What Receive() brought.
  void Take(Came came) {
    if (!error.empty()) return;
    switch (came) {
      case Came::kBytes:
        if (splitter) {
          splitter->Commit(received);
          TakeFrames();
        } else {
          TakeBytes(std::string_view(chunk.data(), received));
        }
        return;
      case Came::kEnd:
        return Fail("the simulator closed the connection to " + address);
      case Came::kError:
        return Fail("the connection to " + address + " broke: " + SystemText(receive_error));
      case Came::kNothing:
        return;
    }
  }

  void TakeFrames() {
    last_heard = Clock::now();
    namespace wire = ccmorse::wire;
    wire::Frame frame;
    for (;;) {
      switch (splitter->Next(&frame)) {
        case wire::FrameSplitter::Result::kNeedMore:
          return;
        case wire::FrameSplitter::Result::kBroken:
          return Fail("the simulator at " + address + " sent what is no frame of the fast link");
        case wire::FrameSplitter::Result::kFrame:
          TakeFrame(frame);
      }
    }
  }

  void TakeFrame(const ccmorse::wire::Frame& frame) {
    using ccmorse::wire::FrameType;
    switch (frame.type) {
      case FrameType::kLines:
        TakeBytes(frame.payload);
        return;
      case FrameType::kData:
      case FrameType::kReadFailed: {
        if (!pending_read) return;
        pending_read->read_failed = frame.type == FrameType::kReadFailed;
        pending_read->data.assign(frame.payload);
        pending_read->missing = 0;
        pending_read.reset();
        confirmed = read_covers;
        return;
      }
      case FrameType::kRefused: {
        ccmorse::wire::ByteReader reader(frame.payload);
        const auto* const service = writer.ServiceOf(reader.Short());
        if (service == nullptr || refusal) return;
        refusal = Refusal{service->first, service->second, std::string(reader.rest())};
        return;
      }
      default:
        return;  // what only a server gets
    }
  }

  void TakeBytes(std::string_view bytes) {
    std::size_t end = bytes.find('\n');
    if (end == std::string_view::npos) {
      last_heard = Clock::now();  // a long line is on its way
      incoming.append(bytes);
      if (incoming.starts_with(kPlayerGreeting)) {
        ::shutdown(handle, SHUT_RDWR);
        Fail(address + std::string(kPlayerServerThere));
      } else if (incoming.size() > kMaxLine) {
        ::shutdown(handle, SHUT_RDWR);
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

  // Appends lines to what is queued or goes out, in a frame of their own on a fast link.
  void AppendLines(std::string& out, const std::string& text) {
    if (splitter) {
      writer.Lines(out, text);
    } else {
      out += text;
    }
  }

  void MoveQueued() {
    writer.Finish(queued);
    if (outgoing.empty()) {
      outgoing.swap(queued);  // no copy, and both keep their memory
    } else {
      outgoing += queued;
    }
    queued.clear();
  }

  void SendPing() {
    const std::uint64_t id = next_id++;
    pending.emplace(id, Pending());
    AppendLines(outgoing, std::to_string(id) + ' ' + ping + '\n');
    Write();
  }

  // Queues a command as a line.
  void QueueLine(const Request& command) {
    const std::uint64_t id = next_id++;
    Pending entry;
    entry.component = command.component;
    entry.service = command.service;
    pending.emplace(id, std::move(entry));
    ++commands_open;
    lines.clear();
    AppendRequest(lines, id, command);
    AppendLines(queued, lines);
  }

  // Waits, pumping when nobody else does, until something happens or until the time has come.
  // `lock` is held on entry and exit. Returns on any event, so callers loop.
  void PumpOnce(std::unique_lock<std::mutex>& lock, Clock::time_point until,
                Clock::time_point expected = {}) {
    until = std::min(until, Clock::now() + kLongestSleep);
    if (pumping) {
      changed.wait_until(lock, until);
      return;
    }
    pumping = true;
    const bool to_send = unsent();
    lock.unlock();
    const Came came = Receive(until, expected, to_send);
    lock.lock();
    pumping = false;
    if (unsent()) SendSome();
    Take(came);
    changed.notify_all();  // another waiting thread takes over
  }

  const std::string address;
  int wake_handle = -1;                   // an eventfd: wakes the pumping thread from its sleep
  int handle = -1;                        // the socket
  std::shared_ptr<InProcess> simulation;  // that the other end belongs to; nullptr: TCP
  std::atomic<bool> woken{false};

  // The pumping thread's.
  std::array<char, kReadBlock> chunk{};
  std::unique_ptr<ccmorse::wire::FrameSplitter> splitter;  // a fast link; set while nobody pumps
  std::size_t received = 0;
  int receive_error = 0;
  Vigil vigil;

  mutable std::mutex mutex;
  std::condition_variable changed;
  bool pumping = false;
  std::string error;  // why the connection is down; empty while it stands
  std::uint64_t next_id = 1;
  std::unordered_map<std::uint64_t, Pending> pending;
  std::shared_ptr<Batch> pending_read;  // the one of SendRead()
  std::size_t commands_open = 0;        // commands without an answer, queued ones included
  // Frames that get no answer, and how many of them the server has certainly worked on.
  std::uint64_t unanswered = 0;
  std::uint64_t read_covers = 0;
  std::uint64_t confirmed = 0;
  FastLinkWriter writer;
  std::string queued;    // what waits for the next Send() or Flush()
  std::string outgoing;  // to be written next
  std::size_t sent = 0;  // of it
  std::string lines;     // scratch
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

bool Connection::StartFastLink(const Patience& patience, const char* function) {
  const auto batch =
      Send({{"ccmorse", "fast_link", "[" + std::to_string(ccmorse::wire::kFastLinkVersion) + "]"}});
  if (Wait(batch, patience, function) != Outcome::kDone || !batch->replies[0].success) return false;
  const std::lock_guard lock(impl_->mutex);
  impl_->splitter = std::make_unique<ccmorse::wire::FrameSplitter>(ccmorse::wire::kMostServerFrame);
  impl_->splitter->Append(impl_->incoming);
  impl_->incoming.clear();
  return true;
}

bool Connection::IsFast() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->splitter != nullptr;
}

void Connection::Queue(const Request& command) {
  bool full = false;
  {
    const std::lock_guard lock(impl_->mutex);
    if (!impl_->error.empty()) return;
    impl_->QueueLine(command);
    full = impl_->queued.size() > kMaxQueued;
  }
  if (full) Flush(5.0);
}

template <class Write>
bool Connection::QueueFrame(Write write) {
  bool full = false;
  {
    const std::lock_guard lock(impl_->mutex);
    if (!impl_->splitter) return false;
    if (!impl_->error.empty()) return true;  // dropped, as Queue() does
    if (!write(impl_->writer, impl_->queued)) return false;
    ++impl_->unanswered;
    full = impl_->queued.size() + impl_->writer.waiting() > kMaxQueued;
  }
  if (full) Flush(5.0);
  return true;
}

bool Connection::QueueNumbers(const std::string& component, const std::string& service,
                              const double* numbers, std::size_t count) {
  return QueueFrame([&](FastLinkWriter& writer, std::string& out) {
    return writer.Command(out, component, service, numbers, count);
  });
}

bool Connection::QueueImage(const std::string& component, const std::string& service, int width,
                            int height, const std::vector<Color_t>& image) {
  return QueueFrame([&](FastLinkWriter& writer, std::string& out) {
    return writer.Image(out, component, service, width, height, image);
  });
}

bool Connection::QueuePixels(const std::string& component, const std::string& service,
                             const PixelUpdate_t* pixels, std::size_t count) {
  return QueueFrame([&](FastLinkWriter& writer, std::string& out) {
    return writer.Pixels(out, component, service, pixels, count);
  });
}

std::shared_ptr<Batch> Connection::Send(const std::vector<Request>& requests) {
  auto batch = std::make_shared<Batch>();
  batch->replies.resize(requests.size());
  batch->missing = requests.size();
  const std::lock_guard lock(impl_->mutex);
  if (!impl_->error.empty()) return batch;  // Wait() reports it
  impl_->MoveQueued();
  impl_->lines.clear();
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const std::uint64_t id = impl_->next_id++;
    Impl::Pending entry;
    entry.batch = batch;
    entry.index = i;
    impl_->pending.emplace(id, std::move(entry));
    Impl::AppendRequest(impl_->lines, id, requests[i]);
  }
  impl_->AppendLines(impl_->outgoing, impl_->lines);
  impl_->Write();
  return batch;
}

void Connection::SendRead(const std::vector<FastLinkWriter::Subscription>& changes,
                          const std::shared_ptr<Batch>& batch) {
  batch->missing = 1;
  batch->read_failed = false;
  const std::lock_guard lock(impl_->mutex);
  if (!impl_->error.empty()) return;  // Wait() reports it
  impl_->MoveQueued();
  impl_->writer.Read(impl_->outgoing, changes);
  impl_->pending_read = batch;
  impl_->read_covers = impl_->unanswered;
  impl_->Write();
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
  bool looked = false;         // for what has come, since the time was up
  while (batch->missing > 0) {
    if (!impl_->error.empty()) throw MorseError(impl_->error, function);
    if (patience.abandon && *patience.abandon) return Outcome::kAbandoned;
    const auto now = Clock::now();
    const auto heard = std::max(start, impl_->last_heard);
    const bool to_answer_ping = pinged > heard;
    if (impl_->reading) deadline = now + Seconds(patience.timeout);
    Clock::time_point until = patience.timeout > 0.0   ? deadline
                              : patience.silence > 0.0 ? heard + Seconds(patience.silence)
                              : to_answer_ping         ? pinged + kSilenceAfterPing
                                                       : heard + kSilenceBeforePing;
    const bool late = now >= until;
    // It may be this thread that is late, on a busy machine, and the answer is there.
    if (late && !std::exchange(looked, true)) {
      impl_->PumpOnce(lock, now);
      continue;
    }
    looked = late;
    if (late) {
      if (patience.timeout > 0.0 || patience.silence > 0.0) return Outcome::kTimeout;
      if (to_answer_ping) {
        impl_->Fail("the simulator at " + impl_->address + " does not answer any more");
        continue;
      }
      impl_->SendPing();
      pinged = now;
      until = pinged + kSilenceAfterPing;
    }
    impl_->PumpOnce(lock, until, patience.expected);
  }
  return Outcome::kDone;
}

void Connection::Wake() {
  const std::lock_guard lock(impl_->mutex);
  impl_->changed.notify_all();
  if (impl_->pumping) impl_->WakePump();
}

std::optional<Refusal> Connection::TakeRefusal() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->refusal, std::nullopt);
}

void Connection::Close(double patience) noexcept {
  try {
    std::unique_lock lock(impl_->mutex);
    if (impl_->error.empty()) {
      // What gets no answer is known to be done when a request behind it got one.
      if (impl_->confirmed != impl_->unanswered) impl_->QueueLine({"time", "now", ""});
      impl_->MoveQueued();
      impl_->Write();
      // Closing with answers unread would reset the connection, and the simulator might lose the
      // commands that are still on their way to it.
      const auto deadline = Clock::now() + Seconds(patience);
      while (impl_->error.empty() && !impl_->write_failed &&
             (impl_->commands_open > 0 || impl_->unsent()) && Clock::now() < deadline) {
        impl_->PumpOnce(lock, deadline);
      }
    }
    impl_->Fail("the client is closed");
    // Other threads may still pump: they leave when they see the error.
    if (impl_->pumping) impl_->WakePump();
    const auto deadline = Clock::now() + Seconds(1.0);
    while (impl_->pumping && Clock::now() < deadline) impl_->changed.wait_until(lock, deadline);
    if (!impl_->pumping) {
      ::shutdown(impl_->handle, SHUT_RDWR);
      impl_->CloseHandle();
    }
  } catch (const std::exception&) {
    // Out of memory, or the mutex failed: the socket closes with the process at the latest.
  }
}

}  // namespace CCMorse::core
