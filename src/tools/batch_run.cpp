#include "tools/batch_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <csignal>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "tools/batch_results.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kStderrKept = 2000;  // bytes of a program's last words in its result
// How long a simulator may take to end that was asked to: it gives its clients 2 s.
constexpr auto kLongestEnd = std::chrono::seconds(20);
constexpr std::string_view kListens = "MORSE services on 127.0.0.1 port ";

void ReplaceAll(std::string& text, std::string_view what, std::string_view with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
}

void KeepLast(std::string& text, std::size_t most) {
  if (text.size() > most) text.erase(0, text.size() - most);
}

// The port of "MORSE services on 127.0.0.1 port N\n"; 0 as long as that was not said.
int PortIn(const std::string& text) {
  const std::size_t at = text.find(kListens);
  if (at == std::string::npos || text.find('\n', at) == std::string::npos) return 0;
  int port = 0;
  std::from_chars(text.data() + at + kListens.size(), text.data() + text.size(), port);
  return port;
}

// The last line that is not empty.
std::string LastLine(const std::string& text) {
  const std::size_t end = text.find_last_not_of("\r\n");
  if (end == std::string::npos) return "";
  const std::size_t begin = text.find_last_of('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1,
                     end - (begin == std::string::npos ? std::string::npos : begin));
}

}  // namespace

BatchRun::BatchRun(const BatchJob& job, const Options& options)
    : job_(job),
      options_(options),
      report_(options.folder + "/.report.json"),
      log_(options.folder + "/log.txt", options.longest_log),
      started_(Clock::now()),
      deadline_(started_ + std::chrono::duration_cast<Clock::duration>(
                               std::chrono::duration<double>(job.timeout))) {
  std::error_code failed;
  fs::create_directories(options_.folder, failed);
  if (failed) throw Error(fmt::format("cannot make {}: {}", options_.folder, failed.message()));
  fs::remove(report_, failed);
  ChildProcess::Options simulator;
  simulator.command = {options_.simulator, "run", job_.scenario_file, "--headless", "--pace",
                       job_.program.empty() ? "max" : "lockstep",
                       // A program may think as long as the job's own time limit lets it.
                       "--client-timeout", "0", "--seed", std::to_string(job_.seed.value_or(1)),
                       "--port", "0", "--stream-port", "0", "--out", options_.folder, "--report",
                       report_};
  if (options_.threads > 0) {
    simulator.command.insert(simulator.command.end(),
                             {"--threads", std::to_string(options_.threads)});
  }
  if (job_.seconds > 0.0) {
    simulator.command.insert(simulator.command.end(), {"--for", fmt::format("{}", job_.seconds)});
  }
  simulator_ = std::make_unique<ChildProcess>(simulator);
}

BatchRun::~BatchRun() {
  simulator_.reset();
  program_.reset();
  log_.Close();
  std::error_code ignored;
  fs::remove(report_, ignored);
  ::rmdir(options_.folder.c_str());  // unless something is in it
}

void BatchRun::AddPolled(std::vector<pollfd>& polled) const {
  for (const auto& process : {simulator_.get(), program_.get()}) {
    if (process == nullptr) continue;
    for (const int pipe : {process->out(), process->err()}) {
      if (pipe >= 0) polled.push_back({pipe, POLLIN, 0});
    }
  }
}

void BatchRun::TakeOutput() {
  std::string text;
  simulator_->ReadOut(text);
  if (program_ == nullptr) {  // its report at the end is read as JSON instead
    simulator_out_ += text;
    KeepLast(simulator_out_, 65536);
  }
  text.clear();
  simulator_->ReadErr(text);
  log_.Add(text);
  KeepLast(simulator_err_ += text, kStderrKept);
  if (program_ == nullptr) return;
  text.clear();
  program_->ReadOut(text);
  log_.Add(text);
  text.clear();
  program_->ReadErr(text);
  log_.Add(text);
  KeepLast(program_err_ += text, kStderrKept);
}

void BatchRun::StartProgram(int port) {
  ChildProcess::Options program;
  program.command = {job_.program_file};
  const std::string seed = std::to_string(job_.seed.value_or(1));
  for (std::string word : job_.args) {
    ReplaceAll(word, "{host}", "127.0.0.1");
    ReplaceAll(word, "{port}", std::to_string(port));
    ReplaceAll(word, "{seed}", seed);
    ReplaceAll(word, "{name}", job_.name);
    ReplaceAll(word, "{folder}", options_.folder);
    program.command.push_back(std::move(word));
  }
  program.folder = options_.start;
  program.environment = {"CCMORSE_HOST=127.0.0.1", "CCMORSE_PORT=" + std::to_string(port),
                         "CCMORSE_SEED=" + seed, "CCMORSE_JOB=" + job_.name,
                         "CCMORSE_JOB_FOLDER=" + options_.folder};
  try {
    program_ = std::make_unique<ChildProcess>(program);
  } catch (const Error& error) {  // such as a script whose interpreter is missing
    Fail(error.what());
  }
}

void BatchRun::Fail(const std::string& error) {
  if (error_.empty()) error_ = error;
}

bool BatchRun::Step() {
  // Who has ended is asked first, so that what they printed before is all there to be taken.
  const bool simulator_ended = simulator_->Status().has_value();
  const bool program_ended = program_ != nullptr && program_->Status().has_value();
  TakeOutput();
  if (Clock::now() >= deadline_) {
    if (!timed_out_ && !ending_) {
      timed_out_ = true;
      Fail(fmt::format("not over after {} s", job_.timeout));
    } else {
      Fail("the simulator did not end when it was asked to");
    }
    simulator_->Signal(SIGKILL);
    if (program_ != nullptr) program_->Signal(SIGKILL);
    deadline_ = Clock::now() + kLongestEnd;  // what was killed is over within no time
  }
  if (!job_.program.empty() && program_ == nullptr && error_.empty() && !simulator_ended) {
    if (const int port = PortIn(simulator_out_); port != 0) StartProgram(port);
  }
  // In lock-step the simulator waits for its client for ever; SIGTERM has it take in what the
  // client left behind and end.
  const bool nobody_left = program_ended || (!error_.empty() && program_ == nullptr);
  if (nobody_left && !simulator_ended && !ending_) {
    ending_ = true;
    deadline_ = Clock::now() + kLongestEnd;
    simulator_->Signal(SIGTERM);
  }
  const bool program_to_come = !job_.program.empty() && program_ == nullptr && error_.empty();
  if (!simulator_ended || (program_ != nullptr && !program_ended)) return false;
  if (program_to_come) Fail("the simulator did not start");
  wall_ = std::chrono::duration<double>(Clock::now() - started_).count();
  return true;
}

void BatchRun::ReadReport(Json& line) const {
  const Json report = Json::Parse(ReadFile(report_));
  for (const char* key : {"simulated_s", "ticks", "hash", "robots"}) {
    const Json* const value = report.Find(key);
    if (value == nullptr) throw Error(fmt::format("the simulator's report lacks '{}'", key));
    line.Set(key, *value);
  }
}

Json BatchRun::Result() {
  TakeOutput();
  log_.Close();
  Json line = JobLine(job_);
  Json outcome(Json::Object{});
  std::string no_report;
  if (!timed_out_) {
    try {
      ReadReport(outcome);
    } catch (const std::exception& error) {
      no_report = error.what();
    }
  }
  // A SIGTERM of ours may meet a simulator that has written its report and is about to go; SIGKILL
  // was ours, too, and has its error already.
  const ExitStatus& simulator = *simulator_->Status();
  const bool went_well =
      simulator.ok() || (ending_ && simulator.signal == SIGTERM && no_report.empty());
  if (!went_well && simulator.signal != SIGKILL) {
    const std::string last = LastLine(simulator_err_);
    error_ = fmt::format("the simulator: {}", last.empty() ? simulator.Text() : last);
  }
  if (program_ != nullptr && !program_->Status()->ok() && !timed_out_) {
    Fail(fmt::format("the program: {}", program_->Status()->Text()));
  }
  if (!no_report.empty()) Fail(no_report);
  line.Set("status", timed_out_ ? "timeout" : error_.empty() ? "ok" : "failed");
  for (const auto& [key, value] : outcome.AsObject()) line.Set(key, value);
  if (program_ != nullptr && !timed_out_) {
    const ExitStatus& status = *program_->Status();
    line.Set("exit_status", status.signal == 0 ? Json(status.code) : Json());
  }
  if (!error_.empty()) {
    line.Set("error", error_);
    if (!timed_out_) line.Set("stderr", program_err_);
    if (!log_.empty()) line.Set("log", options_.log);
  }
  if (options_.timing) {
    const Json* const simulated = line.Find("simulated_s");
    Json timing(Json::Object{{"wall_s", wall_}});
    if (simulated != nullptr && wall_ > 0.0) {
      timing.Set("real_time_factor", simulated->AsDouble() / wall_);
    }
    line.Set("timing", std::move(timing));
  }
  return line;
}

void BatchRun::Abandon() {
  simulator_->Signal(SIGTERM);
  if (program_ != nullptr) program_->Signal(SIGTERM);
}

}  // namespace ccmorse::tools
