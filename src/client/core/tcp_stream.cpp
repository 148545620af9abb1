#include "client/core/tcp_stream.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <mutex>
#include <utility>

#include "client/core/address.h"
#include "client/core/in_process.h"
#include "client/core/rhythm.h"
#include "client/core/tcp_connect.h"
#include "client/core/vigil.h"
#include "libCCMorse/MorseError.h"

namespace CCMorse::core {

using Clock = std::chrono::steady_clock;

namespace {

constexpr auto kSendLimit = std::chrono::seconds(5);
constexpr Clock::duration kLongest = std::chrono::hours(1);  // of one wait
constexpr std::size_t kBlock = std::size_t{64} << 10;

// Data that come in a rhythm are further apart than this; nearer ones belong together.
constexpr auto kBurst = std::chrono::microseconds(500);

int MillisecondsUntil(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::max<std::int64_t>(left, 0));
}

}  // namespace

struct TcpStream::Impl {
  Impl() = default;
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  // Looks, until `until`, who has something.
  Wait Look(Clock::time_point until);
  void NoteArrival();

  int handle = -1;
  int wake = -1;
  Vigil vigil;
  // When data came: the first of the last two bursts.
  Clock::time_point arrived{};
  Rhythm rhythm;                          // of arrivals
  std::mutex mutex;                       // simulation
  std::shared_ptr<InProcess> simulation;  // that the other end belongs to; nullptr: TCP
};

TcpStream::TcpStream(const std::string& host, int port, std::chrono::milliseconds limit,
                     const char* function)
    : impl_(std::make_unique<Impl>()) {
  if (IsInProcess(host)) {
    InProcessSocket socket = ConnectInProcess(host, true, function);
    impl_->handle = socket.handle;
    impl_->simulation = std::move(socket.simulation);
  } else {
    std::string reason;
    impl_->handle = ConnectTcp(host, port, limit, &reason);
    if (impl_->handle < 0) {
      throw MorseError("cannot connect to " + AddressText(host, port) + ": " + reason, function);
    }
  }
  impl_->wake = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (impl_->wake < 0) throw MorseError("no file descriptor is left", function);
}

TcpStream::~TcpStream() = default;

TcpStream::Impl::~Impl() {
  if (wake >= 0) ::close(wake);
  if (handle >= 0) ::close(handle);
}

TcpStream::Wait TcpStream::Impl::Look(Clock::time_point until) {
  std::array<pollfd, 2> fds = {pollfd{handle, POLLIN, 0}, pollfd{wake, POLLIN, 0}};
  const auto left = std::clamp(until - Clock::now(), Clock::duration::zero(), kLongest);
  const auto seconds = std::chrono::floor<std::chrono::seconds>(left);
  const timespec limit{seconds.count(), std::chrono::nanoseconds(left - seconds).count()};
  const int ready = ::ppoll(fds.data(), fds.size(), &limit, nullptr);
  if (ready < 0) return errno == EINTR ? Wait::kTimeout : Wait::kLost;
  if (fds[0].revents != 0) return Wait::kReady;
  if (fds[1].revents == 0) return Wait::kTimeout;
  std::uint64_t count = 0;
  while (::read(wake, &count, sizeof count) > 0) {
  }
  return Wait::kWoken;
}

void TcpStream::Impl::NoteArrival() {
  const auto now = Clock::now();
  if (now - arrived > kBurst) rhythm.Came(arrived = now);
}

TcpStream::Wait TcpStream::WaitFor(Clock::time_point deadline) {
  Impl& impl = *impl_;
  Wait found = impl.Look({});
  while (found == Wait::kTimeout && Clock::now() < deadline) {
    impl.vigil.Begin(deadline, impl.rhythm.expected());
    while (found == Wait::kTimeout && impl.vigil.StaysAwake()) found = impl.Look({});
    if (found == Wait::kTimeout) found = impl.Look(impl.vigil.sleep_until());
  }
  if (found == Wait::kReady) impl.NoteArrival();
  return found;
}

bool TcpStream::Receive(std::string& out) {
  std::array<char, kBlock>
      block;  // NOLINT(cppcoreguidelines-pro-type-member-init): written by recv
  const ssize_t size = ::recv(impl_->handle, block.data(), block.size(), MSG_DONTWAIT);
  if (size > 0) out.append(block.data(), static_cast<std::size_t>(size));
  return size > 0 || (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR));
}

bool TcpStream::Send(std::string_view bytes) {
  const auto deadline = Clock::now() + kSendLimit;
  while (!bytes.empty()) {
    const ssize_t size =
        ::send(impl_->handle, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (size > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(size));
      continue;
    }
    if (errno == EINTR) continue;
    if (errno != EAGAIN && errno != EWOULDBLOCK) return false;
    pollfd writable{impl_->handle, POLLOUT, 0};
    if (::poll(&writable, 1, MillisecondsUntil(deadline)) == 0) return false;
  }
  return true;
}

void TcpStream::Wake() {
  const std::uint64_t one = 1;
  // A full counter wakes just as well.
  [[maybe_unused]] const ssize_t written = ::write(impl_->wake, &one, sizeof one);
}

void TcpStream::Shutdown() {
  ::shutdown(impl_->handle, SHUT_RDWR);
  const std::lock_guard lock(impl_->mutex);
  impl_->simulation.reset();
}

}  // namespace CCMorse::core
