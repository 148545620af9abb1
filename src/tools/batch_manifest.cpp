#include "tools/batch_manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/json.h"
#include "scene/field.h"
#include "scene/player/import.h"
#include "scene/scenario.h"
#include "tools/child_process.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;
using scene::Field;
using scene::ObjectReader;
using scene::Quoted;

constexpr std::int64_t kMostSeed = std::numeric_limits<std::int64_t>::max();
constexpr std::size_t kMostJobs = 100000;
constexpr std::size_t kLongestName = 100;
constexpr scene::Range kSeconds{0.0, 1e9, true};
constexpr scene::Range kTimeout{0.0, 1e7, true};

// What jobs have in common unless they say otherwise.
struct Defaults {
  double seconds = 0.0;
  double timeout = BatchJob().timeout;
};

// A program of the cross product.
struct Program {
  std::string path;
  std::string name;
  std::vector<std::string> args;
  int line = 0;
};

bool MayStandInName(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '.';
}

// A job's name is the name of its folder, too, so it must be harmless as one.
std::string ReadName(const Field& field) {
  const std::string& name = field.Text();
  if (name.empty() || name.size() > kLongestName || name[0] == '.' || name[0] == '-' ||
      !std::all_of(name.begin(), name.end(), MayStandInName)) {
    field.FailHere(fmt::format(
        "is {}, must be 1 to {} letters, digits or _ - . and begin with none of the last two",
        Quoted(name), kLongestName));
  }
  return name;
}

// What a name is made of for "../solvers/wall follower.py": wall_follower.
std::string ShortName(const std::string& path) {
  std::string name = fs::path(path).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !MayStandInName(c); }, '_');
  name = name.substr(0, 40);
  return name.empty() || name[0] == '.' || name[0] == '-' ? "_" + name : name;
}

std::string MadeName(const std::string& scenario, const std::optional<std::int64_t>& seed,
                     const std::string& program) {
  std::string name = ShortName(scenario);
  if (seed) name += fmt::format("-{}", *seed);
  if (!program.empty()) name += "-" + program;
  return name;
}

// Text that is to go to the system as a path or an argument: not empty where it is a path, and
// without a NUL, behind which the system would see nothing.
const std::string& ReadWord(const Field& field, bool may_be_empty) {
  const std::string& text = field.Text();
  if (text.empty() && !may_be_empty) field.FailHere("is empty");
  if (text.find('\0') != std::string::npos) field.FailHere("has a NUL character");
  return text;
}

std::vector<std::string> ReadArgs(ObjectReader& reader) {
  std::vector<std::string> args;
  if (!reader.Has("args")) return args;
  for (const Field& item : reader.Require("args").Items()) args.push_back(ReadWord(item, true));
  return args;
}

void RequireAnEnd(const BatchJob& job, const Field& field) {
  if (job.seconds > 0.0 || !job.program.empty()) return;
  field.FailHere("has neither 'seconds' nor a 'program', so it would never end");
}

BatchJob ReadJob(const Field& field, const Defaults& defaults) {
  ObjectReader reader(field);
  BatchJob job;
  const Field scenario = reader.Require("scenario");
  job.scenario = ReadWord(scenario, false);
  job.scenario_line = scenario.line();
  if (reader.Has("seed")) job.seed = reader.Require("seed").Integer(0, kMostSeed);
  if (reader.Has("program")) {
    const Field program = reader.Require("program");
    job.program = ReadWord(program, false);
    job.program_line = program.line();
  }
  job.args = ReadArgs(reader);
  if (!job.args.empty() && job.program.empty()) reader.Require("args").FailHere("need a 'program'");
  job.seconds = reader.Number("seconds", defaults.seconds, kSeconds);
  job.timeout = reader.Number("timeout", defaults.timeout, kTimeout);
  job.name = reader.Has("name") ? ReadName(reader.Require("name"))
                                : MadeName(job.scenario, job.seed,
                                           job.program.empty() ? "" : ShortName(job.program));
  reader.Finish();
  RequireAnEnd(job, field);
  return job;
}

std::vector<std::optional<std::int64_t>> ReadSeeds(const Field& field) {
  std::vector<std::optional<std::int64_t>> seeds;
  if (field.value().IsArray()) {
    for (const Field& item : field.Items()) seeds.emplace_back(item.Integer(0, kMostSeed));
  } else if (field.value().IsObject()) {
    ObjectReader reader(field);
    const std::int64_t from = reader.Require("from").Integer(0, kMostSeed);
    const std::int64_t to = reader.Require("to").Integer(from, kMostSeed);
    reader.Finish();
    if (to - from >= static_cast<std::int64_t>(kMostJobs)) {
      field.FailHere(fmt::format("are more than {}", kMostJobs));
    }
    for (std::int64_t seed = from; seed - from <= to - from; ++seed) {
      seeds.emplace_back(seed);
      if (seed == to) break;  // the largest number there is has no next one
    }
  } else {
    field.FailHere(fmt::format("must be a list of seeds or {{\"from\": ..., \"to\": ...}}, not {}",
                               field.value().TypeName()));
  }
  if (seeds.empty()) field.FailHere("are an empty list");
  return seeds;
}

Program ReadProgram(const Field& field) {
  Program program;
  program.line = field.line();
  if (field.value().IsString()) {
    program.path = ReadWord(field, false);
    program.name = ShortName(program.path);
    return program;
  }
  if (!field.value().IsObject()) {
    field.FailHere(
        fmt::format("must be a path or {{\"program\": ...}}, not {}", field.value().TypeName()));
  }
  ObjectReader reader(field);
  const Field path = reader.Require("program");
  program.path = ReadWord(path, false);
  program.line = path.line();
  program.args = ReadArgs(reader);
  program.name = reader.Has("name") ? ReadName(reader.Require("name")) : ShortName(program.path);
  reader.Finish();
  return program;
}

void AddProduct(ObjectReader& reader, const Defaults& defaults, std::vector<BatchJob>& jobs) {
  const bool wanted = reader.Has("scenarios");
  for (const char* key : {"seeds", "programs"}) {
    if (reader.Has(key) && !wanted) reader.Require(key).FailHere("need 'scenarios'");
  }
  if (!wanted) return;
  const Field scenario_list = reader.Require("scenarios");
  const std::vector<Field> scenarios = scenario_list.Items();
  if (scenarios.empty()) scenario_list.FailHere("are an empty list");
  std::vector<std::optional<std::int64_t>> seeds = {std::nullopt};
  if (reader.Has("seeds")) seeds = ReadSeeds(reader.Require("seeds"));
  std::vector<Program> programs(1);
  if (reader.Has("programs")) {
    programs.clear();
    const Field list = reader.Require("programs");
    for (const Field& item : list.Items()) programs.push_back(ReadProgram(item));
    if (programs.empty()) list.FailHere("are an empty list");
  }
  if (scenarios.size() * seeds.size() > kMostJobs / programs.size()) {
    scenario_list.FailHere(fmt::format("make more than {} jobs", kMostJobs));
  }
  for (const Field& scenario : scenarios) {
    const std::string& path = ReadWord(scenario, false);
    for (const auto& seed : seeds) {
      for (const Program& program : programs) {
        BatchJob job;
        job.name = MadeName(path, seed, program.name);
        job.scenario = path;
        job.scenario_line = scenario.line();
        job.program = program.path;
        job.program_line = program.line;
        job.args = program.args;
        job.seed = seed;
        job.seconds = defaults.seconds;
        job.timeout = defaults.timeout;
        RequireAnEnd(job, scenario);
        jobs.push_back(std::move(job));
      }
    }
  }
}

// Results are found by their job's name.
void CheckNames(std::vector<BatchJob>& jobs, const std::string& file) {
  std::map<std::string, const BatchJob*> seen;
  for (BatchJob& job : jobs) {
    job.index = static_cast<int>(&job - jobs.data());
    const auto [first, is_new] = seen.emplace(job.name, &job);
    if (is_new) continue;
    throw Error(
        fmt::format("{}:{}: two jobs are called '{}', the first on line {}; give one "
                    "another 'name'",
                    file, job.scenario_line, job.name, first->second->scenario_line));
  }
}

std::vector<BatchJob> ReadManifest(const Json& json, const std::string& file) {
  const Field field(json, "", file);
  ObjectReader reader(field);
  Defaults defaults;
  defaults.seconds = reader.Number("seconds", defaults.seconds, kSeconds);
  defaults.timeout = reader.Number("timeout", defaults.timeout, kTimeout);
  std::vector<BatchJob> jobs;
  if (reader.Has("jobs")) {
    for (const Field& item : reader.Require("jobs").Items()) {
      jobs.push_back(ReadJob(item, defaults));
    }
  }
  AddProduct(reader, defaults, jobs);
  reader.Finish();
  if (jobs.empty()) field.FailHere("has no jobs: it needs 'jobs' or 'scenarios'");
  if (jobs.size() > kMostJobs) field.FailHere(fmt::format("has more than {} jobs", kMostJobs));
  CheckNames(jobs, file);
  return jobs;
}

// A path starts at the manifest's folder; a mere name may also be a command of $PATH.
std::string FindProgram(const std::string& program, const fs::path& folder) {
  if (IsProgram(folder / program)) return (folder / program).lexically_normal().string();
  if (program.find('/') != std::string::npos) return "";
  return FindInPath(program);
}

// The scenario's file and its own seed.
struct FoundScenario {
  std::string file;
  std::int64_t seed = 0;
};

FoundScenario FindAndCheck(const BatchJob& job, const fs::path& folder, const std::string& file) {
  std::error_code ignored;
  std::string found;
  if (fs::is_regular_file(folder / job.scenario, ignored)) {
    found = (folder / job.scenario).lexically_normal().string();
  } else {
    try {
      found = fs::absolute(scene::FindScenario(job.scenario)).string();
    } catch (const Error& error) {
      throw Error(fmt::format("{}:{}: {}", file, job.scenario_line, error.what()));
    }
  }
  return {found, static_cast<std::int64_t>(scene::ImportScenario(found).scenario.seed)};
}

}  // namespace

std::vector<BatchJob> ParseManifest(const std::string& text, const std::string& file) {
  try {
    const Json json = Json::Parse(text);
    return ReadManifest(json, file);
  } catch (const JsonError& error) {
    throw Error(
        fmt::format("{}:{}: {} (column {})", file, error.line(), error.reason(), error.column()));
  }
}

std::vector<BatchJob> LoadManifest(const std::string& file) {
  std::vector<BatchJob> jobs = ParseManifest(ReadFile(file), file);
  const fs::path folder = fs::absolute(file).parent_path();
  std::map<std::string, FoundScenario> scenarios;
  std::map<std::string, std::string> programs;
  for (BatchJob& job : jobs) {
    if (!scenarios.contains(job.scenario)) {
      scenarios[job.scenario] = FindAndCheck(job, folder, file);
    }
    const FoundScenario& scenario = scenarios[job.scenario];
    job.scenario_file = scenario.file;
    if (!job.seed) job.seed = scenario.seed;
    if (job.program.empty()) continue;
    if (!programs.contains(job.program)) {
      const std::string found = FindProgram(job.program, folder);
      if (found.empty()) {
        throw Error(fmt::format("{}:{}: there is no program {} that may be run, looked in {}{}",
                                file, job.program_line, Quoted(job.program), folder.string(),
                                job.program.find('/') == std::string::npos ? " and $PATH" : ""));
      }
      programs[job.program] = found;
    }
    job.program_file = programs[job.program];
  }
  return jobs;
}

}  // namespace ccmorse::tools
