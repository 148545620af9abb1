#include "tools/submission.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>

#include "base/error.h"
#include "base/nearest_name.h"
#include "sim/state_hash.h"
#include "tools/child_process.h"
#include "tools/sandbox.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kLargestSubmission = 64e6;  // bytes
constexpr double kLargestBuild = 256e6;      // bytes
constexpr int kMostFiles = 2000;
constexpr double kBuildTime = 120.0;  // s of wall-clock time
constexpr std::size_t kBuildWords = 4000;
constexpr std::size_t kBuildOutput = 4'000'000;  // bytes, more is nothing that anybody reads

bool IsFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool IsFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

std::vector<fs::path> Entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    entries.push_back(at->path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

fs::path OwnFolder() { return OwnProgram().parent_path(); }

std::vector<fs::path> CourseFolders() {
  std::vector<fs::path> folders;
  if (const char* const chosen = std::getenv("CCMORSE_COURSES"); chosen != nullptr && *chosen) {
    folders.emplace_back(chosen);
  }
  folders.push_back(OwnFolder().parent_path() / "share/ccmorse/courses");
  folders.emplace_back(CCMORSE_SOURCE_DIR "/courses");
  return folders;
}

// The folder of libCCMorse.so: of the build that this program is of, or where it is installed.
std::string FindLibraries() {
  std::vector<fs::path> folders;
  if (const char* const chosen = std::getenv("CCMORSE_LIBDIR"); chosen != nullptr && *chosen) {
    folders.emplace_back(chosen);
  }
  folders.push_back(OwnFolder().parent_path() / "lib");
  for (const fs::path& folder : Entries(OwnFolder().parent_path() / "lib")) {
    if (IsFolder(folder)) folders.push_back(folder);
  }
  for (const fs::path& folder : folders) {
    if (IsFile(folder / "libCCMorse.so")) return fs::canonical(folder).string();
  }
  throw Error("libCCMorse.so, which submissions are built with, is not in " +
              (OwnFolder().parent_path() / "lib").string() + "; set CCMORSE_LIBDIR to its folder");
}

std::string FindInclude() {
  for (const fs::path& folder :
       {OwnFolder().parent_path() / "include", fs::path(CCMORSE_SOURCE_DIR "/include")}) {
    if (IsFile(folder / "libCCMorse/CCMorse.h")) return fs::canonical(folder).string();
  }
  throw Error("CCMorse's headers, which submissions are built with, are not installed");
}

// Calls file(relative path) for each file that belongs to a submission, and folder(relative path)
// for each folder before its files. Regular files and folders only: what a link points at is not
// what was handed in, and what is built anew is left out. False where there are too many.
template <class File, class Folder>
bool ForEachFile(const fs::path& from, const std::string& program, const File& file,
                 const Folder& folder) {
  double bytes = 0.0;
  int files = 0;
  std::error_code failed;
  for (fs::recursive_directory_iterator at(from, failed), end; !failed && at != end;
       at.increment(failed)) {
    const fs::path relative = at->path().lexically_relative(from);
    const std::string name = relative.filename().string();
    const fs::file_status status = at->symlink_status(failed);
    if (fs::is_directory(status)) {
      const bool built = name.starts_with("obj-") || IsFile(at->path() / "CMakeCache.txt");
      if (built || name.starts_with(".")) {
        at.disable_recursion_pending();
        continue;
      }
      folder(relative);
    } else if (fs::is_regular_file(status) && relative.string() != program) {
      bytes += static_cast<double>(at->file_size(failed));
      if (++files > kMostFiles || bytes > kLargestSubmission) return false;
      file(relative);
    }
  }
  if (failed) throw Error("cannot read " + from.string() + ": " + failed.message());
  return true;
}

void CopySubmission(const fs::path& from, const fs::path& to, const std::string& program,
                    Submission& submission) {
  const bool all = ForEachFile(
      from, program,
      [&](const fs::path& file) {
        fs::copy_file(from / file, to / file, fs::copy_options::overwrite_existing);
      },
      [&](const fs::path& folder) { fs::create_directories(to / folder); });
  if (all) return;
  submission.failure =
      fmt::format("it has more than {} files or {:.0f} MB", kMostFiles, kLargestSubmission / 1e6);
}

std::string FindCmake(const std::string& libraries) {
  for (const fs::path& folder :
       {fs::path(libraries) / "cmake/CCMorse", fs::path(CCMORSE_SOURCE_DIR "/cmake")}) {
    if (IsFile(folder / "CCMorseConfig.cmake")) return fs::canonical(folder).string();
  }
  throw Error("CCMorseConfig.cmake, which submissions may be built with, is not in " + libraries +
              "/cmake/CCMorse");
}

// What the sandbox shows of the courses: makefiles and templates, never solutions or rubrics,
// unless a solution itself is what is graded.
void ShowCourse(const CourseFiles& course, const fs::path& path, Submission& submission) {
  const fs::path task = course.task;
  const fs::path suite = task.parent_path();
  const fs::path within = fs::path("/course") / suite.filename();
  const auto show = [&](const fs::path& ours, const fs::path& inside) {
    submission.shown.emplace_back(ours.string(), inside.string());
  };
  for (const fs::path& other : Entries(suite.parent_path())) {
    for (const fs::path& entry : Entries(other)) {
      const fs::path inside = fs::path("/course") / other.filename() / entry.filename();
      if (entry.extension() == ".mk" && IsFile(entry)) show(entry, inside);
      if (IsFolder(entry / "template")) show(entry / "template", inside / "template");
    }
  }
  submission.within = (within / task.filename() / "solutions" / "submission").string();
  std::error_code ignored;
  const fs::path parent = fs::weakly_canonical(path, ignored).parent_path();
  if (fs::equivalent(parent, task / "solutions", ignored)) {
    for (const fs::path& other : Entries(parent)) {
      if (IsFolder(other)) show(other, within / task.filename() / "solutions" / other.filename());
    }
  }
  show(course.include, "/ccmorse/include");
  show(course.libraries, "/ccmorse/lib");
  show(course.cmake, "/ccmorse/cmake");
}

class Output {
 public:
  explicit Output(ChildProcess& process) : process_(process) {}
  void Take() {
    std::string text;
    process_.ReadOut(text);
    process_.ReadErr(text);
    bytes_ += text.size();
    words_ += text;
    if (words_.size() > 2 * kBuildWords) words_.erase(0, words_.size() - kBuildWords);
  }
  std::size_t bytes() const { return bytes_; }
  std::string words() const { return LastWords(words_, kBuildWords); }

 private:
  ChildProcess& process_;
  std::size_t bytes_ = 0;
  std::string words_;
};

// Waits for the end of a build, or ends it; why it failed, or "".
template <class Step>
std::string Await(ChildProcess& process, const std::string& folder, Output& output,
                  const Step& step) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(kBuildTime);
  while (!process.Status()) {
    std::array<pollfd, 2> pipes{{{process.out(), POLLIN, 0}, {process.err(), POLLIN, 0}}};
    ::poll(pipes.data(), pipes.size(), 50);
    output.Take();
    step();
    std::string failure;
    if (Clock::now() > deadline) failure = fmt::format("the build took more than {} s", kBuildTime);
    if (FolderBytes(folder) > kLargestBuild) {
      failure = fmt::format("the build wrote more than {:.0f} MB", kLargestBuild / 1e6);
    }
    if (output.bytes() > kBuildOutput) failure = "the build printed more than 4 MB";
    if (!failure.empty()) {
      process.Signal(SIGKILL);
      return failure;
    }
  }
  output.Take();
  step();
  return "";
}

// `tool`: "make: ", what messages begin with.
std::string Build(const std::string& tool, const std::vector<std::string>& words,
                  Submission& submission, bool sandbox) {
  if (!sandbox) {
    ChildProcess make({words, submission.folder, {}});
    Output output(make);
    std::string failure = Await(make, submission.folder, output, [] {});
    submission.output = output.words();
    if (failure.empty() && !make.Status()->ok()) failure = tool + make.Status()->Text();
    return failure;
  }
  SandboxOptions options;
  options.command = words;
  options.folder = submission.within;
  options.read_only = submission.shown;
  options.writable = {{submission.folder, submission.within}};
  options.limits = {240.0, 2000.0, 128, 256.0};
  Sandbox make(options);
  make.Go();
  Output output(make.process());
  std::string failure = Await(make.process(), submission.folder, output, [&make] { make.Step(); });
  submission.output = output.words();
  if (!failure.empty()) return failure;
  if (!make.end()) return "the sandbox failed: " + make.process().Status()->Text();
  if (make.end()->kind == SandboxMessage::kExited) {
    const int status = make.end()->number;
    return status == 0 ? "" : fmt::format("{}exit status {}", tool, status);
  }
  return tool + FailureOf(*make.end(), options.limits);
}

std::vector<std::string> MakeWords(const CourseFiles& course, bool sandbox) {
  const fs::path courses = fs::path(course.task).parent_path().parent_path();
  const std::string makefiles = sandbox ? "/course/par" : (courses / "par").string();
  return {"/usr/bin/make",
          "-j2",
          "--no-print-directory",
          "MORSE=YES",
          "CCMORSE_DIR=" + (sandbox ? "/ccmorse" : fs::path(course.include).parent_path().string()),
          "CCMORSE_LIBDIR=" + (sandbox ? "/ccmorse/lib" : course.libraries),
          "CCMORSE_MK=" + makefiles + "/ccmorse.mk",
          "TASK_MK=" + makefiles + "/task.mk"};
}

// The program lands where make puts it, too.
std::vector<std::string> CmakeWords(const CourseFiles& course, const Submission& submission,
                                    bool sandbox) {
  static const std::string script =
      "cmake -B obj-cmake -D CCMorse_DIR=\"$1\" -D CCMORSE_LIBDIR=\"$2\" "
      "-D CMAKE_RUNTIME_OUTPUT_DIRECTORY=\"$3\" && cmake --build obj-cmake -j 2";
  return {"/bin/sh",
          "-c",
          script,
          "sh",
          sandbox ? "/ccmorse/cmake" : course.cmake,
          sandbox ? "/ccmorse/lib" : course.libraries,
          submission.within};
}

}  // namespace

CourseFiles FindCourseFiles(const std::string& task) {
  CourseFiles files;
  std::vector<std::string> known;
  if (IsFile(fs::path(task) / "rubric.json")) files.task = fs::canonical(task).string();
  for (const fs::path& courses : CourseFolders()) {
    for (const fs::path& suite : Entries(courses)) {
      for (const fs::path& entry : Entries(suite)) {
        if (!IsFile(entry / "rubric.json")) continue;
        known.push_back(entry.filename().string());
        if (known.back() == task && files.task.empty()) files.task = fs::canonical(entry).string();
      }
    }
  }
  if (files.task.empty()) {
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    std::string all;
    for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
    throw Error(fmt::format("there is no task '{}' with a rubric.json{}; there are: {}", task,
                            DidYouMean(task, known), all.empty() ? "none" : all));
  }
  files.include = FindInclude();
  files.libraries = FindLibraries();
  files.cmake = FindCmake(files.libraries);
  return files;
}

Submission BuildSubmission(const std::string& path, const grade::Rubric& rubric,
                           const CourseFiles& course, const std::string& folder, bool sandbox) {
  Submission submission;
  fs::path clean = fs::path(path).lexically_normal();
  if (clean.filename().empty()) clean = clean.parent_path();
  // "." is the folder that it stands for, and ends with a slash when it is made absolute.
  fs::path full = fs::absolute(clean).lexically_normal();
  if (full.filename().empty()) full = full.parent_path();
  submission.name = full.filename().string();
  submission.folder = folder;
  submission.program = folder + "/" + rubric.program;
  fs::create_directories(folder);
  ShowCourse(course, clean, submission);
  if (!sandbox) submission.within = folder;
  if (IsFile(clean)) {
    fs::copy_file(clean, submission.program);
    return submission;
  }
  if (!IsFolder(clean)) throw Error("there is no submission " + path);
  CopySubmission(clean, folder, rubric.program, submission);
  if (!submission.failure.empty()) return submission;
  const bool make = IsFile(fs::path(folder) / "Makefile") || IsFile(fs::path(folder) / "makefile");
  if (!make && !IsFile(fs::path(folder) / "CMakeLists.txt")) {
    submission.failure = "there is no Makefile in it, and no CMakeLists.txt";
    return submission;
  }
  const std::vector<std::string> words =
      make ? MakeWords(course, sandbox) : CmakeWords(course, submission, sandbox);
  submission.failure = Build(make ? "make: " : "cmake: ", words, submission, sandbox);
  if (submission.failure.empty()) {
    std::error_code failed;
    const fs::file_status status = fs::symlink_status(submission.program, failed);
    if (!fs::is_regular_file(status)) {
      submission.failure = fmt::format("{} ended well, but made no program '{}'",
                                       make ? "make" : "cmake", rubric.program);
    }
  }
  return submission;
}

std::string DigestOf(const std::string& path, const grade::Rubric& rubric) {
  sim::StateHash hash;
  const auto add = [&hash](std::string_view text) {
    hash.Add(static_cast<std::uint64_t>(text.size()));
    for (std::size_t at = 0; at < text.size(); at += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, text.data() + at, std::min<std::size_t>(8, text.size() - at));
      hash.Add(word);
    }
  };
  add(ReadFile(rubric.file));
  for (const grade::WorldDef& world : rubric.worlds) add(ReadFile(world.scenario));
  if (IsFile(path)) {
    add(ReadFile(path));
  } else {
    // In an order of its own: a folder has its entries in any.
    std::vector<fs::path> files;
    ForEachFile(
        path, rubric.program, [&](const fs::path& file) { files.push_back(file); },
        [](const fs::path&) {});
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
      add(file.string());
      add(ReadFile((path / file).string()));
    }
  }
  return fmt::format("{:016x}", hash.value());
}

double FolderBytes(const std::string& folder) {
  double bytes = 0.0;
  std::error_code failed;
  const auto how = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(folder, how, failed), end; !failed && at != end;
       at.increment(failed)) {
    std::error_code gone;
    if (fs::is_regular_file(at->symlink_status(gone))) {
      bytes += static_cast<double>(fs::file_size(at->path(), gone));
    }
  }
  return bytes;
}

std::string LastWords(const std::string& text, std::size_t most) {
  std::string words = text;
  while (!words.empty() && (words.back() == '\n' || words.back() == '\r')) words.pop_back();
  if (words.size() > most) {
    const std::size_t line = words.find('\n', words.size() - most);
    words.erase(0, line == std::string::npos ? words.size() - most : line + 1);
  }
  for (char& c : words) {
    if (static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\t') c = '?';
  }
  return words;
}

}  // namespace ccmorse::tools
