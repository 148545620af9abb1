#pragma once

#include <string>
#include <utility>
#include <vector>

#include "grade/rubric.h"

namespace ccmorse::tools {

/// Where CCMorse's own files are that a submission is built with.
struct CourseFiles {
  std::string task;       ///< folder of the task, with its rubric.json
  std::string include;    ///< folder of the public headers
  std::string libraries;  ///< folder of libCCMorse.so and libimrh.a
  std::string cmake;      ///< folder of CCMorseConfig.cmake
};

/// Finds a task by its name under courses/*/, installed or in the source tree, or by the path of
/// its folder. Throws Error that names the tasks there are.
CourseFiles FindCourseFiles(const std::string& task);

/// A submission in a folder of our own, built.
struct Submission {
  std::string name;     ///< of its folder or file
  std::string folder;   ///< ours
  std::string program;  ///< its file in there
  std::string failure;  ///< why there is none; "": there is
  std::string output;   ///< the end of what the compiler said
  /// What the sandbox shows, (ours, within), beside the folder itself.
  std::vector<std::pair<std::string, std::string>> shown;
  std::string within;  ///< the folder, within the sandbox; without one, `folder`
};

/// Copies the submission, a folder with a Makefile or a CMakeLists.txt, or a program, into
/// `folder`, which is made, and builds it there, with `make` where there is a Makefile, in a
/// sandbox if wanted. What the submission does wrong is in the result. Throws Error where it does
/// not exist, or the machine has no room.
Submission BuildSubmission(const std::string& path, const grade::Rubric& rubric,
                           const CourseFiles& course, const std::string& folder, bool sandbox);

/// What a grade depends on, as 16 hexadecimal digits: the files of the submission that are graded,
/// the rubric and its scenarios. Another text, almost certainly another digest; no protection
/// against who wants two that are the same. Throws Error where the submission cannot be read.
std::string DigestOf(const std::string& path, const grade::Rubric& rubric);

/// Bytes of all files in a folder.
double FolderBytes(const std::string& folder);

/// The end of what a program printed, for people: at most `most` bytes, whole lines if possible.
std::string LastWords(const std::string& text, std::size_t most);

}  // namespace ccmorse::tools
