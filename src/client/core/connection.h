#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/core/fast_link.h"

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
  // Of SendRead():
  bool read_failed = false;
  std::string data;  ///< payload of the data frame; of a failed read the reason, JSON
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

/// A socket to MORSE's service port, or one like it of a simulation within the program: numbered
/// requests out, answers in by their numbers. It starts with MORSE's lines and may go over to the
/// fast link's frames, in which the lines travel on. Any number of threads may use it at once. The
/// thread that waits sends and receives by itself; when several wait, one of them pumps the socket
/// for all, and the others sleep.
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
    /// When the answer is likely to come: it is waited for awake around then. In the past: nobody
    /// knows.
    std::chrono::steady_clock::time_point expected{};
    /// Wait() gives up when it becomes true (after Wake()).
    const std::atomic<bool>* abandon = nullptr;
  };
  enum class Outcome { kDone, kTimeout, kAbandoned };

  /// Connects within 2 s; throws MorseError. A host "sim:..." is a simulation within the program,
  /// which has its own time to start; it ends with the connection unless others use it.
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

  /// Asks the server for the fast link (docs/protocols/fast-link.md); true when it agreed. Nothing
  /// else may be under way. Throws MorseError from `function` when the connection is lost.
  bool StartFastLink(const Patience& patience, const char* function);
  /// Whether it is one. Does not change back.
  bool IsFast() const;

  /// Keeps a command for the next Send() or Flush(). Dropped when the socket is down.
  void Queue(const Request& command);
  /// The same on a fast link, for what it has frames for. False, with nothing queued, when there is
  /// no fast link or no frame for it.
  bool QueueNumbers(const std::string& component, const std::string& service, const double* numbers,
                    std::size_t count);
  bool QueueImage(const std::string& component, const std::string& service, int width, int height,
                  const std::vector<Color_t>& image);
  bool QueuePixels(const std::string& component, const std::string& service,
                   const PixelUpdate_t* pixels, std::size_t count);
  /// Sends what is queued, then the requests, in one write.
  std::shared_ptr<Batch> Send(const std::vector<Request>& requests);
  /// On a fast link: sends what is queued, changes of the subscriptions, and a read, in one write.
  /// `batch` is written anew: nobody else may use it any more. One read at a time.
  void SendRead(const std::vector<FastLinkWriter::Subscription>& changes,
                const std::shared_ptr<Batch>& batch);
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
  template <class Write>
  bool QueueFrame(Write write);
  const std::unique_ptr<Impl> impl_;
};

}  // namespace CCMorse::core
