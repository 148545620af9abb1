#include "servers/record/replay_server.h"

#include <algorithm>
#include <cmath>

#include "base/log.h"
#include "servers/real_time.h"

namespace ccmorse::servers {
namespace {

constexpr auto kSlice = std::chrono::milliseconds(20);  // of a jump, between looks at the sockets

}  // namespace

ReplayServer::ReplayServer(const std::string& file, const ReplayServerOptions& options)
    : replay_(file, Control()), speed_(options.speed) {
  WebServerOptions web = options.web;
  web.record = ShownRecord{file, replay_.duration()};
  web_ = std::make_unique<WebServer>(io_, replay_.simulation(), replay_.directory(), web);
  if (TickAt(options.from) > 0) target_ = TickAt(options.from);
  if (options.to) stop_at_ = TickAt(*options.to);
}

RunControl ReplayServer::Control() {
  RunControl control;
  control.set_paused = [this](bool paused) {
    const std::uint64_t last = replay_.info().ticks;
    if (!paused && target_.value_or(tick()) >= last) target_ = 0;
    paused_ = paused;
    steps_ = 0;
    changed_ = true;
    GoOnFromHere();
  };
  control.step = [this](int ticks) {
    if (!paused_) steps_ = 0;
    paused_ = changed_ = true;
    // Not beyond the end, where nobody would ever be told that it is over.
    const std::uint64_t left = replay_.info().ticks - tick() - steps_;
    steps_ += std::min<std::uint64_t>(static_cast<std::uint64_t>(ticks), left);
    return tick() + steps_;
  };
  control.set_speed = [this](double speed) {
    speed_ = speed;
    changed_ = true;
    GoOnFromHere();
  };
  // Done by Run(): what is called here lives in what a jump backwards replaces.
  control.seek = [this](double seconds) {
    target_ = TickAt(seconds);
    steps_ = 0;
    changed_ = true;
  };
  control.time_state = [this] { return TimeState{paused_, speed_, target_.has_value()}; };
  return control;
}

std::uint64_t ReplayServer::TickAt(double seconds) const {
  const double ticks = std::round(seconds * replay_.info().scenario.time.frequency);
  const auto last = static_cast<double>(replay_.info().ticks);
  return static_cast<std::uint64_t>(std::clamp(ticks, 0.0, last));
}

void ReplayServer::GoOnFromHere() {
  pace_base_ = WallClock::now();
  pace_tick_ = tick();
}

void ReplayServer::ServeWhatIsThere() {
  io_.restart();
  for (int i = 0; i < kHandlersPerTick && !stop_ && io_.poll_one() > 0; ++i) {
  }
}

void ReplayServer::Run() {
  GoOnFromHere();
  while (!stop_) {
    ServeWhatIsThere();
    if (stop_) break;
    if (target_) {
      SeekOn();
    } else if (held()) {
      changed_ = false;
      while (!stop_ && !changed_) io_.run_one();
    } else if (tick() >= replay_.info().ticks) {
      paused_ = true;
      steps_ = 0;
    } else if (WaitForTurn()) {
      Advance();
    }
  }
  web_->Close();
}

// Towards the target, for a moment: a viewer that drags the time line asks for another meanwhile.
void ReplayServer::SeekOn() {
  const std::uint64_t target = *target_;
  if (target < tick()) {
    replay_.Seek(0.0);
    ended_ = false;
    web_->Show(replay_.simulation(), replay_.directory());
  }
  const auto until = WallClock::now() + kSlice;
  while (tick() < target && WallClock::now() < until) replay_.Step();
  TellDifference();
  if (tick() != target) return;
  target_.reset();
  if (stop_at_ && target >= *stop_at_) stop_at_.reset();
  GoOnFromHere();
  web_->Show(replay_.simulation(), replay_.directory());
}

// False where something came up that has to be looked at first.
bool ReplayServer::WaitForTurn() {
  if (!std::isfinite(speed_)) return true;
  const double ticks = static_cast<double>(tick() - pace_tick_);
  const double seconds = ticks / replay_.info().scenario.time.frequency / speed_;
  const auto due = pace_base_ + std::chrono::duration_cast<WallClock::duration>(
                                    std::chrono::duration<double>(seconds));
  const auto now = WallClock::now();
  if (now - due > kGiveUpCatchingUp) GoOnFromHere();
  if (now >= due) return true;
  changed_ = rang_ = false;
  bell_.expires_at(due);
  bell_.async_wait([this](boost::system::error_code error) {
    if (!error) rang_ = true;
  });
  while (!stop_ && !changed_ && !rang_) io_.run_one();
  bell_.cancel();
  return !stop_ && !changed_;
}

void ReplayServer::Advance() {
  replay_.Step();
  if (steps_ > 0) --steps_;
  if (tick() == replay_.info().ticks && !ended_) {
    ended_ = true;
    replay_.Step();  // what came after the last tick belongs to the state at the end
  }
  TellDifference();
  if (stop_at_ && tick() >= *stop_at_) {
    stop_at_.reset();
    paused_ = true;
    steps_ = 0;
  }
  web_->Acted();
}

void ReplayServer::TellDifference() {
  if (told_ || !replay_.difference()) return;
  told_ = true;
  const Difference& difference = *replay_.difference();
  LogWarning("what is shown is not what was recorded: from tick {} on, {} differs",
             difference.last_tick,
             difference.component.empty() ? "the state as a whole" : difference.component);
}

}  // namespace ccmorse::servers
