#include "tools/batch_results.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "scene/field.h"

namespace ccmorse::tools {
namespace {

void WriteAll(int file, std::string_view text, const std::string& path) {
  while (!text.empty()) {
    const ssize_t size = ::write(file, text.data(), text.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) throw Error(fmt::format("cannot write {}: {}", path, std::strerror(errno)));
    text.remove_prefix(static_cast<std::size_t>(size));
  }
}

// Opens or makes the file and locks it. Where the file system has no locks the user has to take
// care.
int OpenLocked(const std::string& path) {
  for (;;) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file < 0) throw Error(fmt::format("cannot write {}: {}", path, std::strerror(errno)));
    if (::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(file);
      throw Error(fmt::format("another batch is writing to {}; choose another --out", path));
    }
    // Another batch may have put its sorted file in the place of the one that we opened.
    struct stat opened {};
    struct stat there {};
    if (::fstat(file, &opened) == 0 && ::stat(path.c_str(), &there) == 0 &&
        opened.st_ino == there.st_ino && opened.st_dev == there.st_dev) {
      return file;
    }
    ::close(file);
  }
}

using JobsByName = std::map<std::string, const BatchJob*>;

// The job that a line tells of. Throws Error, without the file and line.
const BatchJob& JobOf(const Json& line, const JobsByName& jobs, const std::string& manifest) {
  const Json* const name = line.Find("name");
  const Json* const status = line.Find("status");
  if (name == nullptr || !name->IsString() || status == nullptr || !status->IsString()) {
    throw Error("this is no line of a batch's results");
  }
  const auto job = jobs.find(name->AsString());
  if (job == jobs.end()) {
    throw Error(fmt::format("{} has no job {}; choose another --out, or remove the line", manifest,
                            scene::Quoted(name->AsString())));
  }
  const Json expected = JobLine(*job->second);
  for (const auto& [key, value] : expected.AsObject()) {
    if (key == "job") continue;  // a manifest may grow at its front
    const Json* const was = line.Find(key);
    if (was != nullptr && *was == value) continue;
    throw Error(fmt::format(
        "the {} of job {} was {} and is {} in {} now; choose another --out, or remove the line",
        key, scene::Quoted(name->AsString()),
        was == nullptr ? "missing" : scene::Printable(was->Dump()), scene::Printable(value.Dump()),
        manifest));
  }
  return *job->second;
}

}  // namespace

Json JobLine(const BatchJob& job) {
  Json::Array args;
  for (const std::string& word : job.args) args.emplace_back(word);
  return Json::Object{{"job", job.index},
                      {"name", job.name},
                      {"scenario", job.scenario},
                      {"seed", job.seed.value_or(1)},
                      {"program", job.program.empty() ? Json() : Json(job.program)},
                      {"args", std::move(args)},
                      {"seconds", job.seconds > 0.0 ? Json(job.seconds) : Json()}};
}

std::size_t ReadResults(const std::string& text, const std::string& file,
                        const std::vector<BatchJob>& jobs, const std::string& manifest,
                        BatchResults& results) {
  JobsByName by_name;
  for (const BatchJob& job : jobs) by_name.emplace(job.name, &job);
  std::size_t at = 0;
  for (int number = 1; at < text.size(); ++number) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string::npos) break;
    try {
      Json line = Json::Parse(std::string_view(text).substr(at, end - at));
      const BatchJob& job = JobOf(line, by_name, manifest);
      results.emplace(job.name, std::move(line));
    } catch (const JsonError& error) {
      // Where the machine itself went down, the end of the file may be anything.
      if (end + 1 == text.size()) break;
      throw Error(
          fmt::format("{}:{}: {} (column {})", file, number, error.reason(), error.column()));
    } catch (const Error& error) {
      throw Error(fmt::format("{}:{}: {}", file, number, error.what()));
    }
    at = end + 1;
  }
  return at;
}

std::string InManifestOrder(const std::vector<BatchJob>& jobs, const BatchResults& results) {
  std::string text;
  for (const BatchJob& job : jobs) {
    const auto found = results.find(job.name);
    if (found == results.end()) continue;
    Json line = found->second;
    line.Set("job", job.index);
    text += line.Dump() + "\n";
  }
  return text;
}

ResultsFile::ResultsFile(std::string path, const std::vector<BatchJob>& jobs,
                         const std::string& manifest)
    : path_(std::move(path)), jobs_(jobs) {
  file_ = OpenLocked(path_);
  try {
    const std::string text = ReadFile(path_);
    const std::size_t whole = ReadResults(text, path_, jobs_, manifest, results_);
    if (whole < text.size() && ::ftruncate(file_, static_cast<off_t>(whole)) != 0) {
      throw Error(fmt::format("cannot write {}: {}", path_, std::strerror(errno)));
    }
  } catch (...) {
    ::close(file_);
    throw;
  }
}

ResultsFile::~ResultsFile() { ::close(file_); }

void ResultsFile::Keep(const std::function<bool(const Json& line)>& keep) {
  if (std::erase_if(results_, [&keep](const auto& entry) { return !keep(entry.second); }) > 0) {
    Sort();
  }
}

void ResultsFile::Add(const BatchJob& job, const Json& line) {
  WriteAll(file_, line.Dump() + "\n", path_);
  results_.emplace(job.name, line);
}

void ResultsFile::Sort() {
  const std::string text = InManifestOrder(jobs_, results_);
  if (text == ReadFile(path_)) return;
  const std::string next = path_ + ".new";
  const int file = ::open(next.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) throw Error(fmt::format("cannot write {}: {}", next, std::strerror(errno)));
  try {
    WriteAll(file, text, next);
    // The lock goes with the file: whoever opens the new one finds it locked, too.
    ::flock(file, LOCK_EX | LOCK_NB);
    if (::fsync(file) != 0 || std::rename(next.c_str(), path_.c_str()) != 0) {
      throw Error(fmt::format("cannot write {}: {}", path_, std::strerror(errno)));
    }
  } catch (...) {
    ::close(file);
    throw;
  }
  ::close(file_);
  file_ = file;
}

}  // namespace ccmorse::tools
