#include "tools/batch_progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace ccmorse::tools {
namespace {

constexpr auto kRedraw = std::chrono::milliseconds(200);
constexpr auto kNextLine = std::chrono::seconds(10);
constexpr int kShortestBar = 10;
constexpr int kLongestBar = 40;

int TerminalWidth() {
  winsize size{};
  return ::ioctl(2, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

std::string DurationText(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::llround(std::min(seconds, 1e9)));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

BatchProgress::BatchProgress(int total, int before, bool quiet)
    : total_(total),
      before_(before),
      done_(before),
      quiet_(quiet),
      terminal_(::isatty(2) == 1),
      started_(Clock::now()),
      next_(started_ + (terminal_ ? Clock::duration::zero() : kNextLine)) {}

std::string BatchProgress::Line(Clock::time_point now, int width) const {
  std::string text = fmt::format("{} of {}", done_, total_);
  if (failed_ > 0) text += fmt::format(", {} failed", failed_);
  if (done_ > before_ && done_ < total_) {
    // Jobs of an earlier start say nothing about how fast this one is.
    const double elapsed = std::chrono::duration<double>(now - started_).count();
    text += fmt::format(", about {} left",
                        DurationText(elapsed / (done_ - before_) * (total_ - done_)));
  }
  const int room = std::min(width - static_cast<int>(text.size()) - 3, kLongestBar);
  if (room < kShortestBar) return text;
  const int full = static_cast<int>(static_cast<std::int64_t>(room) * done_ / std::max(total_, 1));
  std::string bar(static_cast<std::size_t>(full), '=');
  if (full < room) bar += '>';
  bar.resize(static_cast<std::size_t>(room), ' ');
  return fmt::format("[{}] {}", bar, text);
}

void BatchProgress::JobOver(const std::string& failure) {
  ++done_;
  if (failure.empty()) return;
  ++failed_;
  if (quiet_) return;
  End();
  fmt::print(stderr, "{}\n", failure);
  if (terminal_) next_ = Clock::now();
}

void BatchProgress::Show(Clock::time_point now) {
  if (quiet_ || now < next_) return;
  if (terminal_) {
    fmt::print(stderr, "\r{}\x1b[K", Line(now, TerminalWidth() - 1));
    std::fflush(stderr);
    drawn_ = true;
    next_ = now + kRedraw;
  } else {
    fmt::print(stderr, "{}\n", Line(now, 0));
    next_ = now + kNextLine;
  }
}

void BatchProgress::End() {
  if (drawn_) fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace ccmorse::tools
