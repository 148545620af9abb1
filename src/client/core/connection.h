#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CCMorse::core {

/// What a service answered.
struct Reply {
  bool done = false;
  bool success = false;
  bool preempted = false;  ///< another request took its place
  std::string text;        ///< JSON; empty for the null value
};

/// The answers to requests that were sent together. Written by whichever thread pumps the
/// connection, read by the waiting one once Wait() returned.
struct Batch {
  std::vector<Reply> replies;
  std::size_t missing = 0;
};

struct Request {
  std::string component;
  std::string service;
  std::string args;  ///< JSON list; empty for none
};

/// A one-way command that the simulator refused.
struct Refusal {
  std::string component;
  std::string service;
  std::string reason;
};

/// A socket to MORSE's service port: numbered requests out, answers in by their numbers. Any number
/// of threads may use it at once. One of the waiting threads pumps the socket for all; the others
/// sleep, and hand it what they want written.
class Connection {
 public:
  /// The longest line that is accepted, bytes.
  static constexpr std::size_t kMaxLine = std::size_t{64} << 20;
  /// Commands that wait for the next Read() beyond this are sent at once, bytes.
  static constexpr std::size_t kMaxQueued = std::size_t{1} << 20;

  /// How long Wait() waits.
  struct Patience {
    /// Above 0: fail this many seconds after the start; the clock stands while reading(). 0: go on
    /// as long as the simulator shows life, and ping it after 1 s of silence.
    double timeout = 0.0;
    /// 0, or fail after this many seconds without anything from the simulator (no pings).
    double silence = 0.0;
    /// Wait() gives up when it becomes true (after Wake()).
    const std::atomic<bool>* abandon = nullptr;
  };
  enum class Outcome { kDone, kTimeout, kAbandoned };

  /// Connects within 2 s; throws MorseError.
  Connection(const std::string& host, int port);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Whether the socket stands.
  bool Alive() const;
  /// The request that shows whether the simulator lives: "ccmorse ping" or "time now".
  void SetPing(const std::string& request);
  /// Tells Wait() with a timeout that answers may rightly be held back by an outstanding read.
  void SetReading(bool reading);

  /// Keeps a command for the next Send() or Flush(). Dropped when the socket is down.
  void Queue(const Request& command);
  /// Sends what is queued, then the requests, in one write.
  std::shared_ptr<Batch> Send(const std::vector<Request>& requests);
  /// Sends what is queued. Waits only while more than kMaxQueued bytes cannot be written, at most
  /// `patience` s, then the connection counts as lost.
  void Flush(double patience);
  /// Waits for all answers. Throws MorseError from `function` when the connection is lost.
  Outcome Wait(const std::shared_ptr<Batch>& batch, const Patience& patience, const char* function);
  /// Wakes the waiting threads to look at their `abandon` flags.
  void Wake();
  /// The first refusal of a command since the last call.
  std::optional<Refusal> TakeRefusal();

  /// Sends what is queued, waits up to `patience` s for the answers to all commands, and closes.
  void Close(double patience) noexcept;

 private:
  struct Impl;
  const std::unique_ptr<Impl> impl_;
};

}  // namespace CCMorse::core
