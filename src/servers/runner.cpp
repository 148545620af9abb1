#include "servers/runner.h"

#include <fmt/core.h>

#include <algorithm>
#include <boost/asio/post.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <thread>

#include "base/error.h"
#include "base/log.h"
#include "servers/real_time.h"

namespace ccmorse::servers {
namespace {

constexpr auto kFarewell = std::chrono::seconds(2);          // for clients, once the run is over
constexpr auto kStayAwake = std::chrono::microseconds(100);  // in lock-step, for the next request
// In real time, before data are due that somebody waits for. Processors that have slept are slow
// for some milliseconds: they are kept awake until whoever waits has woken by itself, but for no
// more than this share of the time. Waking takes tens of microseconds more, and so do the sensors:
// the tick is worked out early, and what they show is sent when it is due.
constexpr auto kRouseEarly = std::chrono::microseconds(5000);
constexpr int kRouseShare = 10;  // 1 in so many
constexpr auto kRoused = std::chrono::microseconds(100);
constexpr auto kWakeEarly = std::chrono::microseconds(400);
constexpr auto kLastOrders = std::chrono::microseconds(500);

}  // namespace

const char* PaceName(Pace pace) {
  switch (pace) {
    case Pace::kRealTime:
      return "realtime";
    case Pace::kLockstep:
      return "lockstep";
    case Pace::kMax:
      break;
  }
  return "max";
}

Runner::Runner(sim::Simulation& simulation, const RunOptions& options)
    : simulation_(WithoutExternal(simulation, options.node)),
      options_(options),
      directory_(simulation, Control()),
      morse_(io_, simulation, directory_,
             {PaceName(options.pace), simulation.scenario().time.read_frequency,
              [this] { return Clock(); }},
             options.morse),
      servers_{&morse_},
      speed_(options.pace == Pace::kRealTime ? options.factor
                                             : std::numeric_limits<double>::infinity()) {
  if (options.player) {
    player_ = player::PlayerServer::Open(io_, simulation, directory_, *options.player);
    if (player_ != nullptr) servers_.push_back(player_.get());
  }
  if (options.sync_port && options.pace != Pace::kLockstep) {
    sync_.emplace(io_, options.morse.bind, *options.sync_port);
  }
  if (!options.node.empty()) {
    const scene::MultinodeDef& def = *simulation.scenario().multinode;
    multinode_ =
        std::make_unique<Multinode>(io_, simulation, def, options.node, [this] { return !stop_; });
    directory_.set_external(multinode_->external());
  }
}

// The devices of robots that another node has are neither simulated nor served here; before the
// directory and the servers look at them.
sim::Simulation& Runner::WithoutExternal(sim::Simulation& simulation, const std::string& node) {
  if (node.empty()) return simulation;
  const auto& multinode = simulation.scenario().multinode;
  if (!multinode || multinode->nodes.count(node) == 0) {
    throw Error("the scene has no node '" + node + "'");
  }
  for (const std::string& name : Multinode::External(*multinode, node)) {
    for (const auto& component : simulation.FindRobot(name)->components()) {
      component->set_active(false);
      component->set_interfaces(false, false);
    }
  }
  return simulation;
}

void Runner::AddWatcher(RunWatcher& watcher) {
  watchers_.push_back(&watcher);
  if (!watcher.WantsInputs()) return;
  directory_.set_input_tap([this](const Input& input) {
    for (RunWatcher* each : watchers_) {
      if (each->WantsInputs()) each->Incoming(input);
    }
  });
}

RunControl Runner::Control() {
  RunControl control;
  control.stream_port = [this](const sim::Component& component) {
    return morse_.StreamPort(component);
  };
  control.quit = [this] { Stop(); };
  control.time_mode = [this] { return fixed_steps() ? "Fixed Simulation Step" : "Best Effort"; };
  control.time_statistics = [this] { return Statistics(); };
  control.set_time_scale = [this](double factor) {
    if (options_.pace != Pace::kRealTime) return false;
    SetSpeed(factor);
    return true;
  };
  control.set_paused = [this](bool paused) {
    paused_ = paused;
    steps_ = 0;
  };
  control.step = [this](int ticks) {
    if (!paused_) steps_ = 0;
    paused_ = true;
    steps_ += static_cast<std::uint64_t>(ticks);
    return simulation_.tick() + steps_;
  };
  control.set_speed = [this](double speed) { SetSpeed(speed); };
  control.time_state = [this] { return TimeState{paused_, speed_}; };
  return control;
}

Json Runner::Clock() const {
  if (options_.pace != Pace::kRealTime || !std::isfinite(speed_)) return {};
  // What the sensors show now was due when the tick before was: they look right after it.
  const double due = std::chrono::duration<double>(Due(-1.0).time_since_epoch()).count();
  return Json(Json::Object{{"time", simulation_.time()}, {"due", due}, {"factor", speed_}});
}

Runner::WallClock::time_point Runner::Due(double later) const {
  const double ticks =
      static_cast<double>(simulation_.tick()) - static_cast<double>(pace_tick_) + later;
  const double seconds = ticks / simulation_.scenario().time.frequency / speed_;
  return pace_base_ +
         std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>(seconds));
}

Json Runner::Statistics() const {
  const double variance = ticks_measured_ > 1.0 ? squares_ / (ticks_measured_ - 1.0) : 0.0;
  Json statistics(Json::Object{{"mean_time", mean_}, {"variance_time", variance}});
  if (!fixed_steps()) {
    // The rate's variance to first order from the period's.
    const double rate = mean_ > 0.0 ? 1.0 / mean_ : 0.0;
    statistics.Set("mean_frame_by_sec", rate);
    statistics.Set("variance_frame_by_sec", variance * rate * rate * rate * rate);
  } else {
    const double wall =
        std::chrono::duration<double>(WallClock::now() - start_ - paused_for_).count();
    statistics.Set("diff_real_time", simulation_.tick() == 0 ? 0.0 : wall - simulation_.time());
  }
  return statistics;
}

// MORSE's strategy, which a scene chooses and its pace does not change.
bool Runner::fixed_steps() const {
  return options_.pace != Pace::kRealTime || simulation_.scenario().time.strategy != "realtime";
}

bool Runner::HasReaders() const {
  return std::any_of(servers_.begin(), servers_.end(),
                     [](const auto* s) { return s->HasReaders(); });
}

bool Runner::AwaitsNext() const {
  return std::any_of(servers_.begin(), servers_.end(),
                     [](const auto* s) { return s->AwaitsNext(); });
}

bool Runner::HasClients() const {
  return std::any_of(servers_.begin(), servers_.end(),
                     [](const auto* s) { return s->HasClients(); });
}

bool Runner::ClientsAreWaiting() const {
  int ever = 0;
  for (const ProtocolServer* server : servers_) {
    if (!server->ReadersAreWaiting()) return false;
    ever += server->ReadersEver();
  }
  return ever >= options_.clients && HasReaders();
}

std::optional<Runner::WallClock::time_point> Runner::LetHangingGo(WallClock::duration limit) {
  // Nobody waits for a client that is alone.
  std::optional<WallClock::time_point> since;
  for (const ProtocolServer* server : servers_) {
    const auto one = server->WaitingSince();
    if (one) since = since ? std::min(*since, *one) : one;
  }
  if (!since) return std::nullopt;
  since = std::max(*since, resumed_);  // in a pause nobody waits for a client
  std::optional<WallClock::time_point> next;
  for (ProtocolServer* server : servers_) {
    const auto one = server->LetHangingGo(*since, limit);
    if (one) next = next ? std::min(*next, *one) : one;
  }
  return next;
}

void Runner::CloseServers() {
  for (ProtocolServer* server : servers_) server->Close();
  if (sync_) sync_->Close();
}

void Runner::Stop() {
  stop_ = true;
  boost::asio::post(io_, [] {});  // wakes a Run() that waits
}

void Runner::StopAtOnce() {
  at_once_ = true;
  Stop();
}

void Runner::StopAfterClients() {
  if (options_.pace != Pace::kLockstep) return Stop();
  if (patience_) return;
  patience_.emplace(io_, kFarewell);
  patience_->async_wait([this](boost::system::error_code error) {
    if (!error) Stop();
  });
}

bool Runner::Over() const {
  // Half a tick of slack: 0.1 s are 6 ticks at 60 Hz, whatever 0.1 * 60 rounds to.
  const double half_tick = 0.5 / simulation_.scenario().time.frequency;
  return stop_ || (options_.seconds > 0.0 && simulation_.time() > options_.seconds - half_tick);
}

RunSummary Runner::Run() {
  start_ = pace_base_ = last_tick_ = WallClock::now();
  bool first = true;
  bool sensed = false;
  while (!Over()) {
    simulation_.Sense();
    sensed = true;
    for (RunParticipant* participant : participants_) participant->Sensed();
    WaitToPublish();
    for (RunWatcher* watcher : watchers_) watcher->Sensed();
    for (ProtocolServer* server : servers_) server->Sensed();
    WaitForTurn();
    if (stop_) break;
    if (first) {
      start_ = last_tick_ = WallClock::now();
      paused_for_ = {};
    }
    for (ProtocolServer* server : servers_) server->ApplyInputs();
    for (RunParticipant* participant : participants_) participant->BeforeAct();
    simulation_.Act();
    sensed = false;
    for (RunWatcher* watcher : watchers_) watcher->Acted();
    directory_.TimeAdvanced();
    CountTick();
    if (first && on_first_tick_) on_first_tick_();
    first = false;
  }
  if (multinode_ && !stop_) multinode_->Finish();
  RunSummary summary;
  summary.simulated = simulation_.time();
  if (!first) {
    summary.wall = std::chrono::duration<double>(WallClock::now() - start_ - paused_for_).count();
  }
  LetClientsFinish();
  for (RunWatcher* watcher : watchers_) watcher->Ended(sensed);
  return summary;
}

void Runner::WaitForTurn() {
  ServeWhatIsThere();
  do {
    WaitWhilePaused();
    speed_changed_ = false;
    publish_at_.reset();
    if (sync_ && sync_->connected()) {
      WaitForSync();
    } else {
      WaitForPace();
    }
    // What came before a request that waits for the next tick acts in it, too, over whichever
    // connection it came (specs: morse.md E.6).
    if (options_.pace == Pace::kRealTime) ServeLastOrders();
  } while (!stop_ && (held() || speed_changed_ ||
                      (options_.pace == Pace::kLockstep && !ClientsAreWaiting())));
  if (paused_ && steps_ > 0) --steps_;
}

void Runner::WaitWhilePaused() {
  if (!held()) return;
  const auto since = WallClock::now();
  while (!stop_ && held()) io_.run_one();
  resumed_ = WallClock::now();
  paused_for_ += resumed_ - since;
  last_tick_ += resumed_ - since;
  GoOnFromHere();
}

void Runner::GoOnFromHere() {
  pace_base_ = WallClock::now();
  pace_tick_ = simulation_.tick();
}

void Runner::SetSpeed(double speed) {
  speed_ = speed;
  speed_changed_ = true;
  GoOnFromHere();
}

void Runner::WaitForPace() {
  if (options_.pace == Pace::kLockstep) WaitForClients();
  if (!std::isfinite(speed_)) return;
  const auto due = Due(0.0);
  const auto now = WallClock::now();
  if (options_.pace != Pace::kRealTime) {
    // The speed is a limit here: what clients made the run lose is not caught up with.
    if (now > due) return GoOnFromHere();
    return SleepUntil(due);
  }
  if (now - due > kGiveUpCatchingUp) {
    LogWarning("the simulation is {:.1f} s behind real time and goes on from here",
               std::chrono::duration<double>(now - due).count());
    GoOnFromHere();
  }
  if (HasReaders()) {
    SleepUntil(due - std::min<WallClock::duration>(kRouseEarly, (due - published_) / kRouseShare));
    if (AwaitsNext()) idle_spinners_.SpinUntil(due - kRoused);
    SleepUntil(due - kWakeEarly);
    if (AwaitsNext()) {
      publish_at_ = due;
      return;
    }
  }
  SleepUntil(due);
  StayAwakeUntil(due);
}

void Runner::WaitToPublish() {
  if (!publish_at_) return;
  if (WallClock::now() < *publish_at_) warm_path_.Warm();
  while (WallClock::now() < *publish_at_) {
  }
  published_ = *publish_at_;
}

void Runner::WaitForSync() {
  while (!stop_ && !held() && !sync_->TakeTick()) io_.run_one();
  GoOnFromHere();
}

void Runner::StayAwakeUntil(WallClock::time_point time) {
  while (!stop_ && !held() && !speed_changed_ && WallClock::now() < time) io_.poll_one();
}

void Runner::ServeWhatIsThere() {
  io_.restart();
  for (int i = 0; i < kHandlersPerTick && !stop_ && io_.poll_one() > 0; ++i) {
  }
}

// As that, but the tick is due: a flood of requests does not hold it up.
void Runner::ServeLastOrders() {
  const auto until = WallClock::now() + kLastOrders;
  io_.restart();
  while (!stop_ && io_.poll_one() > 0 && WallClock::now() < until) {
  }
}

// By a timer of its own: run_one_until() is late by up to a millisecond.
void Runner::SleepUntil(WallClock::time_point time) {
  if (WallClock::now() >= time) return;
  bell_rang_ = false;
  bell_.expires_at(time);
  bell_.async_wait([this](boost::system::error_code error) {
    if (!error) bell_rang_ = true;
  });
  while (!stop_ && !held() && !speed_changed_ && !bell_rang_) io_.run_one();
  bell_.cancel();
}

void Runner::WaitForClients() {
  // A client that computes little asks again within microseconds, and waking from sleep takes tens
  // of them: so the thread stays awake for a moment, and leaves the processor to whoever wants it.
  const auto awake_until = WallClock::now() + kStayAwake;
  while (!stop_ && !held() && !ClientsAreWaiting()) {
    if (io_.poll_one() == 0) wakefulness_.GiveWay();
    const auto now = WallClock::now();
    if (now > awake_until || !wakefulness_.Pays(now)) break;
  }
  const auto limit = std::chrono::duration_cast<WallClock::duration>(
      std::chrono::duration<double>(options_.client_timeout));
  while (!stop_ && !held() && !ClientsAreWaiting()) {
    // After StopAfterClients() what is there comes first: a client that was not yet accepted may
    // have left commands behind.
    if (patience_ && io_.poll_one() > 0) continue;
    if (patience_ && !HasClients()) {
      stop_ = true;
      break;
    }
    const auto look_again =
        limit > WallClock::duration::zero() ? LetHangingGo(limit) : std::nullopt;
    if (look_again) {
      io_.run_one_until(*look_again);
    } else if (!ClientsAreWaiting()) {
      io_.run_one();
    }
  }
}

void Runner::CountTick() {
  const auto now = WallClock::now();
  const double seconds = std::chrono::duration<double>(now - last_tick_).count();
  last_tick_ = now;
  ticks_measured_ += 1.0;
  const double off = seconds - mean_;
  mean_ += off / ticks_measured_;
  squares_ += off * (seconds - mean_);
}

void Runner::LetClientsFinish() {
  for (ProtocolServer* server : servers_) {
    server->EndReads(fmt::format("The simulation has ended at {:.3f} s", simulation_.time()));
  }
  const auto until = WallClock::now() + kFarewell;
  io_.restart();
  while (!at_once_ && HasReaders() && io_.run_one_until(until) > 0) {
  }
  // Replies under way, such as that to `simulation quit`, still go out.
  for (int i = 0; i < kHandlersPerTick && io_.poll_one() > 0; ++i) {
  }
}

}  // namespace ccmorse::servers
