#include "tools/grade_run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "grade/judge.h"
#include "grade/worlds.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;

constexpr int kPort = 4000;  // within the sandbox: the course's own
constexpr std::string_view kListens = "MORSE services on 127.0.0.1 port ";
constexpr double kLargestRecord = 100e6;  // bytes that a run may make the simulator write
constexpr auto kStart = std::chrono::seconds(20);
constexpr auto kEnd = std::chrono::seconds(20);
constexpr std::size_t kWords = 1500;

void WriteFile(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  if (!(file << text) || !file.flush()) throw Error("cannot write " + path);
}

int PortIn(const std::string& text) {
  const std::size_t at = text.find(kListens);
  if (at == std::string::npos || text.find('\n', at) == std::string::npos) return 0;
  int port = 0;
  std::from_chars(text.data() + at + kListens.size(), text.data() + text.size(), port);
  return port;
}

void KeepLast(std::string& text, std::size_t most) {
  if (text.size() > most) text.erase(0, text.size() - most);
}

void Put(std::string& text, std::string_view what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
}

}  // namespace

GradeRun::GradeRun(const grade::Rubric& rubric, std::uint64_t seed, const Submission& submission,
                   const Options& options)
    : rubric_(rubric), seed_(seed), submission_(submission), options_(options) {
  fs::create_directories(options_.folder + "/pictures");
  const scene::Scenario scenario = grade::MakeWorld(rubric, seed);
  world_ = options_.folder + "/world.json";
  WriteFile(world_, scene::ToJson(scenario).Dump());
  const std::string map = options_.folder + "/map.txt";
  WriteFile(map, grade::MapText(grade::PlannersMap(scenario.world)));
  WriteFile(options_.folder + "/hosts", "127.0.0.1 localhost sandbox\n");
  const auto route = grade::DrawRoute(scenario);
  const auto cell = [&](int value) { return std::to_string(route ? value : 0); };
  const bool sandbox = options_.sandbox;
  const std::string given = rubric.worlds[seed % rubric.worlds.size()].scenario;
  for (std::string word : rubric.arguments) {
    Put(word, "{host}", "127.0.0.1");
    Put(word, "{seed}", std::to_string(seed));
    Put(word, "{scenario}", sandbox ? "/task/scenario.json" : given);
    Put(word, "{map}", sandbox ? "/task/map.txt" : map);
    Put(word, "{start_x}", cell(route ? route->start.x : 0));
    Put(word, "{start_y}", cell(route ? route->start.y : 0));
    Put(word, "{goal_x}", cell(route ? route->goal.x : 0));
    Put(word, "{goal_y}", cell(route ? route->goal.y : 0));
    if (sandbox) Put(word, "{port}", std::to_string(kPort));
    arguments_.push_back(std::move(word));
  }
  deadline_ = Clock::now() + kStart;
  next_look_ = Clock::now();
  if (sandbox) {
    StartSandbox();
  } else {
    StartSimulator(-1);
  }
}

void GradeRun::StartSandbox() {
  SandboxOptions options;
  options.command = {submission_.within + "/" + rubric_.program};
  options.command.insert(options.command.end(), arguments_.begin(), arguments_.end());
  options.folder = submission_.within;
  options.read_only = submission_.shown;
  options.read_only.emplace_back(submission_.folder, submission_.within);
  options.read_only.emplace_back(options_.folder + "/map.txt", "/task/map.txt");
  options.read_only.emplace_back(rubric_.worlds[seed_ % rubric_.worlds.size()].scenario,
                                 "/task/scenario.json");
  options.read_only.emplace_back(options_.folder + "/hosts", "/etc/hosts");
  options.variables = {{"LD_LIBRARY_PATH", "/ccmorse/lib"},
                       {"CCMORSE_HOST", "127.0.0.1"},
                       {"CCMORSE_PORT", std::to_string(kPort)}};
  options.port = kPort;
  options.limits.cpu_s = rubric_.limits.cpu_s;
  options.limits.memory_mb = rubric_.limits.memory_mb;
  options.limits.processes = rubric_.limits.processes;
  sandbox_ = std::make_unique<Sandbox>(options);
}

void GradeRun::StartSimulator(int listener) {
  ChildProcess::Options simulator;
  simulator.command = {options_.simulator,
                       "run",
                       world_,
                       "--headless",
                       "--contest",
                       "--pace",
                       "lockstep",
                       "--client-timeout",
                       "0",
                       "--seed",
                       std::to_string(seed_),
                       "--no-player",
                       "--stream-port",
                       "0",
                       "--port",
                       "0",
                       "--threads",
                       "1",
                       "--out",
                       options_.folder + "/pictures",
                       "--record",
                       options_.record,
                       "--record-data",
                       "poses",
                       "--hash-every",
                       "60",
                       "--for",
                       fmt::format("{}", rubric_.seconds)};
  if (listener >= 0) {
    simulator.command.insert(simulator.command.end(),
                             {"--listen-socket", std::to_string(listener)});
    simulator.handed = {listener};
  }
  simulator_ = std::make_unique<ChildProcess>(simulator);
}

void GradeRun::StartProgram(int port) {
  started_ = true;
  deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(rubric_.limits.wall_s));
  if (sandbox_ != nullptr) return sandbox_->Go();
  ChildProcess::Options program;
  program.command = {submission_.program};
  for (std::string word : arguments_) {
    Put(word, "{port}", std::to_string(port));
    program.command.push_back(std::move(word));
  }
  program.folder = submission_.folder;
  try {
    program_ = std::make_unique<ChildProcess>(program);
  } catch (const Error& error) {
    program_over_ = true;
    Fail(error.what());
  }
}

ChildProcess* GradeRun::Program() const {
  return sandbox_ != nullptr ? &sandbox_->process() : program_.get();
}

void GradeRun::AddPolled(std::vector<pollfd>& polled) const {
  for (const ChildProcess* process : {simulator_.get(), static_cast<ChildProcess*>(Program())}) {
    if (process == nullptr) continue;
    for (const int pipe : {process->out(), process->err()}) {
      if (pipe >= 0) polled.push_back({pipe, POLLIN, 0});
    }
  }
  if (sandbox_ != nullptr && !program_over_) polled.push_back({sandbox_->channel(), POLLIN, 0});
}

void GradeRun::TakeOutput() {
  if (simulator_ != nullptr) {
    simulator_->ReadOut(simulator_out_);
    if (started_) KeepLast(simulator_out_, 4096);
    simulator_->ReadErr(simulator_err_);
    KeepLast(simulator_err_, 4096);
  }
  if (Program() == nullptr) return;
  std::string text;
  Program()->ReadOut(text);
  Program()->ReadErr(text);
  printed_ += static_cast<double>(text.size());
  program_words_ += text;
  KeepLast(program_words_, kWords);
}

void GradeRun::Fail(const std::string& why) {
  if (failure_.empty()) failure_ = why;
  if (Program() != nullptr) Program()->Signal(SIGKILL);
}

void GradeRun::LookAtProgram() {
  if (program_over_) return;
  if (sandbox_ != nullptr) {
    sandbox_->Step();
    if (!sandbox_->Over()) return;
    sandbox_->Step();
    program_over_ = true;
    if (!sandbox_->end()) {
      if (grace_) return;
      Fail("the sandbox ended: " + LastWords(program_words_, 300));
      return;
    }
    const SandboxMessage& end = *sandbox_->end();
    cpu_s_ = end.cpu_s;
    memory_mb_ = end.memory_mb;
    // Who is killed because the time of the run is over has not crashed.
    if (grace_ && end.kind == SandboxMessage::kKilled) return;
    const std::string why = FailureOf(
        end, {rubric_.limits.cpu_s, rubric_.limits.memory_mb, rubric_.limits.processes, 64.0});
    if (!why.empty()) Fail(why);
    if (end.kind == SandboxMessage::kExited && end.number != 0) {
      note_ = fmt::format("the program ended with exit status {}", end.number);
    }
  } else if (program_ != nullptr && program_->Status()) {
    program_over_ = true;
    const ExitStatus& status = *program_->Status();
    if (status.signal != 0 && !grace_) Fail("the program crashed: " + status.Text());
    if (status.signal == 0 && status.code != 0) {
      note_ = "the program ended with " + status.Text();
    }
  }
}

bool GradeRun::Step() {
  LookAtProgram();
  simulator_over_ = simulator_ != nullptr && simulator_->Status().has_value();
  TakeOutput();
  const auto now = Clock::now();
  if (sandbox_ != nullptr && simulator_ == nullptr && failure_.empty()) {
    if (const int listener = sandbox_->TakeListener(); listener >= 0) {
      StartSimulator(listener);
      ::close(listener);
    }
  }
  if (!started_ && simulator_ != nullptr && failure_.empty() && !simulator_over_) {
    if (const int port = PortIn(simulator_out_); port != 0) StartProgram(port);
  }
  if (!started_ && simulator_over_) Fail("the simulator failed: " + LastWords(simulator_err_, 300));
  if (!program_over_ && printed_ > rubric_.limits.output_mb * 1e6) {
    Fail(fmt::format("the program printed more than {} MB", rubric_.limits.output_mb));
  }
  if (started_ && now >= next_look_) {
    next_look_ = now + std::chrono::milliseconds(200);
    std::error_code none;
    const auto record = fs::file_size(options_.record, none);
    const double bytes =
        (none ? 0.0 : static_cast<double>(record)) + FolderBytes(options_.folder + "/pictures");
    if (bytes > kLargestRecord) {
      Fail(
          fmt::format("the program flooded the simulator: its calls made a record of more than "
                      "{:.0f} MB",
                      kLargestRecord / 1e6));
    }
  }
  if (now >= deadline_) {
    if (ending_) {
      if (simulator_ != nullptr) simulator_->Signal(SIGKILL);
    } else if (grace_) {
      Program()->Signal(SIGKILL);  // it had its time, and a moment more
    } else {
      Fail(started_ ? fmt::format("the program was not over after {} s of wall-clock time",
                                  rubric_.limits.wall_s)
                    : "the sandbox or the simulator did not start: " +
                          LastWords(program_words_ + simulator_err_, 300));
    }
    deadline_ = now + kEnd;
  }
  // Once nobody is left the simulator takes in what was sent, and ends its record.
  const bool program_gone = program_over_ || (!started_ && !failure_.empty());
  if (program_gone && simulator_ != nullptr && !simulator_over_ && !ending_) {
    ending_ = true;
    deadline_ = now + kEnd;
    simulator_->Signal(SIGTERM);
  }
  if (simulator_over_ && !program_gone && !grace_) {
    grace_ = true;  // simulated time is over; the program may tidy up
    deadline_ = std::min(deadline_, now + std::chrono::seconds(5));
  }
  return program_gone && (simulator_ == nullptr || simulator_over_);
}

grade::RunReport GradeRun::Report() {
  grade::RunReport report;
  report.seed = seed_;
  report.failure = failure_;
  report.note = note_;
  report.cpu_s = cpu_s_;
  report.memory_mb = memory_mb_;
  if (!program_words_.empty() && (!failure_.empty() || !note_.empty())) {
    report.note += (note_.empty() ? "its last words: " : "; its last words: ") +
                   LastWords(program_words_, 400);
  }
  std::error_code none;
  if (!fs::exists(options_.record, none)) {
    if (report.failure.empty()) report.failure = "there is no record of the run";
    return report;
  }
  // Of a run that counts nothing the judgement is only for the picture.
  constexpr std::uintmax_t kWorthIt = 20'000'000;
  if (!report.failure.empty() && fs::file_size(options_.record, none) > kWorthIt) return report;
  try {
    report.judgement = grade::Judge(rubric_, options_.record);
  } catch (const Error& error) {
    if (report.failure.empty()) report.failure = error.what();
  }
  if (report.failure.empty() && report.judgement) report.failure = report.judgement->refused;
  return report;
}

}  // namespace ccmorse::tools
