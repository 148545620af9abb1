#include "tools/grade_command.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "base/error.h"
#include "grade/judge.h"
#include "grade/report.h"
#include "grade/rubric.h"
#include "tools/batch_progress.h"
#include "tools/batch_results.h"
#include "tools/child_process.h"
#include "tools/grade_run.h"
#include "tools/sandbox.h"
#include "tools/submission.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

std::atomic<int> ended_by(0);  // lock-free, so that a signal's handler may write it

extern "C" void NoteEndOfGrading(int signal) { ended_by = signal; }

// From now on Ctrl-C, SIGTERM and SIGHUP are noted, so that what was started can be ended.
void NoteSignals() {
  struct sigaction action {};
  ::sigemptyset(&action.sa_mask);
  action.sa_handler = NoteEndOfGrading;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(signal, &action, nullptr);
  ::signal(SIGPIPE, SIG_IGN);
}

void WriteText(const std::string& path, const std::string& text) {
  const fs::path folder = fs::path(path).parent_path();
  std::error_code failed;
  if (!folder.empty()) fs::create_directories(folder, failed);
  std::ofstream file(path, std::ios::binary);
  if (!(file << text) || !file.flush()) {
    throw Error("cannot write " + path + ": " + std::strerror(errno));
  }
}

// A folder of our own that goes with the object, whatever a submission has made of it.
class WorkFolder {
 public:
  WorkFolder() {
    std::string path = (fs::temp_directory_path() / "ccmorse-grade-XXXXXX").string();
    if (::mkdtemp(path.data()) == nullptr) {
      throw Error("cannot make " + path + ": " + std::strerror(errno));
    }
    path_ = path;
  }
  ~WorkFolder() {
    std::error_code failed;
    fs::remove_all(path_, failed);
    if (!failed) return;
    // Folders that nobody may enter can be opened up by their owner.
    for (fs::recursive_directory_iterator at(path_, failed), end; at != end; at.increment(failed)) {
      std::error_code ignored;
      if (at->is_directory(ignored)) fs::permissions(at->path(), fs::perms::owner_all, ignored);
      if (failed) break;
    }
    fs::remove_all(path_, failed);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

void WaitFor(std::vector<pollfd>& polled) { ::poll(polled.data(), polled.size(), 50); }

int AtOnce(int asked, std::size_t jobs) {
  const int cores = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U));
  return std::min(asked > 0 ? asked : cores, std::max(static_cast<int>(jobs), 1));
}

// Runs all seeds, several at a time, and judges each run when it is over.
std::vector<grade::RunReport> RunAll(const GradeArguments& arguments, const grade::Rubric& rubric,
                                     const Submission& submission, const std::string& folder) {
  const std::string kept = arguments.keep_records;
  if (!kept.empty()) fs::create_directories(kept);
  const auto seeds = static_cast<std::size_t>(arguments.seeds);
  std::vector<grade::RunReport> reports(seeds);
  std::vector<std::pair<std::size_t, std::unique_ptr<GradeRun>>> running;
  BatchProgress progress(arguments.seeds, 0, arguments.quiet);
  const auto at_once = static_cast<std::size_t>(AtOnce(arguments.at_once, seeds));
  for (std::size_t next = 0; next < seeds || !running.empty();) {
    while (next < seeds && running.size() < at_once) {
      const auto seed = static_cast<std::uint64_t>(arguments.first_seed) + next;
      GradeRun::Options options;
      options.simulator = OwnProgram().string();
      options.folder = fmt::format("{}/run-{}", folder, seed);
      options.record =
          kept.empty() ? options.folder + "/run.mcap" : fmt::format("{}/world-{}.mcap", kept, seed);
      options.sandbox = !arguments.no_sandbox;
      running.emplace_back(next, std::make_unique<GradeRun>(rubric, seed, submission, options));
      ++next;
    }
    std::vector<pollfd> polled;
    for (const auto& [index, run] : running) run->AddPolled(polled);
    WaitFor(polled);
    if (ended_by != 0) break;
    for (auto& [index, run] : running) {
      if (!run->Step()) continue;
      reports[index] = run->Report();
      if (!kept.empty()) {
        reports[index].record = fmt::format("{}/world-{}.mcap", kept, reports[index].seed);
      }
      run.reset();
      std::error_code ignored;
      fs::remove_all(fmt::format("{}/run-{}", folder, reports[index].seed), ignored);
      progress.JobOver("");
    }
    std::erase_if(running, [](const auto& entry) { return entry.second == nullptr; });
    progress.Show(Clock::now());
  }
  progress.End();
  return reports;
}

int Hand(const GradeArguments& arguments, const grade::Rubric& rubric,
         const grade::Grading& grading) {
  const std::string json = grade::GradingJson(rubric, grading).Dump() + "\n";
  if (!arguments.report.empty()) WriteText(arguments.report, grade::GradingPage(rubric, grading));
  if (arguments.json == "-") {
    fmt::print("{}", json);
  } else {
    if (!arguments.json.empty()) WriteText(arguments.json, json);
    fmt::print("{}", grade::GradingTable(rubric, grading));
    if (!arguments.report.empty()) fmt::print("report {}\n", arguments.report);
  }
  return grading.score() >= rubric.pass ? 0 : kNotPassed;
}

int GradeOne(const GradeArguments& arguments) {
  const CourseFiles course = FindCourseFiles(arguments.task);
  const grade::Rubric rubric = grade::LoadRubric(course.task + "/rubric.json");
  grade::Grading grading;
  grading.sandboxed = !arguments.no_sandbox;
  if (!arguments.record.empty()) {
    grading.submission = arguments.submission.empty() ? arguments.record : arguments.submission;
    grade::RunReport run;
    run.judgement = grade::Judge(rubric, arguments.record);
    run.seed = run.judgement->seed;
    run.failure = run.judgement->refused;
    run.record = arguments.record;
    grading.runs.push_back(std::move(run));
    return Hand(arguments, rubric, grading);
  }
  if (!fs::exists(arguments.submission)) {
    throw Error("there is no submission " + arguments.submission);
  }
  if (!arguments.no_sandbox) RequireSandbox();
  NoteSignals();
  const WorkFolder work;
  const Submission submission = BuildSubmission(arguments.submission, rubric, course,
                                                work.path() + "/submission", !arguments.no_sandbox);
  grading.submission = submission.name;
  grading.build_failure = submission.failure;
  if (!submission.failure.empty()) {
    grading.build_output = submission.output;
  } else if (ended_by == 0) {
    grading.runs = RunAll(arguments, rubric, submission, work.path());
  }
  if (ended_by != 0) return 128 + ended_by;
  return Hand(arguments, rubric, grading);
}

// --- A class

// The submissions of a class as jobs, so that results are kept, and found again, as a batch's are.
std::vector<BatchJob> ClassJobs(const GradeArguments& arguments, const std::string& task) {
  std::vector<BatchJob> jobs;
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(arguments.class_folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(".")) entries.push_back(entry.path());
  }
  std::sort(entries.begin(), entries.end());
  for (const fs::path& entry : entries) {
    std::error_code ignored;
    const bool program = fs::is_regular_file(entry, ignored) && ::access(entry.c_str(), X_OK) == 0;
    if (!program && !fs::is_directory(entry, ignored)) continue;
    BatchJob job;
    job.index = static_cast<int>(jobs.size());
    job.name = entry.filename().string();
    job.scenario = task;
    job.scenario_file = task;
    job.program = entry.string();
    job.program_file = fs::absolute(entry).lexically_normal().string();
    job.args = {"--seeds", std::to_string(arguments.seeds), "--first-seed",
                std::to_string(arguments.first_seed)};
    job.seed = arguments.first_seed;
    jobs.push_back(std::move(job));
  }
  if (jobs.empty()) throw Error("there are no submissions in " + arguments.class_folder);
  return jobs;
}

// One submission under way, graded by a `ccmorse grade` of its own, so that nothing it does to its
// grader reaches the others.
struct ClassRun {
  const BatchJob* job = nullptr;
  std::string digest;  // of what it is graded by
  std::string folder;
  std::unique_ptr<ChildProcess> process;
  std::string out;
  std::string err;
};

Json LineOf(const ClassRun& run) {
  Json line = JobLine(*run.job);
  line.Set("digest", run.digest);
  const ExitStatus& status = *run.process->Status();
  const bool graded = status.signal == 0 && (status.code == 0 || status.code == kNotPassed);
  line.Set("status", graded ? "ok" : "failed");
  if (graded) {
    try {
      const Json result = Json::Parse(ReadFile(run.folder + "/grade.json"));
      for (const char* key : {"score", "passed", "build_failure", "criteria"}) {
        line.Set(key, *result.Find(key));
      }
      for (const Json& each : result.Find("runs")->AsArray()) {
        const std::string& failure = each.Find("failure")->AsString();
        if (!failure.empty() && line.Find("problem") == nullptr) line.Set("problem", failure);
      }
      return line;
    } catch (const std::exception& error) {
      line.Set("status", "failed");
      line.Set("error", std::string("its result cannot be read: ") + error.what());
      return line;
    }
  }
  line.Set("error", LastWords(run.err.empty() ? status.Text() : run.err, 500));
  return line;
}

grade::ClassEntry EntryOf(const Json& line) {
  grade::ClassEntry entry;
  entry.submission = line.Find("name")->AsString();
  if (const Json* const score = line.Find("score"); score != nullptr) {
    entry.score = score->AsDouble();
    entry.passed = line.Find("passed")->AsBool();
    for (const Json& each : line.Find("criteria")->AsArray()) {
      entry.points.push_back(each.Find("points")->AsDouble());
    }
  }
  for (const char* key : {"error", "build_failure", "problem"}) {
    const Json* const text = line.Find(key);
    if (text != nullptr && text->IsString() && entry.problem.empty()) {
      entry.problem = text->AsString();
    }
  }
  return entry;
}

int GradeClass(const GradeArguments& arguments) {
  if (!fs::is_directory(arguments.class_folder)) {
    throw Error("there is no folder " + arguments.class_folder);
  }
  const CourseFiles course = FindCourseFiles(arguments.task);
  const grade::Rubric rubric = grade::LoadRubric(course.task + "/rubric.json");
  if (!arguments.no_sandbox) RequireSandbox();
  NoteSignals();
  fs::path clean = fs::path(arguments.class_folder).lexically_normal();
  if (clean.filename().empty()) clean = clean.parent_path();
  const std::string out =
      arguments.out.empty() ? clean.filename().string() + "-grades" : arguments.out;
  fs::create_directories(out);
  const std::vector<BatchJob> jobs = ClassJobs(arguments, course.task);
  ResultsFile results(out + "/results.jsonl", jobs, arguments.class_folder);
  std::map<std::string, std::string> digests;
  for (const BatchJob& job : jobs) {
    try {
      digests[job.name] = DigestOf(job.program_file, rubric);
    } catch (const std::exception&) {
      digests[job.name] = "";  // its own grader will say why it cannot be read
    }
  }
  // Who has handed in anew is graded anew, and so are all with another rubric.
  const std::size_t known = results.results().size();
  results.Keep([&digests](const Json& line) {
    const Json* const digest = line.Find("digest");
    return digest != nullptr && digest->IsString() && !digest->AsString().empty() &&
           digest->AsString() == digests.at(line.Find("name")->AsString());
  });
  std::vector<const BatchJob*> todo;
  for (const BatchJob& job : jobs) {
    if (!results.results().contains(job.name)) todo.push_back(&job);
  }
  const int before = static_cast<int>(jobs.size() - todo.size());
  if (known > 0 && !arguments.quiet) {
    fmt::print(stderr, "{} of {} submissions were graded before", before, jobs.size());
    if (known > results.results().size()) {
      fmt::print(stderr, ", {} have changed since then, or the task has",
                 known - results.results().size());
    }
    fmt::print(stderr, "\n");
  }
  BatchProgress progress(static_cast<int>(jobs.size()), before, arguments.quiet);
  std::vector<ClassRun> running;
  const auto at_once = static_cast<std::size_t>(AtOnce(arguments.at_once, todo.size()));
  for (std::size_t next = 0; next < todo.size() || !running.empty();) {
    while (next < todo.size() && running.size() < at_once) {
      ClassRun run;
      run.job = todo[next++];
      run.digest = digests.at(run.job->name);
      run.folder = out + "/" + run.job->name;
      ChildProcess::Options options;
      options.command = {OwnProgram().string(), "grade", course.task, run.job->program_file};
      options.command.insert(options.command.end(), run.job->args.begin(), run.job->args.end());
      options.command.insert(
          options.command.end(),
          {"--quiet", "-j", "1", "--json", run.folder + "/grade.json", "--report",
           run.folder + "/report.html", "--keep-records", run.folder + "/records"});
      if (arguments.no_sandbox) options.command.emplace_back("--no-sandbox");
      run.process = std::make_unique<ChildProcess>(options);
      running.push_back(std::move(run));
    }
    std::vector<pollfd> polled;
    for (const ClassRun& run : running) {
      for (const int pipe : {run.process->out(), run.process->err()}) {
        if (pipe >= 0) polled.push_back({pipe, POLLIN, 0});
      }
    }
    WaitFor(polled);
    if (ended_by != 0) break;
    for (ClassRun& run : running) {
      const bool over = run.process->Status().has_value();
      run.process->ReadOut(run.out);
      run.process->ReadErr(run.err);
      run.out.clear();
      if (run.err.size() > 8192) run.err.erase(0, run.err.size() - 4096);
      if (!over) continue;
      const Json line = LineOf(run);
      results.Add(*run.job, line);
      const Json* const error = line.Find("error");
      progress.JobOver(error == nullptr ? "" : run.job->name + ": " + error->AsString());
      run.process.reset();
    }
    std::erase_if(running, [](const ClassRun& run) { return run.process == nullptr; });
    progress.Show(Clock::now());
  }
  progress.End();
  if (ended_by != 0) {
    fmt::print(stderr, "ended by a signal; the same command goes on from here\n");
    for (ClassRun& run : running) run.process->Signal(SIGTERM);
    const auto until = Clock::now() + std::chrono::seconds(5);
    for (ClassRun& run : running) {
      while (!run.process->Status() && Clock::now() < until) ::usleep(20000);
    }
    return 128 + ended_by;
  }
  results.Sort();
  std::vector<grade::ClassEntry> entries;
  for (const auto& [name, line] : results.results()) entries.push_back(EntryOf(line));
  WriteText(out + "/class.csv", grade::ClassCsv(rubric, entries));
  WriteText(out + "/class.html", grade::ClassPage(rubric, entries));
  const auto passed =
      std::count_if(entries.begin(), entries.end(), [](const auto& entry) { return entry.passed; });
  fmt::print("{} submissions, {} passed; {}/class.html and class.csv\n", entries.size(), passed,
             out);
  return 0;
}

}  // namespace

int Grade(const GradeArguments& arguments) {
  return arguments.class_folder.empty() ? GradeOne(arguments) : GradeClass(arguments);
}

}  // namespace ccmorse::tools
