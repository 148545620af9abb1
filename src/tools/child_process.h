#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ccmorse::tools {

/// How a program ended.
struct ExitStatus {
  int code = 0;    ///< exit status; of no meaning when a signal ended it
  int signal = 0;  ///< what killed it; 0: it ended by itself

  bool ok() const { return code == 0 && signal == 0; }
  /// "exit status 3", or "killed by SIGSEGV (Segmentation fault)".
  std::string Text() const;
};

/// A program that runs beside us in a process group of its own, with nothing on its stdin and pipes
/// for what it prints. It is killed with its group when the object goes, when it ends itself (what
/// it has left behind), and when we are killed. Not thread safe; no other
/// thread may have been started before.
class ChildProcess {
 public:
  struct Options {
    std::vector<std::string> command;      ///< path of the program, then its arguments
    std::string folder;                    ///< where it starts; "": here
    std::vector<std::string> environment;  ///< "NAME=VALUE", beside ours
    std::vector<int> handed = {};          ///< file descriptors that it has, too, by their numbers
  };

  /// Throws Error that names the program and the reason.
  explicit ChildProcess(const Options& options);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// The pipes' ends, to be polled; -1 once they have ended.
  int out() const { return out_; }
  int err() const { return err_; }

  /// Appends up to 256 KiB of what there is to read, without waiting for any. True when there may
  /// be more.
  bool ReadOut(std::string& text) { return Read(out_, text); }
  bool ReadErr(std::string& text) { return Read(err_, text); }

  /// How it ended, nothing while it runs. Does not wait.
  const std::optional<ExitStatus>& Status();

  /// Sends a signal to it and its group, unless it has ended.
  void Signal(int signal);

 private:
  static bool Read(int& pipe, std::string& text);

  pid_t pid_ = -1;
  int out_ = -1;
  int err_ = -1;
  std::optional<ExitStatus> status_;
};

/// Is this a file that may be executed?
bool IsProgram(const std::string& path);

/// The absolute path of a program of this name, by $PATH; "" where there is none. Without $PATH the
/// system's usual folders are looked in; empty entries of it, which mean the current folder, never.
std::string FindInPath(const std::string& program);

/// A process that has ended, and all that it printed.
struct FinishedProcess {
  ExitStatus status;
  std::string out;
  std::string err;
};

/// Runs a command (path first) to its end, however long that takes. Throws Error when it cannot be
/// started.
FinishedProcess RunToEnd(const std::vector<std::string>& command);

/// The file of this program. Throws Error where the system does not tell.
std::filesystem::path OwnProgram();

}  // namespace ccmorse::tools
