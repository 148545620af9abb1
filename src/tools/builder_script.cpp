#include "tools/builder_script.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/json.h"
#include "scene/scenario.h"
#include "tools/child_process.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostBytes = std::size_t{64} << 20;
constexpr int kSceneDescriptor = 3;  // in the script's process

// A process that writes into a pipe of ours; ended with its pipe when the object goes.
class Writer {
 public:
  Writer(const std::vector<std::string>& command, const std::vector<std::string>& environment) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw Error(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
    }
    pipe_ = ends[0];
    std::vector<char*> words = Pointers(command);
    std::vector<char*> variables = Pointers(environment);
    std::fflush(stdout);  // what we have printed comes before what the script prints
    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ == 0) Become(parent, ends[1], words.data(), variables.data());
    ::close(ends[1]);
    if (pid_ < 0) {
      ::close(pipe_);
      throw Error(fmt::format("cannot start a process: {}", std::strerror(errno)));
    }
  }
  ~Writer() {
    ::close(pipe_);
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      static_cast<void>(Wait());
    }
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  int pipe() const { return pipe_; }

  // How it ended; waits until it has.
  ExitStatus Wait() {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    if (WIFSIGNALED(status)) return {0, WTERMSIG(status)};
    return {WEXITSTATUS(status), 0};
  }

  bool HasEnded() const {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == pid_;
  }

 private:
  static std::vector<char*> Pointers(const std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    return pointers;
  }

  // In the child: only calls that a signal's handler may make, too.
  [[noreturn]] static void Become(pid_t parent, int end, char* const* argv, char* const* envp) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(127);  // it has ended meanwhile
    if (end == kSceneDescriptor) {
      ::fcntl(end, F_SETFD, 0);
    } else {
      ::dup2(end, kSceneDescriptor);
    }
    ::execve(argv[0], argv, envp);
    ::_exit(127);
  }

  pid_t pid_ = -1;
  int pipe_ = -1;
};

std::string FindPython() {
  if (std::string found = FindInPath("python3"); !found.empty()) return found;
  throw Error("builder scripts need python3, which is nowhere in PATH; install it");
}

// Our environment with these variables in place of those of the same name.
std::vector<std::string> With(const std::vector<std::string>& changes) {
  std::vector<std::string> all = changes;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const std::string name = text.substr(0, text.find('=') + 1);
    const bool changed =
        std::any_of(changes.begin(), changes.end(),
                    [&](const std::string& change) { return change.starts_with(name); });
    if (!changed) all.push_back(text);
  }
  return all;
}

std::vector<std::string> ScriptEnvironment(const ScriptOptions& options) {
  // Ours comes first, before what a caller adds and before a package morse of Debian's.
  std::string path = FindPythonFolder();
  std::vector<std::string> changes;
  const std::string name = "PYTHONPATH=";
  bool given = false;
  for (const std::string& change : options.environment) {
    if (change.starts_with(name)) {
      path += ":" + change.substr(name.size());
      given = true;
    } else {
      changes.push_back(change);
    }
  }
  const char* const users = std::getenv("PYTHONPATH");
  if (!given && users != nullptr && *users != '\0') path += std::string(":") + users;
  changes.push_back(name + path);
  changes.push_back(fmt::format("CCMORSE_SCENE_FD={}", kSceneDescriptor));
  changes.emplace_back("PYTHONDONTWRITEBYTECODE=1");  // what is installed may not be ours to write
  return With(changes);
}

// All that the script writes, until it has ended.
std::string ReadScene(const std::string& file, Writer& script, double time_limit) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(time_limit);
  std::string text;
  std::array<char, 65536> chunk{};
  for (;;) {
    // What the script has left running may keep the pipe open, so its end counts, too.
    const bool ended = script.HasEnded();
    pollfd ready{script.pipe(), POLLIN, 0};
    const int count = ::poll(&ready, 1, ended ? 0 : 50);
    if (count < 0 && errno != EINTR) {
      throw Error(fmt::format("cannot read the scene of {}: {}", file, std::strerror(errno)));
    }
    if (count > 0) {
      const ssize_t size = ::read(script.pipe(), chunk.data(), chunk.size());
      if (size == 0) return text;
      if (size > 0) text.append(chunk.data(), static_cast<std::size_t>(size));
      if (text.size() > kMostBytes) {
        throw Error(fmt::format("{} makes a scene of more than {} MiB", file, kMostBytes >> 20));
      }
    } else if (ended) {
      return text;
    }
    if (Clock::now() > deadline) {
      throw Error(
          fmt::format("{} has not ended after {} s: a builder script describes a scene and "
                      "ends; the simulation runs after it",
                      file, time_limit));
    }
  }
}

void AddNotes(const Json& notes, std::vector<scene::FileNote>& to) {
  for (const Json& note : notes.AsArray()) {
    to.push_back({{note.Find("file")->AsString(), static_cast<int>(note.Find("line")->AsInt())},
                  note.Find("text")->AsString(),
                  note.Find("matters")->AsBool()});
  }
}

}  // namespace

bool IsBuilderScript(const std::string& file) {
  const fs::path ending = fs::path(file).extension();
  if (!ending.empty()) return ending == ".py";
  std::ifstream text(file);
  char first = '{';
  return static_cast<bool>(text >> first) && first != '{';
}

scene::ImportedScenario ImportScene(const std::string& name,
                                    const std::vector<std::string>& arguments) {
  const std::string file = scene::FindScenario(name);
  if (IsBuilderScript(file)) {
    ScriptOptions options;
    options.arguments = arguments;
    return SceneFromScript(file, options);
  }
  if (!arguments.empty()) {
    throw Error("what follows " + name +
                " would be for a builder script (.py), which it is not: " + arguments.front());
  }
  return scene::ImportScenario(file);
}

std::string FindPythonFolder() {
  std::error_code ignored;
  const fs::path program = OwnProgram();
  const std::array<fs::path, 3> folders = {program.parent_path() / "../share/ccmorse/python",
                                           CCMORSE_SOURCE_PYTHON, CCMORSE_INSTALL_PYTHON};
  std::string looked;
  for (const fs::path& folder : folders) {
    if (fs::exists(folder / "morse/builder/run.py", ignored)) {
      return fs::weakly_canonical(folder, ignored).string();
    }
    looked += (looked.empty() ? "" : ", ") + folder.lexically_normal().string();
  }
  throw Error("builder scripts need CCMorse's package morse; looked in " + looked);
}

scene::ImportedScenario SceneFromScript(const std::string& file, const ScriptOptions& options) {
  if (::access(file.c_str(), R_OK) != 0) {
    throw Error(fmt::format("cannot read {}: {}", file, std::strerror(errno)));
  }
  std::vector<std::string> command = {FindPython(), "-m", "morse.builder.run", file};
  command.insert(command.end(), options.arguments.begin(), options.arguments.end());
  Writer script(command, ScriptEnvironment(options));
  const std::string text = ReadScene(file, script, options.time_limit);
  const ExitStatus status = script.Wait();
  if (!status.ok()) {
    throw Error(fmt::format("{} makes no scene: {}", file, status.Text()));
  }
  scene::ImportedScenario imported;
  Json result;
  try {
    result = Json::Parse(text);
  } catch (const JsonError& error) {
    throw Error(fmt::format("{} makes no scene: {}", file, error.what()));
  }
  const Json* const scene = result.Find("scene");
  if (scene == nullptr) throw Error(fmt::format("{} makes no scene", file));
  try {
    imported.scenario = scene::ParseScenario(scene->Dump(), file);
  } catch (const Error& error) {
    // All of the scene is on one line, which nobody has written: its number would mislead.
    const std::string text_of_error = error.what();
    const std::string line = file + ":1: ";
    if (!text_of_error.starts_with(line)) throw;
    throw Error(file + ": " + text_of_error.substr(line.size()));
  }
  AddNotes(*result.Find("notes"), imported.notes);
  return imported;
}

}  // namespace ccmorse::tools
