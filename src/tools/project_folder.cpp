#include "tools/project_folder.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <stdio.h>  // renameat2() is Linux's own
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "base/error.h"

namespace ccmorse::tools {

namespace fs = std::filesystem;

void WriteProjectFiles(const fs::path& root, const std::vector<ProjectFile>& files) {
  for (const ProjectFile& file : files) {
    const fs::path path = root / file.path;
    std::error_code failed;
    fs::create_directories(path.parent_path(), failed);
    if (failed) {
      throw Error(fmt::format("cannot make the folder {}: {}", path.parent_path().string(),
                              failed.message()));
    }
    std::ofstream out(path, std::ios::binary);
    if (!(out << file.content) || !out.flush()) {
      throw Error(fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
    }
    out.close();
    if (!file.executable) continue;
    constexpr fs::perms kExecutable =
        fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec;
    fs::permissions(path, kExecutable, fs::perm_options::add, failed);
  }
}

NewFolder::NewFolder(fs::path place) : place_(std::move(place)) {
  if (fs::exists(fs::symlink_status(place_))) {
    throw Error(place_.string() + " is there already");
  }
  std::error_code failed;
  const fs::path parent = fs::absolute(place_).parent_path();
  if (!fs::is_directory(parent, failed)) {
    throw Error(fmt::format("there is no folder {}; make it first", parent.string()));
  }
  std::string name = (parent / ("." + place_.filename().string() + ".XXXXXX")).string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw Error(fmt::format("cannot make a folder in {}: {}; go to one that is yours",
                            parent.string(), std::strerror(errno)));
  }
  temporary_ = name;
  // As mkdir() would have it; mkdtemp() lets nobody else in.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  (void)::chmod(name.c_str(), 0777 & ~mask);
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void NewFolder::Keep() {
  int status =
      ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, place_.c_str(), RENAME_NOREPLACE);
  // Some network file systems cannot promise not to replace; rename() replaces no folder that has
  // anything in it either.
  if (status != 0 && errno == EINVAL) status = ::rename(temporary_.c_str(), place_.c_str());
  if (status != 0) {
    throw Error(fmt::format("cannot make {}: {}", place_.string(), std::strerror(errno)));
  }
  temporary_.clear();
}

}  // namespace ccmorse::tools
