#include "servers/own/python_process.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/error.h"

namespace ccmorse::servers {
namespace {

// In the process; morse/core/host.py knows them.
constexpr int kSocket = 3;
constexpr int kTrace = 4;
constexpr auto kDying = std::chrono::milliseconds(500);  // for its last words

std::vector<char*> Pointers(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> Variables(const std::string& folder) {
  const char* const users = std::getenv("PYTHONPATH");
  std::string path = "PYTHONPATH=" + folder;
  if (users != nullptr && *users != '\0') path += std::string(":") + users;
  std::vector<std::string> all = {
      std::move(path),
      "PYTHONDONTWRITEBYTECODE=1",  // what is installed may not be ours to write
      "PYTHONHASHSEED=0",           // so that sets have the same order in every run
      "PYTHONUNBUFFERED=1"};
  const std::size_t ours = all.size();
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::string_view name = text.substr(0, text.find('=') + 1);
    const bool set = std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(ours),
                                 [&](const std::string& one) { return one.starts_with(name); });
    if (!set) all.emplace_back(text);
  }
  return all;
}

// In the child, between fork() and exec(): only calls that a signal's handler may make, too.
[[noreturn]] void Become(pid_t parent, int socket, int trace, char* const* argv,
                         char* const* envp) {
  ::setpgid(0, 0);  // out of reach of the terminal's Ctrl-C
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);  // it has ended meanwhile
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::signal(SIGPIPE, SIG_DFL);
  // Out of each other's way first.
  const int high_socket = ::fcntl(socket, F_DUPFD_CLOEXEC, 10);
  const int high_trace = ::fcntl(trace, F_DUPFD_CLOEXEC, 10);
  if (::dup2(high_socket, kSocket) < 0 || ::dup2(high_trace, kTrace) < 0) ::_exit(127);
  ::execve(argv[0], argv, envp);
  ::_exit(127);
}

int MillisecondsTo(PythonProcess::Clock::time_point deadline) {
  const auto left =
      std::chrono::ceil<std::chrono::milliseconds>(deadline - PythonProcess::Clock::now());
  return static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 3'600'000));
}

}  // namespace

PythonProcess::PythonProcess(const std::string& python, const std::string& folder) {
  std::vector<std::string> command = {python, "-m", "morse.core.host"};
  const std::vector<char*> argv = Pointers(command);
  std::vector<std::string> variables = Variables(folder);
  const std::vector<char*> envp = Pointers(variables);
  std::array<int, 2> ends{};
  std::array<int, 2> trace{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw Error(fmt::format("cannot make a socket: {}", std::strerror(errno)));
  }
  if (::pipe2(trace.data(), O_CLOEXEC) != 0) {
    const int reason = errno;
    for (const int end : ends) ::close(end);
    throw Error(fmt::format("cannot make a pipe: {}", std::strerror(reason)));
  }
  std::fflush(stdout);  // what we have printed comes before what it prints
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0) Become(parent, ends[1], trace[1], argv.data(), envp.data());
  const int reason = errno;
  ::close(ends[1]);
  ::close(trace[1]);
  socket_ = ends[0];
  trace_pipe_ = trace[0];
  if (pid_ < 0) {
    ::close(socket_);
    ::close(trace_pipe_);
    throw Error(fmt::format("cannot start {}: {}", python, std::strerror(reason)));
  }
}

PythonProcess::~PythonProcess() {
  ::close(socket_);  // which it takes for the end
  if (pid_ > 0) {
    // Ends with the process.
    pollfd ended{trace_pipe_, 0, 0};
    ::poll(&ended, 1, static_cast<int>(kDying.count()));
  }
  ::close(trace_pipe_);
  if (pid_ <= 0) return;
  ::kill(pid_, SIGKILL);
  while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

PythonProcess::Result PythonProcess::Send(std::string line, Clock::time_point deadline) {
  line += '\n';
  std::string_view left = line;
  while (!left.empty()) {
    const ssize_t size = ::send(socket_, left.data(), left.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (size > 0) {
      left.remove_prefix(static_cast<std::size_t>(size));
      continue;
    }
    if (errno == EINTR) continue;
    if (errno != EAGAIN && errno != EWOULDBLOCK) return Result::kEnded;
    pollfd ready{socket_, POLLOUT, 0};
    if (::poll(&ready, 1, MillisecondsTo(deadline)) == 0) return Result::kTooLate;
  }
  return Result::kDone;
}

PythonProcess::Result PythonProcess::Read(std::string& line, Clock::time_point deadline) {
  std::size_t searched = 0;
  for (;;) {
    const std::size_t end = received_.find('\n', searched);
    if (end != std::string::npos) {
      line.assign(received_, 0, end);
      received_.erase(0, end + 1);
      return Result::kDone;
    }
    searched = received_.size();
    std::array<char, 16384> block;
    ssize_t size = ::recv(socket_, block.data(), block.size(), MSG_DONTWAIT);
    if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      pollfd ready{socket_, POLLIN, 0};
      if (::poll(&ready, 1, MillisecondsTo(deadline)) == 0) return Result::kTooLate;
      continue;
    }
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return Result::kEnded;
    received_.append(block.data(), static_cast<std::size_t>(size));
  }
}

std::string PythonProcess::End() {
  // Aborted, Python's faulthandler says where it was, whatever it is busy with.
  ::kill(pid_, SIGABRT);
  const auto deadline = Clock::now() + kDying;
  std::array<char, 4096> block;
  for (;;) {
    pollfd ready{trace_pipe_, POLLIN, 0};
    const int count = ::poll(&ready, 1, MillisecondsTo(deadline));
    if (count == 0) break;
    if (count < 0) continue;
    const ssize_t size = ::read(trace_pipe_, block.data(), block.size());
    if (size <= 0) break;
    trace_.append(block.data(), static_cast<std::size_t>(size));
  }
  ::kill(pid_, SIGKILL);
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  if (!WIFSIGNALED(status)) return fmt::format("exit status {}", WEXITSTATUS(status));
  const char* const name = ::sigabbrev_np(WTERMSIG(status));
  return fmt::format("killed by SIG{}", name != nullptr ? name : "?");
}

}  // namespace ccmorse::servers
