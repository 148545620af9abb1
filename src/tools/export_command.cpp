// `ccmorse export`: packs a project for any machine that has ccmorse.

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "base/nearest_name.h"
#include "scene/field.h"
#include "scene/scenario.h"
#include "tools/command_line.h"
#include "tools/environments.h"
#include "tools/scene_choice.h"
#include "tools/zip_archive.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;

struct ExportArguments {
  std::string what;
  std::string out;
  std::vector<std::string> without;
};

// Folders and files that are made anew from the rest, or are of no use elsewhere.
bool IsLeftOut(const std::string& name, bool folder) {
  if (folder) {
    return name == ".git" || name == ".svn" || name == ".hg" || name == "__pycache__" ||
           name == "build" || name == "node_modules" || name == ".vscode" || name == ".idea" ||
           name.starts_with("obj-") || name == "CMakeFiles";
  }
  const std::string ending = fs::path(name).extension().string();
  constexpr std::array<std::string_view, 9> kEndings = {".o",   ".d",   ".a",   ".so",  ".pyc",
                                                        ".swp", ".gch", ".log", ".mcap"};
  return name.ends_with('~') || name == ".DS_Store" || name == "CMakeCache.txt" ||
         std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

// A program that was built for this machine.
bool IsElf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, 4> magic{};
  return in.read(magic.data(), magic.size()) && std::string_view(magic.data(), magic.size()) ==
                                                    "\x7f"
                                                    "ELF";
}

bool Contains(const fs::path& folder, const fs::path& path) {
  const fs::path relative = path.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

// Everything of the project below `folder`, in the order of names.
void Collect(const fs::path& root, const fs::path& folder, const std::string& prefix,
             std::vector<ZipSource>& files) {
  std::vector<fs::path> entries;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    entries.push_back(at->path());
  }
  if (failed) {
    throw Error(fmt::format("cannot read {}: {}", folder.string(), failed.message()));
  }
  std::sort(entries.begin(), entries.end());
  for (const fs::path& entry : entries) {
    const std::string name = entry.filename().string();
    const bool is_link = fs::is_symlink(entry, failed);
    const fs::file_status status = fs::status(entry, failed);
    if (IsLeftOut(name, fs::is_directory(status))) continue;
    if (is_link) {
      // A link to a file of the project becomes that file; archives with links are refused.
      const fs::path target = fs::weakly_canonical(entry, failed);
      if (!fs::exists(status) || fs::is_directory(status) || !Contains(root, target)) {
        throw Error(
            fmt::format("{} is a link to {}, which is {}; put the thing itself there, or "
                        "take the link away",
                        entry.string(), target.string(),
                        !fs::exists(status)        ? "not there"
                        : fs::is_directory(status) ? "a folder"
                                                   : "outside of the project"));
      }
    }
    if (fs::is_directory(status)) {
      Collect(root, entry, prefix + name + "/", files);
    } else if (fs::is_regular_file(status)) {
      if (IsElf(entry)) continue;
      const bool executable = (status.permissions() & fs::perms::owner_exec) != fs::perms::none;
      files.push_back({prefix + name, entry, executable});
    } else {
      throw Error(entry.string() + " is neither a file nor a folder; take it away first");
    }
  }
}

// A scenario's world must come along or be one that ccmorse brings.
void RequireWorld(const fs::path& scenario, const fs::path& root) {
  Json json;
  try {
    json = Json::Parse(ReadFile(scenario.string()));
  } catch (const std::exception&) {
    return;  // whoever runs it is told, with the line
  }
  const Json* const world = json.IsObject() ? json.Find("world") : nullptr;
  if (world == nullptr) return;
  const Json* const file = world->IsObject() ? world->Find("file") : nullptr;
  if (file != nullptr && file->IsString()) {
    const fs::path place =
        fs::weakly_canonical(scenario.parent_path() / fs::path(file->AsString()));
    if (!Contains(root, place)) {
      throw Error(fmt::format("{} needs {}, which is not in {}; copy it there and name the copy",
                              scenario.string(), place.string(), root.string()));
    }
  }
}

// The settings that Makefiles of a course's task include. They lie beside the task, once for all of
// them; in the archive they lie in the task's own folder, where the Makefiles look, too.
void AddSettings(const fs::path& root, const std::string& prefix, std::vector<ZipSource>& files) {
  const bool makes = std::any_of(files.begin(), files.end(), [](const ZipSource& file) {
    return file.file.filename() == "Makefile" &&
           ReadFile(file.file.string()).find(".mk") != std::string::npos;
  });
  if (!makes) return;
  std::error_code failed;
  for (const char* const name : {"ccmorse.mk", "task.mk"}) {
    if (fs::exists(root / name, failed)) continue;
    for (const fs::path& place : {root / ".." / name, root / ".." / ".." / "common" / name}) {
      if (!fs::is_regular_file(place, failed)) continue;
      files.push_back({prefix + name, fs::canonical(place), false});
      break;
    }
  }
}

// Takes the files and folders `without`, which lie directly in `root`, out of `files`.
void LeaveOut(const std::vector<std::string>& without, const fs::path& root,
              std::vector<ZipSource>& files) {
  for (const std::string& each : without) {
    const fs::path name = fs::path(each).lexically_normal();
    const fs::path place = name.has_filename() ? name : name.parent_path();
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(root)) {
      names.push_back(entry.path().filename().string());
    }
    if (std::find(names.begin(), names.end(), place.string()) == names.end()) {
      throw Error(fmt::format("there is no {} in {}{}", scene::Quoted(each), root.string(),
                              DidYouMean(each, names)));
    }
    const fs::path gone = root / place;
    files.erase(std::remove_if(files.begin(), files.end(),
                               [&gone](const ZipSource& file) {
                                 return file.file == gone || Contains(gone, file.file);
                               }),
                files.end());
  }
}

int Export(const ExportArguments& arguments, const std::string& program) {
  const Environments environments;
  const auto environment = environments.Find(arguments.what);
  std::error_code failed;
  fs::path root;
  std::string name;
  if (environment) {
    root = environment->folder;
    name = environment->name;
    if (!fs::is_directory(root, failed)) {
      throw Error(
          fmt::format("environment '{}' was in {}, which is gone; if it has moved: {} "
                      "import -f NEW_PLACE {}",
                      name, root.string(), program, name));
    }
    root = fs::canonical(root);
  } else if (fs::is_directory(arguments.what, failed)) {
    root = fs::canonical(arguments.what);
    name = root.filename().string();
  } else {
    std::vector<std::string> names;
    for (const Environment& each : environments.List()) names.push_back(each.name);
    throw Error(fmt::format("no environment or folder {}{}; `{} list` shows the environments",
                            scene::Quoted(arguments.what), DidYouMean(arguments.what, names),
                            program));
  }
  const std::optional<fs::path> start = DefaultScene(root);
  if (!start) {
    throw Error(
        fmt::format("{} does not look like a project: it holds neither scenario.json nor "
                    "default.py",
                    root.string()));
  }
  const fs::path archive =
      fs::weakly_canonical(fs::absolute(arguments.out.empty() ? name + ".zip" : arguments.out));
  if (fs::is_directory(archive, failed)) {
    throw Error(fmt::format("{} is a folder; name the file: -o {}", archive.string(),
                            (archive / (name + ".zip")).string()));
  }
  if (!fs::is_directory(archive.parent_path(), failed)) {
    throw Error(
        fmt::format("there is no folder {}; make it first", archive.parent_path().string()));
  }
  std::vector<ZipSource> files;
  Collect(root, root, name + "/", files);
  LeaveOut(arguments.without, root, files);
  AddSettings(root, name + "/", files);
  std::uint64_t bytes = 0;
  // An archive of earlier in the project's own folder does not belong into the next.
  files.erase(std::remove_if(files.begin(), files.end(),
                             [&archive](const ZipSource& file) { return file.file == archive; }),
              files.end());
  for (const ZipSource& file : files) {
    bytes += fs::file_size(file.file, failed);
    const bool scenario = file.file.extension() == ".json" && file.file.parent_path() == root;
    if (scenario) RequireWorld(file.file, root);
  }
  if (const ZipLimits limits; files.size() > limits.files || bytes > limits.bytes) {
    throw Error(fmt::format(
        "{} has {} files of {} MiB, more than `{} import` takes ({} files, {} "
        "MiB); take away what the project does not need",
        root.string(), files.size(), bytes >> 20, program, limits.files, limits.bytes >> 20));
  }
  WriteZip(archive, files);
  fmt::print("* {} holds {} files of {}.\n", archive.string(), files.size(), root.string());
  fmt::print("* Elsewhere: \"ccmorse import {}\", then \"ccmorse run {}\".\n",
             archive.filename().string(), name);
  return 0;
}

}  // namespace

void AddExportCommand(CommandLine& line) {
  const auto arguments = std::make_shared<ExportArguments>();
  CLI::App& command =
      line.Add("export", "pack a project with all it needs, for any machine with ccmorse",
               [arguments, program = line.program()] { return Export(*arguments, program); });
  command.add_option("what", arguments->what, "an environment, or a project's folder")
      ->required()
      ->type_name("NAME|DIR");
  command.add_option("-o,--out", arguments->out, "the archive  [NAME.zip]")->type_name("FILE.zip");
  command
      .add_option("--without", arguments->without,
                  "a file or folder of the project that stays here; may be given more than once")
      ->allow_extra_args(false)
      ->type_name("NAME");
  command.footer(
      "Examples:\n"
      "  ccmorse export PAR_PLANNING -o planning.zip\n"
      "  ccmorse export PAR_PLANNING --without solutions       what students get\n"
      "  ccmorse import planning.zip && ccmorse run PAR_PLANNING      on the other machine\n"
      "What was built, and records of runs, are left out (docs/command_line.md).");
}

}  // namespace ccmorse::tools
