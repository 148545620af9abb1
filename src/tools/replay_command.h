#pragma once

#include <optional>
#include <string>

namespace ccmorse::tools {

/// What `ccmorse replay` was asked for.
struct ReplayArguments {
  std::string file;
  bool verify = false;
  bool headless = false;     ///< played in the terminal, without the live view
  int view_port = 8000;      ///< or the next free one; 0: any
  bool open = false;         ///< show the view in the user's browser
  std::string speed = "1";   ///< simulated seconds per wall second, or "max"
  double from = 0.0;         ///< s, simulated
  std::optional<double> to;  ///< s, simulated; the record's end
};

/// `ccmorse replay`: shows a record in the live view until it is stopped, or plays it in the
/// terminal or verifies it. Returns the exit status, 0 for a replay that is as the record says, 1
/// for one that differs, 2 for a record that is of no use.
int Replay(const ReplayArguments& arguments);

}  // namespace ccmorse::tools
