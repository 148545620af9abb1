#pragma once

#include <filesystem>
#include <vector>

#include "tools/project_files.h"

namespace ccmorse::tools {

/// Writes files below `root`, making folders. Throws Error at the first that cannot be written;
/// what was written stays.
void WriteProjectFiles(const std::filesystem::path& root, const std::vector<ProjectFile>& files);

/// A folder with a name of its own beside `place`, which becomes `place` at once or goes again: so
/// that nobody sees half a project, and none is left behind. Not thread safe.
class NewFolder {
 public:
  /// Throws Error when `place` is there already or the folder cannot be made.
  explicit NewFolder(std::filesystem::path place);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  /// Where to write until then.
  const std::filesystem::path& path() const { return temporary_; }

  /// Puts it in place. Throws Error when that is there by now.
  void Keep();

 private:
  std::filesystem::path place_;
  std::filesystem::path temporary_;
};

}  // namespace ccmorse::tools
