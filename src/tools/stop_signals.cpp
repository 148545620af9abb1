#include "tools/stop_signals.h"

#include <fcntl.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.h"

namespace ccmorse::tools {
namespace {

int Checked(int descriptor) {
  if (descriptor < 0) throw Error(std::string("cannot take signals: ") + std::strerror(errno));
  return descriptor;
}

// The next that has come, 0 when there is none.
int Next(int descriptor) {
  signalfd_siginfo signal{};
  const ssize_t size = ::read(descriptor, &signal, sizeof signal);
  return size == static_cast<ssize_t>(sizeof signal) ? static_cast<int>(signal.ssi_signo) : 0;
}

sigset_t Ours() {
  sigset_t ours;
  sigemptyset(&ours);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ours, signal);
  return ours;
}

}  // namespace

StopSignals::StopSignals() {
  const sigset_t ours = Ours();
  descriptor_ = Checked(::signalfd(-1, &ours, SFD_NONBLOCK | SFD_CLOEXEC));
  ::pthread_sigmask(SIG_BLOCK, &ours, &before_);
}

StopSignals::~StopSignals() {
  while (Next(descriptor_) != 0) {
  }
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  ::close(descriptor_);
}

StopSignalWatch::StopSignalWatch(const StopSignals& signals, boost::asio::io_context& io,
                                 std::function<void(int)> taken)
    : descriptor_(io, Checked(::fcntl(signals.descriptor(), F_DUPFD_CLOEXEC, 0))),
      taken_(std::move(taken)) {
  Wait();
}

void StopSignalWatch::Wait() {
  descriptor_.async_wait(boost::asio::posix::stream_descriptor::wait_read,
                         [this](boost::system::error_code error) {
                           if (error) return;
                           while (const int signal = Next(descriptor_.native_handle())) {
                             taken_(signal);
                           }
                           Wait();
                         });
}

}  // namespace ccmorse::tools
