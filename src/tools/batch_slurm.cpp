#include "tools/batch_slurm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

#include "base/error.h"
#include "tools/child_process.h"

namespace ccmorse::tools {
namespace {

std::string Stripped(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \r\n");
  return end == std::string::npos ? "" : text.substr(0, end + 1);
}

}  // namespace

std::string ShellWord(const std::string& text) {
  constexpr std::string_view kPlain = "/._-=+:,@%";
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [&](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           kPlain.find(c) != std::string_view::npos;
  });
  if (plain) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string TaskList(const std::vector<int>& tasks) {
  std::string list;
  for (std::size_t i = 0; i < tasks.size();) {
    std::size_t last = i;
    while (last + 1 < tasks.size() && tasks[last + 1] == tasks[last] + 1) ++last;
    if (!list.empty()) list += ",";
    list += std::to_string(tasks[i]);
    if (last > i) list += "-" + std::to_string(tasks[last]);
    i = last + 1;
  }
  return list;
}

std::string SlurmScript(const SlurmArray& array) {
  std::string script = fmt::format(
      "#!/bin/sh\n"
      "# One task of a batch of simulations; written by `ccmorse batch --slurm`.\n"
      "#SBATCH --job-name={}\n"
      "#SBATCH --output={}\n"
      "#SBATCH --cpus-per-task={}\n",
      array.name, ShellWord(array.folder + "/task-%a.out"), array.at_once);
  for (const std::string& option : array.options) script += "#SBATCH " + option + "\n";
  script += fmt::format("exec {} batch {} --out {} --task \"$SLURM_ARRAY_TASK_ID/{}\" -j {}",
                        ShellWord(array.ccmorse), ShellWord(array.manifest), ShellWord(array.out),
                        array.tasks, array.at_once);
  for (const std::string& word : array.words) script += " " + ShellWord(word);
  return script + "\n";
}

std::string Submit(const std::string& script, const std::vector<int>& tasks) {
  FinishedProcess sbatch;
  try {
    sbatch =
        RunToEnd({"/usr/bin/env", "sbatch", "--parsable", "--array=" + TaskList(tasks), script});
  } catch (const Error& error) {
    throw Error(fmt::format("cannot start sbatch: {}", error.what()));
  }
  if (sbatch.status.code == 127) {
    throw Error(
        "there is no sbatch: this machine cannot submit to Slurm (Debian: slurm-client); "
        "--dry-run prints the script");
  }
  if (!sbatch.status.ok()) {
    throw Error(fmt::format("sbatch: {} ({})", Stripped(sbatch.err), sbatch.status.Text()));
  }
  const std::string job = Stripped(sbatch.out);
  return job.substr(0, job.find(';'));  // "NUMBER;CLUSTER" where there are several clusters
}

}  // namespace ccmorse::tools
