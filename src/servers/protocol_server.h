#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace ccmorse::servers {

/// What the loop of a run (runner.h) asks of each protocol that it serves. All of it happens on the
/// loop's thread.
class ProtocolServer {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  virtual ~ProtocolServer() = default;

  /// After Simulation::Sense(): answers whoever waits for what the sensors now show.
  virtual void Sensed() = 0;
  /// Before Simulation::Act(): applies what came in between, where that is not done at once.
  virtual void ApplyInputs() {}

  /// Clients that have asked for data: those that there have ever been, and those that there are.
  virtual int ReadersEver() const = 0;
  virtual bool HasReaders() const = 0;
  /// Lock-step: has each of them asked for its next data, which are not there yet? True where
  /// there are none.
  virtual bool ReadersAreWaiting() const = 0;
  /// Does any of them wait for data that will be there, as far as is known, after the next
  /// Simulation::Sense()?
  virtual bool AwaitsNext() const = 0;
  /// Is any client connected?
  virtual bool HasClients() const = 0;
  /// Since when the one waits that has waited longest; nothing where none does.
  virtual std::optional<TimePoint> WaitingSince() const = 0;
  /// Lock-step: closes, with a log line, connections of readers that hang: that have sent nothing
  /// for `limit` while others have waited as long, since `waiting_since`. When to look again;
  /// nothing while nobody is waited for.
  virtual std::optional<TimePoint> LetHangingGo(TimePoint waiting_since,
                                                std::chrono::steady_clock::duration limit) = 0;
  /// The run is over: those who wait for data, now or from now on, are told `reason`.
  virtual void EndReads(const std::string& reason) = 0;
  /// Stops listening and lets all clients go, so that the ports are free.
  virtual void Close() = 0;
};

}  // namespace ccmorse::servers
