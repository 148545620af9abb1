#pragma once

#include <poll.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/child_process.h"
#include "tools/sandbox_init.h"

namespace ccmorse::tools {

/// What a sandboxed program sees beside the system's own programs and libraries: nothing else of
/// the machine is there (docs/grading.md).
struct SandboxOptions {
  std::vector<std::string> command;                            ///< paths within the sandbox
  std::string folder;                                          ///< where it starts, within
  std::vector<std::pair<std::string, std::string>> read_only;  ///< (ours, within)
  std::vector<std::pair<std::string, std::string>> writable;   ///< (ours, within)
  std::vector<std::pair<std::string, std::string>> variables;  ///< of the environment
  int port = 0;                                                ///< of a socket for it; 0: none
  SandboxLimits limits;
};

/// Throws Error that says what is missing where programs cannot be sandboxed here: no bubblewrap,
/// or a kernel that lets nobody make namespaces.
void RequireSandbox();

/// A program under bubblewrap, in namespaces of its own: no network but one socket, which the
/// caller gets; no processes but its own; no files but those that are named. Ends with the object.
/// Not thread safe.
class Sandbox {
 public:
  /// Throws Error when no process can be started.
  explicit Sandbox(const SandboxOptions& options);
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  /// Takes what came over the channel, without waiting. True when there is news.
  bool Step();
  /// The socket that listens within, as soon as it is there; then the caller's to close. -1 before
  /// and after.
  int TakeListener();
  /// Lets the program start. After the listener is there.
  void Go();
  /// Kills all of it.
  void Kill();

  /// How the program ended; nothing as long as it runs.
  const std::optional<SandboxMessage>& end() const { return end_; }
  /// bubblewrap itself has ended, and all within.
  bool Over() { return process_->Status().has_value(); }
  ChildProcess& process() { return *process_; }
  int channel() const { return channel_; }

 private:
  int channel_ = -1;
  int listener_ = -1;
  std::unique_ptr<ChildProcess> process_;
  std::optional<SandboxMessage> end_;
};

/// "used more than 60 s of processor time": why the end of a program is a failure; "" when it is
/// not.
std::string FailureOf(const SandboxMessage& end, const SandboxLimits& limits);

}  // namespace ccmorse::tools
