#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <csignal>
#include <functional>

namespace ccmorse::tools {

/// SIGINT, SIGTERM and SIGHUP held back, to be read as data by a StopSignalWatch: no handler
/// interrupts anything, and a signal that comes early waits until somebody looks.
///
/// Make it before any thread is started: threads inherit that these signals are held back, and one
/// in which they are not would end the program. Programs that are started while it lives inherit
/// it, too. One at a time; for the thread that makes it.
class StopSignals {
 public:
  /// Throws Error when the system has no descriptor left.
  StopSignals();
  /// What came and was not taken is dropped; from here on signals do what they did before.
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// A signalfd(2), non-blocking.
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
  sigset_t before_{};
};

/// Hands signals to a function as long as it lives.
class StopSignalWatch {
 public:
  /// `taken` is called with each signal's number, by whoever runs `io`, which outlives this. Throws
  /// Error when the system has no descriptor left.
  StopSignalWatch(const StopSignals& signals, boost::asio::io_context& io,
                  std::function<void(int)> taken);

 private:
  void Wait();

  boost::asio::posix::stream_descriptor descriptor_;
  std::function<void(int)> taken_;
};

}  // namespace ccmorse::tools
