#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "grade/judge.h"
#include "grade/rubric.h"

namespace ccmorse::grade {

/// One run of a submission: judged, or why it could not be.
struct RunReport {
  std::uint64_t seed = 0;
  std::optional<Judgement> judgement;  ///< nothing where the run gave none
  std::string failure;                 ///< why the run counts 0: a crash, a limit; "": it counts
  std::string note;                    ///< the program's exit status or last words; "" for none
  std::string record;                  ///< file to replay; "": not kept
  double cpu_s = 0.0;                  ///< s that the program used
  double memory_mb = 0.0;              ///< MB, at most

  /// 0..100.
  double score() const { return failure.empty() && judgement ? judgement->score : 0.0; }
};

/// A submission, graded.
struct Grading {
  std::string submission;       ///< name of its folder or file
  bool sandboxed = true;        ///< false: it ran without any protection
  std::string build_failure;    ///< why it could not be built; "": it was
  std::string build_output;     ///< the end of what the compiler said
  std::vector<RunReport> runs;  ///< by seed

  /// Mean over the runs, 0..100.
  double score() const;
};

/// A criterion over all runs.
struct CriterionMean {
  std::string name;
  std::string measure;
  double weight = 0.0;
  double points = 0.0;          ///< mean
  std::optional<double> value;  ///< mean of the runs that have one
  std::string reason;           ///< of the run with the fewest points
};
std::vector<CriterionMean> Means(const Rubric& rubric, const Grading& grading);

/// The result as data (docs/grading.md); equal gradings give equal text.
Json GradingJson(const Rubric& rubric, const Grading& grading);
/// For a terminal, lines with line ends.
std::string GradingTable(const Rubric& rubric, const Grading& grading);
/// One self-contained page.
std::string GradingPage(const Rubric& rubric, const Grading& grading);

/// What a class's table shows of a submission.
struct ClassEntry {
  std::string submission;
  double score = 0.0;
  bool passed = false;
  std::string problem;         ///< of the first kind; "" for none
  std::vector<double> points;  ///< a criterion each
};
/// A table of the class, best first.
std::string ClassCsv(const Rubric& rubric, std::vector<ClassEntry> entries);
std::string ClassPage(const Rubric& rubric, std::vector<ClassEntry> entries);

/// Text as HTML.
std::string Escaped(const std::string& text);

}  // namespace ccmorse::grade
