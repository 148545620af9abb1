#include "tools/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <set>
#include <sstream>
#include <system_error>

#include "base/error.h"

namespace ccmorse::tools {
namespace {

// Both ends are closed in every program that we start; dup2() makes the ones that it is to have.
struct Pipe {
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw Error(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
    }
  }
  ~Pipe() {
    Close(0);
    Close(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void Close(std::size_t end) {
    if (ends[end] >= 0) ::close(ends[end]);
    ends[end] = -1;
  }
  int Take(std::size_t end) {
    const int taken = ends[end];
    ends[end] = -1;
    return taken;
  }

  std::array<int, 2> ends{-1, -1};
};

std::vector<char*> Pointers(const std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

// Ours, but for the names that `changes` give another value.
std::vector<std::string> Environment(const std::vector<std::string>& changes) {
  std::vector<std::string> all = changes;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const std::string name = text.substr(0, text.find('=') + 1);
    bool changed = false;
    for (const std::string& change : changes) changed = changed || change.starts_with(name);
    if (!changed) all.push_back(text);
  }
  return all;
}

// A process of its own that ends the groups of our children when we are killed, which no handler of
// ours could do: it sees the pipe end that we alone write to. What a child itself has started would
// else go on for ever.
class Watchdog {
 public:
  static Watchdog& Ours() {
    static Watchdog ours;
    return ours;
  }

  // To be told before the group's leader is reaped, lest its number be somebody else's.
  void Watch(pid_t group) { Tell(group); }
  void Forget(pid_t group) { Tell(-group); }

 private:
  Watchdog() {
    const pid_t pid = ::fork();
    if (pid < 0) throw Error(fmt::format("cannot start a process: {}", std::strerror(errno)));
    if (pid == 0) Guard();
    pipe_.Close(0);
  }

  void Tell(pid_t group) {
    // Shorter than PIPE_BUF, so it is written as a whole.
    while (::write(pipe_.ends[1], &group, sizeof group) < 0 && errno == EINTR) {
    }
  }

  [[noreturn]] void Guard() {
    ::setsid();  // out of reach of the terminal's Ctrl-C
    // Nothing of ours must stay open, least of all the pipe's other end and the locked results.
    const int pipe = ::dup2(pipe_.ends[0], 3);
    const int nothing = ::open("/dev/null", O_RDWR);
    for (int standard = 0; standard < 3; ++standard) ::dup2(nothing, standard);
    ::close_range(4, ~0U, 0);
    std::set<pid_t> groups;
    pid_t told = 0;
    for (;;) {
      const ssize_t size = ::read(pipe, &told, sizeof told);
      if (size < 0 && errno == EINTR) continue;
      if (size != sizeof told) break;
      if (told > 0) groups.insert(told);
      if (told < 0) groups.erase(-told);
    }
    for (const pid_t group : groups) ::kill(-group, SIGKILL);
    ::_exit(0);
  }

  Pipe pipe_;
};

// In the child, between fork() and exec(): only calls that a signal's handler may make, too.
[[noreturn]] void Become(pid_t parent, char* const* argv, char* const* environment,
                         const char* folder, const std::vector<int>& handed, int out, int err,
                         int report) {
  const auto give_up = [report] {
    const int reason = errno;
    [[maybe_unused]] const ssize_t told = ::write(report, &reason, sizeof reason);
    ::_exit(127);
  };
  ::setpgid(0, 0);
  // Until the watchdog knows of it. We may have been killed before this line.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::signal(SIGPIPE, SIG_DFL);
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (nothing < 0 || ::dup2(nothing, 0) < 0 || ::dup2(out, 1) < 0 || ::dup2(err, 2) < 0) give_up();
  for (const int file : handed) {
    if (::fcntl(file, F_SETFD, 0) != 0) give_up();
  }
  if (*folder != '\0' && ::chdir(folder) != 0) give_up();
  ::execve(argv[0], argv, environment);
  give_up();
  ::_exit(127);
}

}  // namespace

std::string ExitStatus::Text() const {
  if (signal == 0) return fmt::format("exit status {}", code);
  const char* const name = ::sigabbrev_np(signal);
  const char* const meaning = ::sigdescr_np(signal);
  return fmt::format("killed by SIG{} ({})", name != nullptr ? name : std::to_string(signal),
                     meaning != nullptr ? meaning : "unknown");
}

// fork() and not posix_spawn(), which cannot set the signal of a parent's death.
ChildProcess::ChildProcess(const Options& options) {
  const std::vector<char*> argv = Pointers(options.command);
  const std::vector<std::string> variables = Environment(options.environment);
  const std::vector<char*> environment = Pointers(variables);
  Pipe out;
  Pipe err;
  Pipe report;  // ends with a successful exec(), else brings its errno
  Watchdog& watchdog = Watchdog::Ours();
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ < 0) throw Error(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (pid_ == 0) {
    Become(parent, argv.data(), environment.data(), options.folder.c_str(), options.handed,
           out.ends[1], err.ends[1], report.ends[1]);
  }
  ::setpgid(pid_, pid_);  // here, too: whoever is first, it has its group before we signal it
  watchdog.Watch(pid_);
  report.Close(1);
  int reason = 0;
  ssize_t told = 0;
  do {
    told = ::read(report.ends[0], &reason, sizeof reason);
  } while (told < 0 && errno == EINTR);
  if (told != 0) {
    watchdog.Forget(pid_);
    ::waitpid(pid_, nullptr, 0);
    throw Error(fmt::format("cannot start {}: {}", options.command.front(), std::strerror(reason)));
  }
  out_ = out.Take(0);
  err_ = err.Take(0);
  for (const int pipe : {out_, err_}) ::fcntl(pipe, F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() {
  if (!status_) {
    ::kill(-pid_, SIGKILL);
    Watchdog::Ours().Forget(pid_);
    ::waitpid(pid_, nullptr, 0);
  }
  for (const int pipe : {out_, err_}) {
    if (pipe >= 0) ::close(pipe);
  }
}

bool ChildProcess::Read(int& pipe, std::string& text) {
  constexpr int kMostBlocks = 16;
  std::array<char, 16384> block;
  for (int i = 0; pipe >= 0 && i < kMostBlocks; ++i) {
    const ssize_t size = ::read(pipe, block.data(), block.size());
    if (size > 0) {
      text.append(block.data(), static_cast<std::size_t>(size));
    } else if (size < 0 && (errno == EAGAIN || errno == EINTR)) {
      return false;
    } else {
      ::close(pipe);
      pipe = -1;
    }
  }
  return pipe >= 0;
}

const std::optional<ExitStatus>& ChildProcess::Status() {
  if (status_) return status_;
  // First a look: as long as it is not reaped, its number and its group are nobody else's.
  siginfo_t info{};
  if (::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
      info.si_pid != pid_) {
    return status_;
  }
  ::kill(-pid_, SIGKILL);
  Watchdog::Ours().Forget(pid_);
  int raw = 0;
  ::waitpid(pid_, &raw, 0);
  status_ = WIFSIGNALED(raw) ? ExitStatus{0, WTERMSIG(raw)} : ExitStatus{WEXITSTATUS(raw), 0};
  return status_;
}

void ChildProcess::Signal(int signal) {
  if (!Status()) ::kill(-pid_, signal);
}

FinishedProcess RunToEnd(const std::vector<std::string>& command) {
  ChildProcess process({command, "", {}});
  FinishedProcess finished;
  while (!process.Status() || process.out() >= 0 || process.err() >= 0) {
    std::array<pollfd, 2> pipes{{{process.out(), POLLIN, 0}, {process.err(), POLLIN, 0}}};
    // It may close its pipes long before it ends, so we look now and then.
    ::poll(pipes.data(), pipes.size(), 20);
    process.ReadOut(finished.out);
    process.ReadErr(finished.err);
  }
  finished.status = *process.Status();
  return finished;
}

bool IsProgram(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

std::string FindInPath(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string file = folder + "/" + program;
    if (!folder.empty() && IsProgram(file)) return std::filesystem::absolute(file).string();
  }
  return "";
}

std::filesystem::path OwnProgram() {
  std::error_code failed;
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", failed);
  if (failed) throw Error("cannot find this program's own file: " + failed.message());
  return own;
}

}  // namespace ccmorse::tools
