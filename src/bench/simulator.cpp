#include "bench/simulator.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace ccmorse::bench {
namespace {

// The number behind `key` at the start of a line; 0 when the line is another.
int NumberAfter(const std::string& key, const std::string& line) {
  return line.rfind(key, 0) == 0 ? std::atoi(line.c_str() + key.size()) : 0;
}

}  // namespace

double Since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double Quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

ScenarioFile::ScenarioFile(const std::string& json)
    : path_((std::filesystem::temp_directory_path() / "ccmorse_XXXXXX.json").string()) {
  const int file = ::mkstemps(path_.data(), 5);
  if (file < 0) throw std::runtime_error("cannot make a temporary file");
  ::close(file);
  std::ofstream(path_) << json;
}

ScenarioFile::~ScenarioFile() { std::remove(path_.c_str()); }

Simulator::Simulator(const std::string& ccmorse, const std::string& scenario,
                     const std::string& pace, int player_port, View view) {
  const std::string player = std::to_string(player_port);
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("cannot make a pipe");
  child_ = ::fork();
  if (child_ < 0) throw std::runtime_error("cannot start the simulator");
  if (child_ == 0) {
    ::setsid();  // as from another terminal, which Linux schedules as another group
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::dup2(ends[1], STDOUT_FILENO);
    ::close(ends[0]);
    ::close(ends[1]);
    std::vector<const char*> words = {
        "ccmorse",       "run", scenario.c_str(), "--pace",      pace.c_str(), "--port", "0",
        "--stream-port", "0",   "--player-port",  player.c_str()};
    if (view == View::kNone) {
      words.push_back("--headless");
    } else {
      words.insert(words.end(), {"--view-port", "0", "--threads", "1"});
    }
    words.push_back(nullptr);
    ::execv(ccmorse.c_str(), const_cast<char* const*>(words.data()));
    ::_exit(127);
  }
  ::close(ends[1]);
  // Kept open to the end: a simulator without a reader would end when it prints.
  output_ = ::fdopen(ends[0], "r");
  char line[256];
  while (output_ != nullptr && std::fgets(line, sizeof line, output_) != nullptr) {
    if (const int port = NumberAfter("MORSE services on 127.0.0.1 port ", line)) port_ = port;
    if (player_port_ == 0) player_port_ = NumberAfter("Player on 127.0.0.1 port ", line);
    if (const int port = NumberAfter("View at http://127.0.0.1:", line)) view_port_ = port;
    if (std::string(line).rfind("SCENE INITIALIZED", 0) == 0) break;
  }
  if (port_ == 0 || player_port_ == 0 || (view == View::kServed && view_port_ == 0)) {
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
    if (output_ != nullptr) std::fclose(output_);
    throw std::runtime_error(ccmorse + " does not start");
  }
}

Simulator::~Simulator() {
  ::kill(child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
  if (output_ != nullptr) std::fclose(output_);
}

double Simulator::ProcessorTime() const {
  std::ifstream stat("/proc/" + std::to_string(child_) + "/stat");
  std::string word;
  double ticks = 0.0;
  // The 14th and 15th: in the program, and in the kernel for it (man 5 proc). ccmorse has no blank
  // in its name.
  for (int i = 1; i <= 15 && stat >> word; ++i) {
    if (i >= 14) ticks += std::atof(word.c_str());
  }
  return ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

}  // namespace ccmorse::bench
