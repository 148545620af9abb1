#include "tools/batch_command.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "base/error.h"
#include "tools/batch_manifest.h"
#include "tools/batch_progress.h"
#include "tools/batch_results.h"
#include "tools/batch_run.h"
#include "tools/batch_slurm.h"
#include "tools/child_process.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kMostTasksUnasked = 100;
constexpr auto kGrace = std::chrono::seconds(2);  // between SIGTERM and SIGKILL, after Ctrl-C

// The files of a batch, all absolute: RESULTS.jsonl, RESULTS.jobs/ with a folder a job, and
// RESULTS.slurm/.
struct Places {
  explicit Places(const BatchArguments& arguments) {
    manifest = fs::absolute(arguments.manifest).lexically_normal();
    out = fs::absolute(arguments.out.empty() ? manifest.stem().string() + ".results.jsonl"
                                             : arguments.out)
              .lexically_normal();
    if (!out.has_filename()) throw Error(arguments.out + " is no name of a file");
    const fs::path base = out.extension() == ".jsonl" ? fs::path(out).replace_extension() : out;
    jobs = base.string() + ".jobs";
    slurm = base.string() + ".slurm";
  }

  fs::path Part(int task, int tasks) const {
    return slurm / fmt::format("part-{}-of-{}.jsonl", task, tasks);
  }

  fs::path manifest;
  fs::path out;
  fs::path jobs;
  fs::path slurm;
};

// Task `number` of `of`, both from 1: what one element of an array does.
struct Task {
  int number = 1;
  int of = 1;
  bool Has(const BatchJob& job) const { return job.index % of == number - 1; }
};

Task ReadTask(const std::string& text) {
  Task task;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, task.number);
  const bool has_slash = first.ec == std::errc{} && first.ptr != end && *first.ptr == '/';
  const auto second = has_slash ? std::from_chars(first.ptr + 1, end, task.of) : first;
  if (!has_slash || second.ec != std::errc{} || second.ptr != end || task.number < 1 ||
      task.number > task.of) {
    throw Error(fmt::format("--task is {}, must be K/T with K from 1 to T", text));
  }
  return task;
}

void MakeFolder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw Error(fmt::format("cannot make {}: {}", folder.string(), failed.message()));
}

// What is finished according to the results file and every part there is; other tasks may be
// writing theirs.
BatchResults FinishedAnywhere(const Places& places, const std::vector<BatchJob>& jobs,
                              const std::string& manifest) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (fs::directory_iterator at(places.slurm, ignored), end; at != end; at.increment(ignored)) {
    if (at->path().extension() == ".jsonl") files.push_back(at->path());
  }
  std::sort(files.begin(), files.end());
  files.insert(files.begin(), places.out);
  BatchResults results;
  for (const fs::path& file : files) {
    if (!fs::exists(file, ignored)) continue;
    ReadResults(ReadFile(file.string()), file.string(), jobs, manifest, results);
  }
  return results;
}

bool IsOk(const Json& line) { return line.Find("status")->AsString() == "ok"; }

std::string Summary(const std::vector<BatchJob>& jobs, const BatchResults& results) {
  int ok = 0;
  int failed = 0;
  int timeouts = 0;
  for (const BatchJob& job : jobs) {
    const auto found = results.find(job.name);
    if (found == results.end()) continue;
    const std::string& status = found->second.Find("status")->AsString();
    ++(status == "ok" ? ok : status == "timeout" ? timeouts : failed);
  }
  std::string text = fmt::format("{} job{}: {} ok, {} failed, {} timed out", jobs.size(),
                                 jobs.size() == 1 ? "" : "s", ok, failed, timeouts);
  const int missing = static_cast<int>(jobs.size()) - ok - failed - timeouts;
  return missing > 0 ? text + fmt::format(", {} still to do", missing) : text;
}

// --- Running

std::atomic<int> ended_by(0);  // lock-free, so that a signal's handler may write it

extern "C" void NoteEnd(int signal) { ended_by = signal; }
extern "C" void NoteNothing(int) {}

// While it lives, signals come only inside ppoll(): the end of a child just wakes it, and Ctrl-C,
// SIGTERM and SIGHUP are noted in `ended_by`.
class SignalsInPoll {
 public:
  SignalsInPoll() {
    struct sigaction action {};
    ::sigemptyset(&action.sa_mask);
    sigset_t blocked;
    ::sigemptyset(&blocked);
    for (const int signal : {SIGCHLD, SIGINT, SIGTERM, SIGHUP}) {
      action.sa_handler = signal == SIGCHLD ? NoteNothing : NoteEnd;
      ::sigaction(signal, &action, nullptr);
      ::sigaddset(&blocked, signal);
    }
    ::sigprocmask(SIG_BLOCK, &blocked, &before_);
  }
  ~SignalsInPoll() { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }
  SignalsInPoll(const SignalsInPoll&) = delete;
  SignalsInPoll& operator=(const SignalsInPoll&) = delete;

  void Poll(std::vector<pollfd>& polled, Clock::duration longest) const {
    const auto ns = std::chrono::duration_cast<std::chrono::nanoseconds>(
        std::max(longest, Clock::duration::zero()));
    const timespec time{ns.count() / 1000000000, ns.count() % 1000000000};
    ::ppoll(polled.data(), polled.size(), &time, &before_);
  }

 private:
  sigset_t before_{};
};

class Loop {
 public:
  Loop(const BatchArguments& arguments, const Places& places, ResultsFile& results)
      : places_(places), results_(results) {
    options_.simulator = OwnProgram().string();
    options_.start = places.manifest.parent_path().string();
    options_.longest_log = static_cast<std::size_t>(arguments.log_kib) * 1024;
    options_.timing = arguments.timing;
    at_once_ = arguments.at_once > 0
                   ? arguments.at_once
                   : static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U));
    options_.threads = at_once_ > 1 ? 1 : 0;  // the cores are busy with other jobs
  }

  // True when all are done, false when a signal came before.
  bool Run(const std::vector<const BatchJob*>& todo, BatchProgress& progress) {
    const SignalsInPoll signals;
    for (std::size_t next = 0; next < todo.size() || !running_.empty();) {
      while (next < todo.size() && static_cast<int>(running_.size()) < at_once_) {
        Start(*todo[next++]);
      }
      Wait(signals, std::chrono::milliseconds(500));
      if (ended_by != 0) {
        Abandon(signals);
        return false;
      }
      TakeFinished(progress);
      progress.Show(Clock::now());
    }
    return true;
  }

 private:
  void Start(const BatchJob& job) {
    BatchRun::Options options = options_;
    options.folder = (places_.jobs / job.name).string();
    options.log = (places_.jobs.filename() / job.name / "log.txt").string();
    running_.push_back(std::make_unique<BatchRun>(job, options));
  }

  void Wait(const SignalsInPoll& signals, Clock::duration longest) const {
    std::vector<pollfd> polled;
    auto until = Clock::now() + longest;
    for (const auto& run : running_) {
      run->AddPolled(polled);
      until = std::min(until, run->deadline());
    }
    signals.Poll(polled, until - Clock::now());
  }

  void TakeFinished(BatchProgress& progress) {
    for (auto& run : running_) {
      if (!run->Step()) continue;
      const Json line = run->Result();
      results_.Add(run->job(), line);
      progress.JobOver(IsOk(line) ? "" : FailureText(line));
      run.reset();
    }
    std::erase(running_, nullptr);
  }

  // Nothing of what runs becomes a result; it gets a moment to end by itself.
  void Abandon(const SignalsInPoll& signals) {
    for (const auto& run : running_) run->Abandon();
    const auto until = Clock::now() + kGrace;
    while (!running_.empty() && Clock::now() < until) {
      Wait(signals, std::chrono::milliseconds(100));
      std::erase_if(running_, [](const auto& run) { return run->Step(); });
    }
    running_.clear();
  }

  static std::string FailureText(const Json& line) {
    const Json* const log = line.Find("log");
    return fmt::format("{}: {}: {}{}", line.Find("status")->AsString(),
                       line.Find("name")->AsString(), line.Find("error")->AsString(),
                       log == nullptr ? "" : " (" + log->AsString() + ")");
  }

  const Places& places_;
  ResultsFile& results_;
  BatchRun::Options options_;
  int at_once_ = 1;
  std::vector<std::unique_ptr<BatchRun>> running_;
};

int RunJobs(const BatchArguments& arguments, const Places& places,
            const std::vector<BatchJob>& jobs) {
  const bool is_part = !arguments.task.empty();
  const Task task = is_part ? ReadTask(arguments.task) : Task();
  const fs::path file = is_part ? places.Part(task.number, task.of) : places.out;
  MakeFolder(file.parent_path());
  ResultsFile results(file.string(), jobs, arguments.manifest);
  if (arguments.retry) results.Keep(IsOk);
  const BatchResults elsewhere =
      is_part ? FinishedAnywhere(places, jobs, arguments.manifest) : BatchResults();
  std::vector<const BatchJob*> todo;
  int mine = 0;
  for (const BatchJob& job : jobs) {
    if (!task.Has(job)) continue;
    ++mine;
    if (!results.results().contains(job.name) && !elsewhere.contains(job.name)) {
      todo.push_back(&job);
    }
  }
  const int before = mine - static_cast<int>(todo.size());
  if (before > 0 && !arguments.quiet) {
    fmt::print(stderr, "{} of {} jobs were done before\n", before, mine);
  }
  BatchProgress progress(mine, before, arguments.quiet);
  Loop loop(arguments, places, results);
  const bool all = loop.Run(todo, progress);
  progress.End();
  results.Sort();
  if (!all) {
    fmt::print(stderr, "ended by a signal; the same command goes on from here\n");
    return 128 + ended_by;
  }
  if (is_part) {
    fmt::print("{} job{} of this task done; --collect merges all\n", mine, mine == 1 ? "" : "s");
  } else {
    fmt::print("{}; results in {}\n", Summary(jobs, results.results()), places.out.string());
  }
  return 0;
}

int Collect(const BatchArguments& arguments, const Places& places,
            const std::vector<BatchJob>& jobs) {
  const BatchResults found = FinishedAnywhere(places, jobs, arguments.manifest);
  MakeFolder(places.out.parent_path());
  ResultsFile results(places.out.string(), jobs, arguments.manifest);
  for (const BatchJob& job : jobs) {
    const auto line = found.find(job.name);
    if (line == found.end() || results.results().contains(job.name)) continue;
    results.Add(job, line->second);
  }
  results.Sort();
  fmt::print("{}; results in {}\n", Summary(jobs, results.results()), places.out.string());
  return results.results().size() == jobs.size() ? 0 : 1;
}

int SubmitJobs(const BatchArguments& arguments, const Places& places,
               const std::vector<BatchJob>& jobs) {
  SlurmArray array;
  array.name = "ccmorse-batch";
  array.ccmorse = OwnProgram().string();
  array.manifest = places.manifest.string();
  array.out = places.out.string();
  array.folder = places.slurm.string();
  array.tasks = arguments.tasks > 0 ? std::min(arguments.tasks, static_cast<int>(jobs.size()))
                                    : std::min(kMostTasksUnasked, static_cast<int>(jobs.size()));
  array.at_once = std::max(arguments.at_once, 1);
  if (arguments.timing) array.words.emplace_back("--timing");
  if (arguments.log_kib != BatchArguments().log_kib) {
    array.words.insert(array.words.end(), {"--log-kib", std::to_string(arguments.log_kib)});
  }
  array.options = arguments.sbatch;
  const std::string script = SlurmScript(array);

  const BatchResults finished = FinishedAnywhere(places, jobs, arguments.manifest);
  std::vector<int> tasks;
  for (int number = 1; number <= array.tasks; ++number) {
    const Task task{number, array.tasks};
    const bool has_work = std::any_of(jobs.begin(), jobs.end(), [&](const BatchJob& job) {
      return task.Has(job) && !finished.contains(job.name);
    });
    if (has_work) tasks.push_back(number);
  }
  if (tasks.empty()) {
    fmt::print("all {} jobs have results; --collect merges them\n", jobs.size());
    return 0;
  }
  const std::string file = (places.slurm / "job.sh").string();
  if (arguments.dry_run) {
    fmt::print("{}# sbatch --array={} {}\n", script, TaskList(tasks), ShellWord(file));
    return 0;
  }
  MakeFolder(places.slurm);
  if (std::ofstream out(file); !(out << script) || !out.flush()) {
    throw Error("cannot write " + file);
  }
  const std::string job = Submit(file, tasks);
  fmt::print(
      "Slurm job {}: {} task{} for {} jobs; when they are done: ccmorse batch {} --out {} "
      "--collect\n",
      job, tasks.size(), tasks.size() == 1 ? "" : "s", jobs.size() - finished.size(),
      ShellWord(arguments.manifest), ShellWord(places.out.string()));
  return 0;
}

}  // namespace

int Batch(const BatchArguments& arguments) {
  const Places places(arguments);
  const std::vector<BatchJob> jobs = LoadManifest(arguments.manifest);
  if (arguments.slurm || arguments.dry_run) return SubmitJobs(arguments, places, jobs);
  if (arguments.collect) return Collect(arguments, places, jobs);
  return RunJobs(arguments, places, jobs);
}

}  // namespace ccmorse::tools
