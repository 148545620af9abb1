#pragma once

#include <string>
#include <vector>

namespace ccmorse::tools {

/// What `ccmorse batch` was asked for.
struct BatchArguments {
  std::string manifest;
  std::string out;      ///< results file; "": the manifest's name with .results.jsonl, here
  int at_once = 0;      ///< jobs at a time; 0: as many as there are cores
  int log_kib = 256;    ///< longest log of a job, KiB
  bool retry = false;   ///< do jobs again that failed or ran out of time
  bool timing = false;  ///< wall-clock times in the results
  bool quiet = false;   ///< no progress
  std::string task;     ///< "K/T": only every T-th job from the K-th on, into a part of its own
  bool slurm = false;   ///< submit instead of running
  int tasks = 0;        ///< of the Slurm array; 0: one a job, 100 at most
  std::vector<std::string> sbatch;  ///< options for sbatch
  bool dry_run = false;             ///< print the job script instead of submitting it
  bool collect = false;             ///< merge the parts that tasks have written
};

/// `ccmorse batch` (docs/batch.md). Returns the exit status: 0 when every job has a result,
/// whatever that is, 1 when --collect misses some, 128 + the signal when one ended it. Throws Error
/// for what the user can put right.
int Batch(const BatchArguments& arguments);

}  // namespace ccmorse::tools
