#include "tests/support/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace ccmorse::testing {

Process::Process(const std::vector<std::string>& command) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe failed");
  std::vector<char*> argv;
  for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("fork failed");
  if (pid_ == 0) {
    ::dup2(ends[1], 1);
    ::dup2(ends[1], 2);
    ::execvp(argv[0], argv.data());
    ::_exit(127);
  }
  ::close(ends[1]);
  pipe_ = ends[0];
}

Process::~Process() {
  if (!status_) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  ::close(pipe_);
}

bool Process::Fill(std::chrono::milliseconds timeout) {
  pollfd waiting{pipe_, POLLIN, 0};
  if (::poll(&waiting, 1, static_cast<int>(timeout.count())) <= 0) return false;
  std::array<char, 4096> block;
  const ssize_t size = ::read(pipe_, block.data(), block.size());
  if (size <= 0) return false;
  output_.append(block.data(), static_cast<std::size_t>(size));
  return true;
}

std::optional<std::string> Process::WaitForLine(const std::string& text,
                                                std::chrono::seconds timeout) {
  const auto until = std::chrono::steady_clock::now() + timeout;
  for (;;) {
    for (std::size_t end; (end = output_.find('\n', searched_)) != std::string::npos;) {
      const std::string line = output_.substr(searched_, end - searched_);
      searched_ = end + 1;
      if (line.find(text) != std::string::npos) return line;
    }
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        until - std::chrono::steady_clock::now());
    if (left.count() < 0 || !Fill(left)) return std::nullopt;
  }
}

std::optional<int> Process::Wait(std::chrono::seconds timeout) {
  const auto until = std::chrono::steady_clock::now() + timeout;
  while (!status_) {
    // The pipe ends with the program, so waiting for that is waiting for both.
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        until - std::chrono::steady_clock::now());
    if (left.count() < 0) return std::nullopt;
    if (Fill(left)) continue;
    int raw = 0;
    const pid_t ended = ::waitpid(pid_, &raw, left.count() > 0 ? 0 : WNOHANG);
    if (ended == pid_) status_ = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
  }
  return status_;
}

void Process::Signal(int signal) {
  if (!status_) ::kill(pid_, signal);
}

Finished RunToEnd(const std::vector<std::string>& command, std::chrono::seconds timeout) {
  Process process(command);
  const std::optional<int> status = process.Wait(timeout);
  return {status.value_or(-1), process.output()};
}

std::string BuiltProgram(const std::string& name) {
  return std::string(CCMORSE_BINARY_DIR) + "/bin/" + name;
}

namespace {

std::vector<std::string> SimulatorCommand(std::vector<std::string> arguments) {
  std::vector<std::string> command = {BuiltProgram("ccmorse"), "run"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  for (const char* word : {"--port", "0", "--stream-port", "0"}) command.emplace_back(word);
  return command;
}

}  // namespace

Simulator::Simulator(std::vector<std::string> arguments)
    : process_(SimulatorCommand(std::move(arguments))) {
  const std::string key = "MORSE services on 127.0.0.1 port ";
  const auto line = process_.WaitForLine(key);
  if (!line) throw std::runtime_error("the simulator does not start: " + process_.output());
  port_ = std::atoi(line->c_str() + key.size());
}

int Simulator::player_port() {
  const std::string key = "Player on 127.0.0.1 port ";
  if (player_port_ != 0) return player_port_;
  const auto line = process_.WaitForLine(key);
  player_port_ = line ? std::atoi(line->c_str() + key.size()) : 0;
  return player_port_;
}

TemporaryFile::TemporaryFile(const std::string& ending, const std::string& content) {
  std::string name = (std::filesystem::temp_directory_path() / "ccmorse_XXXXXX").string() + ending;
  const int file = ::mkstemps(name.data(), static_cast<int>(ending.size()));
  if (file < 0) throw std::runtime_error("cannot make a temporary file");
  ::close(file);
  path_ = name;
  std::ofstream(path_, std::ios::binary) << content;
}

TemporaryFile::~TemporaryFile() { std::filesystem::remove(path_); }

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "ccmorse_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() { std::filesystem::remove_all(path_); }

}  // namespace ccmorse::testing
