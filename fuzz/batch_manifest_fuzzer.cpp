// ParseManifest. What must hold, whatever the bytes:
// - the result is jobs or an Error of one line that begins with the file's name;
// - the jobs are numbered in their order, their names are unique and harmless as those of folders,
//   no path or argument has a NUL in it, and each job comes to an end.

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

#include "base/error.h"
#include "fuzz/check.h"
#include "tools/batch_manifest.h"

namespace {

using ccmorse::fuzz::Require;
using ccmorse::tools::BatchJob;

constexpr const char* kFile = "m.json";

void CheckMessage(const std::string& message) {
  Require(message.starts_with(std::string(kFile) + ":"), "an Error begins with the file's name",
          message);
  Require(std::none_of(message.begin(), message.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }),
          "an Error is one line of text", message);
}

void CheckName(const std::string& name) {
  Require(!name.empty() && name.size() < 250 && name[0] != '.' && name[0] != '-',
          "a name can be a folder's", name);
  Require(std::all_of(name.begin(), name.end(),
                      [](char c) {
                        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
                               c == '-' || c == '.';
                      }),
          "a name is of harmless characters", name);
}

void CheckWord(const std::string& word) {
  Require(word.find('\0') == std::string::npos, "no word for the system has a NUL in it", word);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<BatchJob> jobs;
  try {
    jobs = ccmorse::tools::ParseManifest(std::string(data, data + size), kFile);
  } catch (const ccmorse::Error& error) {
    CheckMessage(error.what());
    return 0;
  }
  Require(!jobs.empty() && jobs.size() <= 100000, "there are jobs, within the limit");
  std::set<std::string> names;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const BatchJob& job = jobs[i];
    Require(job.index == static_cast<int>(i), "jobs are numbered in their order");
    CheckName(job.name);
    Require(names.insert(job.name).second, "names are unique", job.name);
    Require(!job.scenario.empty(), "each job has a scenario");
    CheckWord(job.scenario);
    CheckWord(job.program);
    for (const std::string& word : job.args) CheckWord(word);
    Require(job.args.empty() || !job.program.empty(), "arguments have a program");
    Require(job.seconds > 0.0 || !job.program.empty(), "each job ends");
    Require(job.seconds >= 0.0 && job.timeout > 0.0, "times are not negative");
    Require(!job.seed || *job.seed >= 0, "no seed is negative");
  }
  return 0;
}
