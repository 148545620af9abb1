#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace ccmorse::testing {

/// A program that a test starts; killed with the object if it still runs. stdout and stderr come
/// together in output(). Not thread safe.
class Process {
 public:
  /// Starts `command` (path first). Throws std::runtime_error.
  explicit Process(const std::vector<std::string>& command);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Reads output until a line contains `text`; that line, or nothing when it does not come in time
  /// or the program ends before.
  std::optional<std::string> WaitForLine(const std::string& text,
                                         std::chrono::seconds timeout = std::chrono::seconds(30));

  /// Waits for its end; the exit status, 128 + signal for a killed one, nothing when it lasts
  /// longer.
  std::optional<int> Wait(std::chrono::seconds timeout = std::chrono::seconds(60));

  void Signal(int signal);
  int pid() const { return pid_; }

  /// All that was read so far; after Wait() everything.
  const std::string& output() const { return output_; }

 private:
  bool Fill(std::chrono::milliseconds timeout);

  int pid_ = -1;
  int pipe_ = -1;
  std::optional<int> status_;
  std::string output_;
  std::size_t searched_ = 0;
};

/// Runs a command to its end.
struct Finished {
  int status = -1;
  std::string output;
};
Finished RunToEnd(const std::vector<std::string>& command,
                  std::chrono::seconds timeout = std::chrono::seconds(60));

/// Path of a program that this build made ("ccmorse").
std::string BuiltProgram(const std::string& name);

inline const std::string kCcmorse = BuiltProgram("ccmorse");

/// The simulator as a process of its own, on free ports.
class Simulator {
 public:
  /// `arguments` after `ccmorse run`. Returns when it listens. Throws std::runtime_error with its
  /// output when it does not.
  explicit Simulator(std::vector<std::string> arguments);
  int port() const { return port_; }
  /// Of the Player server of its first robot; 0 when there is none.
  int player_port();
  Process& process() { return process_; }

 private:
  Process process_;
  int port_ = 0;
  int player_port_ = 0;
};

/// A file that goes with the object.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& ending, const std::string& content);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// An empty folder that goes with the object, and all in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace ccmorse::testing
