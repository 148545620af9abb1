#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <string_view>

namespace CCMorse::core {

/// A connection, over TCP or to a simulation within the program, that waits no longer than it is
/// told to. One thread may receive while others send.
class TcpStream {
 public:
  enum class Wait { kReady, kTimeout, kWoken, kLost };

  /// Connects within `limit`, to the port of a host or, where the host is an address "sim:...", to
  /// a simulation within the program, which has its own time to start; throws MorseError from
  /// `function` when that fails.
  TcpStream(const std::string& host, int port, std::chrono::milliseconds limit,
            const char* function);
  ~TcpStream();
  TcpStream(const TcpStream&) = delete;
  TcpStream& operator=(const TcpStream&) = delete;

  /// Waits until there is something to receive, until `deadline`, or until Wake().
  Wait WaitFor(std::chrono::steady_clock::time_point deadline);
  /// Appends what has arrived; false when the connection is at its end.
  bool Receive(std::string& out);
  /// Sends all of it, within 5 s; false when the connection is lost.
  bool Send(std::string_view bytes);
  /// Ends a WaitFor() of another thread, or the next one.
  void Wake();
  /// Shuts the connection down: every method fails from now on. A simulation within the program
  /// ends, unless others use it.
  void Shutdown();

 private:
  struct Impl;
  const std::unique_ptr<Impl> impl_;
};

}  // namespace CCMorse::core
