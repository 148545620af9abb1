#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/json.h"
#include "tools/batch_manifest.h"

namespace ccmorse::tools {

/// What a job's line says of the job itself, before any result: job, name, scenario, seed, program,
/// args and seconds. The job must be resolved.
Json JobLine(const BatchJob& job);

/// The finished jobs of one or more files, by the job's name.
using BatchResults = std::map<std::string, Json>;

/// Takes the lines of `text`, the content of a results file, into `results`; a job that is there
/// already stays. The last line, when a kill has cut it short, is left out. `file` names it, and
/// `manifest` the manifest, in messages. Returns how many bytes hold whole lines. Throws Error
/// "FILE:LINE: ..." for a line that is no result, and for one whose job the manifest lacks or has
/// otherwise: those are results of something else.
std::size_t ReadResults(const std::string& text, const std::string& file,
                        const std::vector<BatchJob>& jobs, const std::string& manifest,
                        BatchResults& results);

/// Lines in the order of the manifest, of those jobs that have one, each with the job's number.
std::string InManifestOrder(const std::vector<BatchJob>& jobs, const BatchResults& results);

/// A file that grows by one line at a time, so that a kill at any moment costs at most the last.
/// Locked while it is open, so that no two batches write to the same.
class ResultsFile {
 public:
  /// Opens or makes the file; what stands in it behind the last whole line goes. Throws Error.
  ResultsFile(std::string path, const std::vector<BatchJob>& jobs, const std::string& manifest);
  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  const BatchResults& results() const { return results_; }

  /// Leaves out what `keep` refuses, for those jobs to be done again. Throws Error.
  void Keep(const std::function<bool(const Json& line)>& keep);
  /// Adds a line at the end. Throws Error when it cannot be written.
  void Add(const BatchJob& job, const Json& line);
  /// Puts the lines into the manifest's order, all at once: a kill leaves either the old file or
  /// the new. Throws Error.
  void Sort();

 private:
  std::string path_;
  const std::vector<BatchJob>& jobs_;
  BatchResults results_;
  int file_ = -1;
};

}  // namespace ccmorse::tools
