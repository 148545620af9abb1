#pragma once

#include <string>
#include <vector>

namespace ccmorse::tools {

/// A manifest as a Slurm job array: task K of `tasks` does every `tasks`-th job from the K-th on.
struct SlurmArray {
  std::string name;                  ///< how Slurm lists it
  std::string ccmorse;               ///< absolute path of the program
  std::string manifest;              ///< absolute
  std::string out;                   ///< absolute: the results file
  std::string folder;                ///< absolute: of the script, the parts and the tasks' output
  int tasks = 1;                     ///< 1..100000
  int at_once = 1;                   ///< jobs that a task does at a time: its -j and its CPUs
  std::vector<std::string> words;    ///< further ones of `ccmorse batch`: "--timing"
  std::vector<std::string> options;  ///< for sbatch: "--partition=long"
};

/// The job script for `sbatch --array=...`.
std::string SlurmScript(const SlurmArray& array);

/// {1, 2, 3, 7} as sbatch's --array wants it: "1-3,7". The numbers must rise.
std::string TaskList(const std::vector<int>& tasks);

/// `text` as one word of a POSIX shell.
std::string ShellWord(const std::string& text);

/// Hands the script to sbatch for these tasks; the number that Slurm gave the job. Throws Error
/// with sbatch's own words.
std::string Submit(const std::string& script, const std::vector<int>& tasks);

}  // namespace ccmorse::tools
