#pragma once

#include <string>
#include <vector>

namespace ccmorse::tools {

/// What a sandboxed program may use, and how it ended; passed over a socket of packets.
struct SandboxMessage {
  enum Kind : int {
    kListening = 1,  ///< from within: a listening socket comes along
    kGo,             ///< from outside: start the program
    kExited,         ///< from within: `number` is its exit status
    kKilled,         ///< `number` is the signal that ended it
    kCpuLimit,
    kMemoryLimit,
    kProcessLimit,
    kNotStarted,  ///< `number` is errno
  };
  int kind = 0;
  int number = 0;
  double cpu_s = 0.0;      ///< s that all its processes used
  double memory_mb = 0.0;  ///< MB, at most at a time
};

/// Takes a message from a socket of packets, with a file where one comes along; `flags` as
/// recvmsg() has them. False where there is none.
bool ReceiveMessage(int channel, int flags, SandboxMessage& message, int& file);

/// Limits within a sandbox.
struct SandboxLimits {
  double cpu_s = 60.0;       ///< s, all processes together
  double memory_mb = 512.0;  ///< MB of resident memory, all processes together
  int processes = 64;        ///< and threads
  double file_mb = 64.0;     ///< MB of one file
};

/// The arguments for `ccmorse` within a sandbox: a TCP socket listens on 127.0.0.1 `port` (0: none)
/// and goes out over `channel`; after kGo the command runs, is watched, and its end is told.
std::vector<std::string> SandboxInitCommand(int channel, int port, const SandboxLimits& limits,
                                            const std::vector<std::string>& command);

/// `ccmorse sandbox-init ...`: process 1 of a sandbox, whose end ends all others there. It counts
/// processes and adds up memory and processor time itself, since RLIMIT_NPROC binds no root and no
/// other limit is for all processes together. The program cannot signal it, for it is process 1,
/// nor look into it. Returns the exit status.
int SandboxInit(int argc, char** argv);

}  // namespace ccmorse::tools
