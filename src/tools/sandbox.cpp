#include "tools/sandbox.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "base/error.h"
#include "tools/child_process.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kInside = "/ccmorse/bin/ccmorse";  // this program, within

std::string FindBubblewrap() {
  if (std::string found = FindInPath("bwrap"); !found.empty()) return found;
  throw Error(
      "programs are graded in a sandbox, and bubblewrap (the program bwrap) is not installed: "
      "apt-get install bubblewrap. With --no-sandbox they run unprotected");
}

// What every sandbox has: the system's programs and libraries, nothing of its people.
std::vector<std::string> Base() {
  std::vector<std::string> words = {FindBubblewrap(),
                                    "--unshare-all",
                                    "--unshare-user",
                                    "--disable-userns",
                                    "--die-with-parent",
                                    "--new-session",
                                    "--as-pid-1",
                                    "--cap-drop",
                                    "ALL",
                                    "--uid",
                                    "65534",
                                    "--gid",
                                    "65534",
                                    "--hostname",
                                    "sandbox",
                                    "--clearenv",
                                    "--ro-bind",
                                    "/usr",
                                    "/usr"};
  std::error_code ignored;
  for (const char* folder : {"/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32"}) {
    if (fs::is_symlink(folder, ignored)) {
      words.insert(words.end(), {"--symlink", fs::read_symlink(folder, ignored).string(), folder});
    } else if (fs::is_directory(folder, ignored)) {
      words.insert(words.end(), {"--ro-bind", folder, folder});
    }
  }
  for (const char* file : {"/etc/ld.so.cache", "/etc/alternatives"}) {
    words.insert(words.end(), {"--ro-bind-try", file, file});
  }
  // An installed ccmorse brings its courses, solutions and all: not for those who are graded.
  for (const char* folder : {"/usr/share/ccmorse", "/usr/local/share/ccmorse"}) {
    if (fs::is_directory(folder, ignored)) words.insert(words.end(), {"--tmpfs", folder});
  }
  // Whatever can be written to is in memory, small, and gone afterwards.
  words.insert(words.end(), {"--proc", "/proc", "--dev", "/dev", "--size", "16777216", "--tmpfs",
                             "/dev/shm", "--size", "67108864", "--tmpfs", "/tmp"});
  return words;
}

void Add(std::vector<std::string>& words, std::initializer_list<std::string> more) {
  words.insert(words.end(), more);
}

}  // namespace

void RequireSandbox() {
  std::vector<std::string> words = Base();
  Add(words, {"--remount-ro", "/dev", "--remount-ro", "/", "--", "/bin/true"});
  const FinishedProcess tried = RunToEnd(words);
  if (tried.status.ok()) return;
  std::string said = tried.err.substr(0, tried.err.find('\n'));
  if (said.empty()) said = tried.status.Text();
  throw Error(fmt::format(
      "programs are graded in a sandbox, and none can be made here: {}. The kernel has to allow "
      "user namespaces (sysctl kernel.unprivileged_userns_clone=1, or a container that may make "
      "them). With --no-sandbox they run unprotected",
      said));
}

Sandbox::Sandbox(const SandboxOptions& options) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw Error(fmt::format("cannot make a socket: {}", std::strerror(errno)));
  }
  channel_ = ends[0];
  std::vector<std::string> words = Base();
  Add(words, {"--ro-bind", OwnProgram().string(), kInside});
  for (const auto& [ours, within] : options.read_only) Add(words, {"--ro-bind", ours, within});
  for (const auto& [ours, within] : options.writable) Add(words, {"--bind", ours, within});
  Add(words, {"--setenv", "PATH", "/usr/local/bin:/usr/bin:/bin", "--setenv", "HOME", "/tmp",
              "--setenv", "LANG", "C.UTF-8", "--setenv", "TMPDIR", "/tmp"});
  for (const auto& [name, value] : options.variables) Add(words, {"--setenv", name, value});
  Add(words, {"--remount-ro", "/dev", "--remount-ro", "/"});
  if (!options.folder.empty()) Add(words, {"--chdir", options.folder});
  Add(words, {"--", kInside});
  const std::vector<std::string> init =
      SandboxInitCommand(ends[1], options.port, options.limits, options.command);
  words.insert(words.end(), init.begin(), init.end());
  try {
    process_ = std::make_unique<ChildProcess>(ChildProcess::Options{words, "", {}, {ends[1]}});
  } catch (...) {
    ::close(ends[0]);
    ::close(ends[1]);
    throw;
  }
  ::close(ends[1]);
}

Sandbox::~Sandbox() {
  process_.reset();
  if (listener_ >= 0) ::close(listener_);
  ::close(channel_);
}

bool Sandbox::Step() {
  bool news = false;
  for (;;) {
    SandboxMessage message;
    int file = -1;
    if (!ReceiveMessage(channel_, MSG_DONTWAIT, message, file)) return news;
    news = true;
    if (message.kind == SandboxMessage::kListening) {
      listener_ = file;
    } else {
      end_ = message;
    }
  }
}

int Sandbox::TakeListener() { return std::exchange(listener_, -1); }

void Sandbox::Go() {
  const SandboxMessage go{SandboxMessage::kGo, 0, 0.0, 0.0};
  ::send(channel_, &go, sizeof go, MSG_NOSIGNAL);
}

void Sandbox::Kill() { process_->Signal(SIGKILL); }

std::string FailureOf(const SandboxMessage& end, const SandboxLimits& limits) {
  switch (end.kind) {
    case SandboxMessage::kKilled:
      return "the program crashed: " + ExitStatus{0, end.number}.Text();
    case SandboxMessage::kCpuLimit:
      return fmt::format("the program used more than {} s of processor time", limits.cpu_s);
    case SandboxMessage::kMemoryLimit:
      return fmt::format("the program used more than {} MB of memory", limits.memory_mb);
    case SandboxMessage::kProcessLimit:
      return fmt::format("the program had more than {} processes and threads", limits.processes);
    case SandboxMessage::kNotStarted:
      return fmt::format("the program could not be started: {}", std::strerror(end.number));
    default:
      return "";
  }
}

}  // namespace ccmorse::tools
