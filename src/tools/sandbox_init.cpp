#include "tools/sandbox_init.h"

#include <arpa/inet.h>
#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

namespace ccmorse::tools {
namespace {

constexpr int kFirstWord = 8;  // of the command, in argv
constexpr double kMega = 1e6;
constexpr int kLook = 10;  // ms from one look at the processes to the next

// Sends a message, with a file if there is one.
bool Tell(int channel, const SandboxMessage& message, int file = -1) {
  iovec part{const_cast<SandboxMessage*>(&message), sizeof message};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  msghdr header{};
  header.msg_iov = &part;
  header.msg_iovlen = 1;
  if (file >= 0) {
    header.msg_control = control.data();
    header.msg_controllen = control.size();
    cmsghdr* const entry = CMSG_FIRSTHDR(&header);
    entry->cmsg_level = SOL_SOCKET;
    entry->cmsg_type = SCM_RIGHTS;
    entry->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(entry), &file, sizeof file);
  }
  return ::sendmsg(channel, &header, MSG_NOSIGNAL) >= 0;
}

}  // namespace

bool ReceiveMessage(int channel, int flags, SandboxMessage& message, int& file) {
  iovec part{&message, sizeof message};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  msghdr header{};
  header.msg_iov = &part;
  header.msg_iovlen = 1;
  header.msg_control = control.data();
  header.msg_controllen = control.size();
  ssize_t size = 0;
  do {
    size = ::recvmsg(channel, &header, flags | MSG_CMSG_CLOEXEC);
  } while (size < 0 && errno == EINTR);
  if (size != sizeof message) return false;
  const cmsghdr* const entry = CMSG_FIRSTHDR(&header);
  if (entry != nullptr && entry->cmsg_type == SCM_RIGHTS) {
    std::memcpy(&file, CMSG_DATA(entry), sizeof file);
  }
  return true;
}

namespace {

int Listen(int port) {
  const int file = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int on = 1;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ::setsockopt(file, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (file < 0 || ::bind(file, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 ||
      ::listen(file, 64) != 0) {
    return -1;
  }
  return file;
}

void Limit(__rlimit_resource what, double most) {
  const auto number = static_cast<rlim_t>(most);
  const rlimit limit{number, number};
  ::setrlimit(what, &limit);
}

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

// What all processes but this one use.
struct Use {
  int tasks = 0;
  double memory_mb = 0.0;
  double cpu_s = 0.0;
};

// Reads a short file of /proc, whole.
std::string ReadProc(const std::string& path) {
  std::array<char, 1024> text{};
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return "";
  const ssize_t size = ::read(file, text.data(), text.size());
  ::close(file);
  return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : "";
}

void AddProcess(const std::string& folder, Use& use) {
  struct stat tasks {};
  if (::stat((folder + "/task").c_str(), &tasks) != 0) return;  // it has just ended
  use.tasks += std::max(1, static_cast<int>(tasks.st_nlink) - 2);
  const std::string memory = ReadProc(folder + "/statm");
  const char* resident = std::strchr(memory.c_str(), ' ');
  if (resident != nullptr) {
    use.memory_mb +=
        std::strtod(resident, nullptr) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / kMega;
  }
  // Fields 14 to 17, after the name, which may hold blanks and brackets.
  const std::string line = ReadProc(folder + "/stat");
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return;
  const char* at = line.c_str() + name_end + 1;
  char* next = nullptr;
  for (int skipped = 3; skipped < 14 && at != nullptr; ++skipped) at = std::strchr(at + 1, ' ');
  for (int field = 14; field <= 17 && at != nullptr; ++field, at = next) {
    use.cpu_s += std::strtod(at, &next) / static_cast<double>(::sysconf(_SC_CLK_TCK));
  }
}

Use LookAtAll() {
  Use use;
  const std::unique_ptr<DIR, int (*)(DIR*)> folder(::opendir("/proc"), ::closedir);
  if (folder == nullptr) return use;
  while (const dirent* const entry = ::readdir(folder.get())) {
    const std::string name = entry->d_name;
    if (std::isdigit(static_cast<unsigned char>(name[0])) == 0 || name == "1") continue;
    AddProcess("/proc/" + name, use);
  }
  rusage ended{};  // those that were reaped here, with all that they had reaped
  ::getrusage(RUSAGE_CHILDREN, &ended);
  use.cpu_s += Seconds(ended.ru_utime) + Seconds(ended.ru_stime);
  return use;
}

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0;
#endif

// Has each start of a process or thread wait until process 1 has counted (seccomp_unotify(2)), so
// that a fork bomb is no faster than it. Calls of another architecture's, which have other numbers,
// fail. Returns the file to be asked by, -1 where the kernel has no such thing.
int GateForks() {
  if (kArchitecture == 0) return -1;
  std::vector<sock_filter> filter = {
    BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kArchitecture, 1, 0),
    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
    BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
#if defined(__x86_64__)
    BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, 0x40000000U, 0, 1),  // the x32 calls
    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
#endif
  };
  constexpr std::array kForks = {
#if defined(__NR_fork)
    __NR_fork,
    __NR_vfork,
#endif
    __NR_clone,
    __NR_clone3
  };
  for (const int fork : kForks) {
    filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(fork), 0, 1));
    filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_USER_NOTIF));
  }
  filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return -1;
  return static_cast<int>(
      ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_NEW_LISTENER, &program));
}

// Lets a start of a process go on where there is room for one more. False where there is none.
bool AnswerFork(int gate, const SandboxLimits& limits) {
  seccomp_notif asked{};
  if (::ioctl(gate, SECCOMP_IOCTL_NOTIF_RECV, &asked) != 0) return true;  // whoever asked has ended
  if (LookAtAll().tasks >= limits.processes) return false;
  seccomp_notif_resp answer{};
  answer.id = asked.id;
  answer.flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
  ::ioctl(gate, SECCOMP_IOCTL_NOTIF_SEND, &answer);
  return true;
}

[[noreturn]] void BecomeProgram(char** command, const SandboxLimits& limits, int report,
                                int gate_channel) {
  ::signal(SIGPIPE, SIG_DFL);
  Limit(RLIMIT_CORE, 0);
  Limit(RLIMIT_NPROC, limits.processes);
  Limit(RLIMIT_CPU, limits.cpu_s + 2.0);
  Limit(RLIMIT_FSIZE, limits.file_mb * kMega);
  Limit(RLIMIT_NOFILE, 256);
  // Threads reserve far more than they use; what is used is watched.
  Limit(RLIMIT_AS, limits.memory_mb * kMega * 4.0 + 8e9);
  // Not before the limits, and nothing is started here any more.
  const int gate = GateForks();
  Tell(gate_channel, {SandboxMessage::kListening, 0, 0.0, 0.0}, gate);
  ::execv(command[0], command);
  const int reason = errno;
  [[maybe_unused]] const ssize_t told = ::write(report, &reason, sizeof reason);
  ::_exit(127);
}

// Watches until the program has ended, or has to.
SandboxMessage Watch(pid_t program, int gate, const SandboxLimits& limits) {
  SandboxMessage end;
  auto next = std::chrono::steady_clock::now();
  for (;;) {
    pollfd asked{gate, POLLIN, 0};
    ::poll(&asked, 1, kLook);
    if (gate >= 0 && (asked.revents & POLLIN) != 0 && !AnswerFork(gate, limits)) {
      end.kind = SandboxMessage::kProcessLimit;
      return end;
    }
    if (std::chrono::steady_clock::now() < next) continue;
    next = std::chrono::steady_clock::now() + std::chrono::milliseconds(kLook);
    int raw = 0;
    for (pid_t pid = 0; (pid = ::waitpid(-1, &raw, WNOHANG)) > 0;) {
      if (pid != program) continue;
      end.kind = WIFSIGNALED(raw) ? SandboxMessage::kKilled : SandboxMessage::kExited;
      end.number = WIFSIGNALED(raw) ? WTERMSIG(raw) : WEXITSTATUS(raw);
    }
    const Use use = LookAtAll();
    end.cpu_s = std::max(end.cpu_s, use.cpu_s);
    end.memory_mb = std::max(end.memory_mb, use.memory_mb);
    const bool out_of_time = end.kind == SandboxMessage::kKilled && end.number == SIGXCPU;
    if (use.tasks > limits.processes) end.kind = SandboxMessage::kProcessLimit;
    if (use.memory_mb > limits.memory_mb) end.kind = SandboxMessage::kMemoryLimit;
    if (use.cpu_s > limits.cpu_s || out_of_time) end.kind = SandboxMessage::kCpuLimit;
    if (end.kind != 0) return end;
  }
}

}  // namespace

std::vector<std::string> SandboxInitCommand(int channel, int port, const SandboxLimits& limits,
                                            const std::vector<std::string>& command) {
  std::vector<std::string> words = {"sandbox-init",
                                    std::to_string(channel),
                                    std::to_string(port),
                                    fmt::format("{}", limits.cpu_s),
                                    fmt::format("{}", limits.memory_mb),
                                    std::to_string(limits.processes),
                                    fmt::format("{}", limits.file_mb)};
  words.insert(words.end(), command.begin(), command.end());
  return words;
}

int SandboxInit(int argc, char** argv) {
  constexpr int kBadUse = 2;
  if (argc <= kFirstWord || ::getpid() != 1) {
    std::fputs("ccmorse sandbox-init is a part of ccmorse grade, and of no use by itself\n",
               stderr);
    return kBadUse;
  }
  ::prctl(PR_SET_DUMPABLE, 0);
  const int channel = std::atoi(argv[2]);
  ::fcntl(channel, F_SETFD, FD_CLOEXEC);
  SandboxLimits limits;
  const int port = std::atoi(argv[3]);
  limits.cpu_s = std::strtod(argv[4], nullptr);
  limits.memory_mb = std::strtod(argv[5], nullptr);
  limits.processes = std::atoi(argv[6]);
  limits.file_mb = std::strtod(argv[7], nullptr);

  if (port != 0) {
    const int listener = Listen(port);
    if (listener < 0) {
      std::perror("ccmorse sandbox-init: cannot listen");
      return 1;
    }
    if (!Tell(channel, {SandboxMessage::kListening, 0, 0.0, 0.0}, listener)) return 1;
    ::close(listener);
  }
  SandboxMessage go;
  if (::recv(channel, &go, sizeof go, 0) != sizeof go || go.kind != SandboxMessage::kGo) return 1;

  std::array<int, 2> report{};  // ends with a successful exec(), else brings its errno
  if (::pipe2(report.data(), O_CLOEXEC) != 0) return 1;
  std::array<int, 2> gate_ends{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, gate_ends.data()) != 0) return 1;
  const pid_t program = ::fork();
  if (program < 0) return 1;
  if (program == 0) BecomeProgram(argv + kFirstWord, limits, report[1], gate_ends[1]);
  ::close(report[1]);
  ::close(gate_ends[1]);
  int gate = -1;
  SandboxMessage ready;
  ReceiveMessage(gate_ends[0], 0, ready, gate);
  int reason = 0;
  if (::read(report[0], &reason, sizeof reason) == sizeof reason) {
    Tell(channel, {SandboxMessage::kNotStarted, reason, 0.0, 0.0});
    return 1;
  }
  Tell(channel, Watch(program, gate, limits));
  return 0;  // and with this process all others end
}

}  // namespace ccmorse::tools
