#pragma once

#include <chrono>
#include <string>

namespace ccmorse::tools {

/// What a batch shows of itself on stderr: on a terminal a bar that is drawn over, elsewhere a line
/// now and then.
class BatchProgress {
 public:
  using Clock = std::chrono::steady_clock;

  /// `total` jobs, of which `before` have a result from an earlier start. `quiet`: shows nothing.
  BatchProgress(int total, int before, bool quiet);

  /// A job has ended. `failure`: what to say of it, in a line of its own; "": it went well.
  void JobOver(const std::string& failure);
  /// Shows where things stand, when it is time to.
  void Show(Clock::time_point now);
  /// Takes the bar away.
  void End();

  /// "[=====>    ] 37 of 100, 2 failed, about 1 min 20 s left", at most `width` columns; without a
  /// bar where that leaves no room for it, and for width 0.
  std::string Line(Clock::time_point now, int width) const;

  int failed() const { return failed_; }

 private:
  int total_;
  int before_;
  int done_;
  int failed_ = 0;
  bool quiet_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point started_;
  Clock::time_point next_;
};

/// "45 s", "1 min 20 s", "3 h 5 min": for people, >= 0 s.
std::string DurationText(double seconds);

}  // namespace ccmorse::tools
