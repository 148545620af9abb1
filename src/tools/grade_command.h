#pragma once

#include <cstdint>
#include <string>

namespace ccmorse::tools {

/// What `ccmorse grade` was asked for.
struct GradeArguments {
  std::string task;        ///< a task's name, or the path of its folder
  std::string submission;  ///< folder or program; with class_folder "" and with record optional
  int seeds = 5;           ///< worlds, >= 1
  std::int64_t first_seed = 1;
  std::string report;        ///< HTML file; "": none
  std::string json;          ///< JSON file, "-": standard output instead of the table; "": none
  std::string keep_records;  ///< folder for the records; "": thrown away
  std::string record;        ///< judge this record and run nothing; "": run
  std::string class_folder;  ///< grade each submission in it; "": one
  std::string out;           ///< folder of a class's results; "": CLASS-grades here
  int at_once = 0;           ///< runs, or submissions of a class, at a time; 0: by the cores
  bool no_sandbox = false;
  bool quiet = false;  ///< no progress
};

/// Exit status of `ccmorse grade` where the score is below the pass mark.
inline constexpr int kNotPassed = 3;

/// `ccmorse grade` (docs/grading.md). Returns the exit status: 0 passed, or a class graded;
/// kNotPassed; 128 + the signal when one ended it. Throws Error for what the user can put right.
int Grade(const GradeArguments& arguments);

}  // namespace ccmorse::tools
