#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace ccmorse::servers {

/// A python3 that runs `-m morse.core.host` and talks with us in lines over a socket pair; killed
/// with the object, and when we are killed. It prints where we print. Not thread safe.
class PythonProcess {
 public:
  using Clock = std::chrono::steady_clock;

  /// `folder` holds our package morse. Throws Error.
  PythonProcess(const std::string& python, const std::string& folder);
  ~PythonProcess();
  PythonProcess(const PythonProcess&) = delete;
  PythonProcess& operator=(const PythonProcess&) = delete;

  enum class Result { kDone, kTooLate, kEnded };
  /// Sends a line, to which it adds the line end.
  Result Send(std::string line, Clock::time_point deadline);
  /// The next line, without its end.
  Result Read(std::string& line, Clock::time_point deadline);

  /// Ends it, hanging or dead as it is, and says how it ended: "exit status 3".
  std::string End();
  /// After End(): Python's words about where it was, innermost call first; "" where it had none.
  const std::string& trace() const { return trace_; }

 private:
  pid_t pid_ = -1;
  int socket_ = -1;
  int trace_pipe_ = -1;
  std::string received_;
  std::string trace_;
};

}  // namespace ccmorse::servers
