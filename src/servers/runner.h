#pragma once

#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/wakefulness.h"
#include "servers/idle_spinners.h"
#include "servers/morse/morse_server.h"
#include "servers/morse/multinode.h"
#include "servers/morse/service_directory.h"
#include "servers/morse/sync_port.h"
#include "servers/net/warm_path.h"
#include "servers/player/player_server.h"
#include "servers/run_participant.h"
#include "servers/run_watcher.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// How simulated time goes with wall-clock time (design: Time).
enum class Pace {
  kRealTime,  ///< `factor` simulated seconds a wall-clock second
  kLockstep,  ///< as fast as the clients ask for data (docs/protocols/ccmorse-services.md)
  kMax,       ///< as fast as possible, whether or not anyone listens
};

/// "realtime", "lockstep" or "max".
const char* PaceName(Pace pace);

struct RunOptions {
  Pace pace = Pace::kRealTime;
  double factor = 1.0;   ///< simulated seconds per wall second in real time, > 0
  double seconds = 0.0;  ///< simulated time to run, s; 0: until stopped
  int clients = 1;       ///< lock-step: time starts when this many clients read
  MorseServerOptions morse = {};
  /// Lock-step: how long a client may keep others waiting and send nothing, s of wall-clock time,
  /// before it is let go; 0: for ever.
  double client_timeout = 10.0;
  /// Serves Player's protocol as well, where given.
  std::optional<player::PlayerServerOptions> player = {};
  /// MORSE's port of time synchronisation, where given; 0: any free one. Not in lock-step, where
  /// clients give the time.
  std::optional<int> sync_port = {};
  /// The name of this node of the scenario's `multinode`; "": all robots are simulated here.
  std::string node = {};
};

/// What a run came to.
struct RunSummary {
  double simulated = 0.0;  ///< s
  /// s, from the first step on: waiting for a first client does not count, nor do pauses
  double wall = 0.0;
};

/// Advances a simulation at a pace and serves it meanwhile: the one loop of the simulator. Whatever
/// its servers' clients want changed goes through its one directory of services.
/// Everything happens on the thread that calls Run().
class Runner {
 public:
  /// Starts to listen. Throws Error (port taken).
  Runner(sim::Simulation& simulation, const RunOptions& options);

  /// Lets it follow the run from now on, in the order of these calls; to be called before Run(). It
  /// outlives the runner.
  void AddWatcher(RunWatcher& watcher);

  /// Runs until the simulated time is over, a client calls `simulation quit`, or Stop().
  RunSummary Run();

  /// Ends Run() soon. May be called from a handler of io() or from any thread.
  void Stop();

  /// As Stop(), but clients that wait are not waited for. From any thread.
  void StopAtOnce();

  /// Lock-step: ends Run() as soon as every client has left and all that they sent has been taken
  /// in, so that the state at the end does not depend on who was faster; after 2 s at the latest.
  /// At another pace as Stop(). From a handler of io().
  void StopAfterClients();

  /// Lets it take part in the run from now on; to be called before Run(). It outlives the run.
  void AddParticipant(RunParticipant& participant) { participants_.push_back(&participant); }

  boost::asio::io_context& io() { return io_; }
  /// The one door for what changes the simulation.
  ServiceDirectory& directory() { return directory_; }
  MorseServer& morse() { return morse_; }
  /// Of MORSE's time synchronisation; 0: there is none.
  int sync_port() const { return sync_ ? sync_->port() : 0; }
  /// nullptr where Player's protocol is not served.
  player::PlayerServer* player() { return player_.get(); }
  /// Stops listening and lets all clients go, so that the ports are free.
  void CloseServers();

  /// Called once, after the first tick (benchmarks measure the time to it).
  void set_on_first_tick(std::function<void()> callback) { on_first_tick_ = std::move(callback); }

 private:
  using WallClock = std::chrono::steady_clock;

  static sim::Simulation& WithoutExternal(sim::Simulation& simulation, const std::string& node);
  RunControl Control();
  bool HasReaders() const;
  bool AwaitsNext() const;
  bool HasClients() const;
  // Lock-step: has every client that reads asked for its next data, is there one at all, and have
  // as many as the options say ever come? So a run of several programs starts when the last has
  // joined.
  bool ClientsAreWaiting() const;
  // See ProtocolServer.
  std::optional<WallClock::time_point> LetHangingGo(WallClock::duration limit);
  Json Statistics() const;
  Json Clock() const;
  // At a finite speed: when the tick is to act that is so many ticks later than the next.
  WallClock::time_point Due(double later) const;
  void WaitForTurn();
  void WaitForPace();
  void WaitForSync();
  // Time goes in fixed steps, as MORSE calls it, whether or not it is held back to real time.
  bool fixed_steps() const;
  // Paused, and no step is left to go.
  bool held() const { return paused_ && steps_ == 0; }
  void WaitWhilePaused();
  void GoOnFromHere();  // for the pace
  void SetSpeed(double speed);
  void ServeWhatIsThere();
  void ServeLastOrders();
  void WaitForClients();
  void SleepUntil(WallClock::time_point time);  // and serve meanwhile
  // Until the data are due that somebody waits for and that were worked out a moment earlier.
  void WaitToPublish();
  void StayAwakeUntil(WallClock::time_point time);
  void CountTick();
  void LetClientsFinish();
  bool Over() const;

  boost::asio::io_context io_;
  // Where no port is open, nobody may be there to wait for; still the loop has to wait.
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_{
      io_.get_executor()};
  sim::Simulation& simulation_;
  RunOptions options_;
  ServiceDirectory directory_;
  MorseServer morse_;
  std::unique_ptr<player::PlayerServer> player_;
  std::optional<SyncPort> sync_;
  std::unique_ptr<Multinode> multinode_;
  std::vector<ProtocolServer*> servers_;  // in the order in which they are told of anything
  std::atomic<bool> stop_ = false;
  std::atomic<bool> at_once_ = false;
  boost::asio::steady_timer bell_{io_};
  bool bell_rang_ = false;
  WarmPath warm_path_;
  IdleSpinners idle_spinners_;
  std::optional<boost::asio::steady_timer> patience_;  // runs since StopAfterClients()
  WallClock::time_point start_;                        // of the first step
  double speed_;                // simulated seconds per wall second; infinity: no limit
  bool speed_changed_ = false;  // while it was waited for
  bool paused_ = false;
  std::uint64_t steps_ = 0;  // ticks that are still to go by while paused
  WallClock::time_point resumed_;
  WallClock::duration paused_for_{};
  WallClock::time_point pace_base_;  // when pace_tick_ was or will be due
  std::uint64_t pace_tick_ = 0;
  // When what the next Sense() shows is due, where somebody waits for it; and when it last was.
  std::optional<WallClock::time_point> publish_at_;
  WallClock::time_point published_{};
  WallClock::time_point last_tick_;
  double ticks_measured_ = 0.0;  // running mean and variance of the wall time of a tick
  double mean_ = 0.0;            // s
  double squares_ = 0.0;         // s^2
  Wakefulness wakefulness_;
  std::function<void()> on_first_tick_;
  std::vector<RunWatcher*> watchers_;
  std::vector<RunParticipant*> participants_;
};

}  // namespace ccmorse::servers
