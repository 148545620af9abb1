#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

#include "base/error.h"
#include "base/nearest_name.h"
#include "scene/field.h"
#include "scene/scenario.h"
#include "scene/world_folders.h"

namespace ccmorse::scene {
namespace {

namespace fs = std::filesystem;

// What a folder holds, sorted; empty when it cannot be read: a place that is not there is not an
// error as long as another one has what is asked for.
std::vector<fs::path> Entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    entries.push_back(at->path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool IsFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

// "folder/NAME" of every scenario -> its file; the folder that is looked in first wins.
std::map<std::string, std::string> AllScenarios() {
  std::map<std::string, std::string> files;
  for (const std::string& root : WorldFolders()) {
    for (const fs::path& folder : Entries(root)) {
      for (const fs::path& file : Entries(folder)) {
        if (file.extension() != ".json" || !IsFile(file)) continue;
        files.emplace(folder.filename().string() + "/" + file.stem().string(), file.string());
      }
    }
  }
  return files;
}

// The names a scenario goes by -> its file: a folder's own name, then NAME where only one folder
// has it, then folder/NAME.
struct Names {
  std::map<std::string, std::string> file_of;
  std::vector<std::string> shortest;  // one name a scenario
};

Names AllNames() {
  const std::map<std::string, std::string> all = AllScenarios();
  std::map<std::string, int> uses;
  for (const auto& [full, file] : all) ++uses[full.substr(full.find('/') + 1)];
  Names names;
  for (const auto& [full, file] : all) {
    const std::string folder = full.substr(0, full.find('/'));
    const std::string name = full.substr(full.find('/') + 1);
    names.file_of[full] = file;
    // worlds/a/b.json must not take the name "b" from worlds/b/b.json.
    const bool names_another_folder = folder != name && all.contains(name + "/" + name);
    const bool is_short = folder == name || (uses[name] == 1 && !names_another_folder);
    if (is_short) names.file_of[name] = file;
    names.shortest.push_back(is_short ? name : full);
  }
  std::sort(names.shortest.begin(), names.shortest.end());
  return names;
}

}  // namespace

std::vector<std::string> WorldFolders() {
  std::vector<std::string> folders;
  if (const char* const chosen = std::getenv("CCMORSE_WORLDS"); chosen != nullptr && *chosen) {
    folders.emplace_back(chosen);
  }
  // Worlds that are installed with the program come before those of the tree it was built from.
  const fs::path installed = fs::path("share") / "ccmorse" / "worlds";
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    folders.push_back((program.parent_path().parent_path() / installed).string());
  }
  // Within another program this is a library: PREFIX/lib/libX.so, or PREFIX/lib/TRIPLET/libX.so.
  Dl_info own{};
  if (::dladdr(reinterpret_cast<const void*>(&WorldFolders), &own) != 0) {
    const fs::path library = fs::weakly_canonical(own.dli_fname, error);
    const fs::path prefix = library.parent_path().parent_path();
    const bool in_library = !error && library.filename().string().starts_with("lib");
    for (const fs::path& each : {prefix, prefix.parent_path()}) {
      if (in_library && fs::is_directory(each / installed, error)) {
        folders.push_back((each / installed).string());
      }
    }
  }
  folders.emplace_back(CCMORSE_SOURCE_WORLDS);
  folders.emplace_back(CCMORSE_INSTALL_WORLDS);
  return folders;
}

std::string FindWorldFile(const std::string& name) {
  for (const std::string& root : WorldFolders()) {
    const fs::path file = fs::path(root) / name / "models" / "arena.json";
    if (IsFile(file)) return file.string();
  }
  return "";
}

std::vector<std::string> ListWorlds() {
  std::set<std::string> names;
  for (const std::string& root : WorldFolders()) {
    for (const fs::path& folder : Entries(root)) {
      if (IsFile(folder / "models" / "arena.json")) names.insert(folder.filename().string());
    }
  }
  return {names.begin(), names.end()};
}

std::string FindScenario(const std::string& name) {
  if (IsFile(name)) return name;
  const Names names = AllNames();
  const auto found = names.file_of.find(name);
  if (found != names.file_of.end()) return found->second;
  const std::vector<std::string> folders = WorldFolders();
  throw Error(fmt::format("no scenario {}{}; there is no such file, and {}; looked in {}",
                          Quoted(name), DidYouMean(name, names.shortest),
                          names.shortest.empty() ? "no scenarios are installed"
                                                 : "the scenarios are " + Listed(names.shortest),
                          Listed(folders)));
}

std::vector<std::string> ListScenarios() { return AllNames().shortest; }

}  // namespace ccmorse::scene
