#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "servers/record/replay.h"
#include "servers/web/web_server.h"

namespace ccmorse::servers {

/// How a record is to be shown.
struct ReplayServerOptions {
  double from = 0.0;         ///< s, simulated; cut to the record's length
  std::optional<double> to;  ///< s; it stops there once
  double speed = 1.0;  ///< simulated seconds per wall-clock second; infinity: as many as can be
  WebServerOptions web = {};
};

/// Shows a record in the live view's page, which has a time line for it: viewers play, stop, step
/// and jump through the services of `ccmorse`, and all of them see the same. Whatever would change
/// the world is refused. It stops at the end, and plays from the start again when it is told to go
/// on there. Everything happens on the thread that calls Run().
class ReplayServer {
 public:
  /// Starts to listen. Throws RecordError, and Error for a port that is taken.
  ReplayServer(const std::string& file, const ReplayServerOptions& options);

  boost::asio::io_context& io() { return io_; }
  const Replay& replay() const { return replay_; }
  const WebServer& web() const { return *web_; }

  /// Until Stop(). Throws RecordError when the file changes meanwhile.
  void Run();
  /// Ends Run() soon; from a handler of io().
  void Stop() { stop_ = true; }

 private:
  using WallClock = std::chrono::steady_clock;

  RunControl Control();
  std::uint64_t TickAt(double seconds) const;
  std::uint64_t tick() const { return replay_.simulation().tick(); }
  bool held() const { return paused_ && steps_ == 0; }
  void GoOnFromHere();  // for the pace
  void ServeWhatIsThere();
  void SeekOn();
  bool WaitForTurn();
  void Advance();
  void TellDifference();

  boost::asio::io_context io_;
  Replay replay_;
  std::unique_ptr<WebServer> web_;
  boost::asio::steady_timer bell_{io_};
  bool stop_ = false;
  bool paused_ = false;
  std::uint64_t steps_ = 0;  // that are to go by while paused
  double speed_;
  std::optional<std::uint64_t> target_;  // tick that is sought
  std::optional<std::uint64_t> stop_at_;
  bool ended_ = false;  // what came after the last tick was applied
  bool told_ = false;   // how it differs from the record
  bool rang_ = false;
  bool changed_ = false;  // something that WaitForTurn() waits by
  WallClock::time_point pace_base_;
  std::uint64_t pace_tick_ = 0;
};

}  // namespace ccmorse::servers
