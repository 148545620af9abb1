// `ccmorse import`: makes a project's folder, or a zip of one, an environment.

#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "base/error.h"
#include "scene/field.h"
#include "scene/scenario.h"
#include "tools/command_line.h"
#include "tools/environments.h"
#include "tools/project_folder.h"
#include "tools/scene_choice.h"
#include "tools/zip_archive.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;

struct ImportArguments {
  std::string path;
  std::string name;
  std::string to;
  bool force = false;
};

// The name is free, or the user wants to have it so.
void RequireFree(const std::string& name, const fs::path& folder, const ImportArguments& arguments,
                 const Environments& environments, const std::string& program) {
  RequireEnvironmentName(name, fmt::format("{} import {} NAME", program, arguments.path));
  const auto old = environments.Find(name);
  if (old && old->folder != folder && !arguments.force) {
    throw Error(
        fmt::format("environment '{}' is {} already; give this one another name: {} import "
                    "{} NAME, or take the name for it: -f",
                    old->name, old->folder.string(), program, arguments.path));
  }
  if (old || arguments.force) return;
  for (const std::string& scenario : scene::ListScenarios()) {
    if (scenario != name) continue;
    throw Error(
        fmt::format("'{}' is the name of a scenario that comes with ccmorse; give this one "
                    "another name: {} import {} NAME, or take the name for it: -f",
                    name, program, arguments.path));
  }
}

void Register(const std::string& name, const fs::path& folder, Environments& environments,
              const std::string& program) {
  const auto old = environments.Find(name);
  // What `create` made stays so if it is imported once more by its own name.
  const bool created = old && old->created && old->folder == folder;
  environments.Set({name, folder, created});
  fmt::print("* <{}> is environment \"{}\" now.\n", folder.string(), name);
  fmt::print("* You can run it with \"{} run {}\".\n", program,
             name.find(' ') == std::string::npos ? name : "'" + name + "'");
}

int ImportFolder(const ImportArguments& arguments, const std::string& program) {
  const fs::path folder = fs::canonical(arguments.path);
  const std::string name = arguments.name.empty() ? folder.filename().string() : arguments.name;
  Environments environments;
  RequireFree(name, folder, arguments, environments, program);
  if (!DefaultScene(folder) && !arguments.force) {
    throw Error(
        fmt::format("{} does not look like a project: it holds neither scenario.json nor "
                    "default.py; import it all the same: -f",
                    folder.string()));
  }
  Register(name, folder, environments, program);
  return 0;
}

int ImportZip(const ImportArguments& arguments, const std::string& program) {
  const fs::path archive = arguments.path;
  const ZipContents contents = ReadZip(archive);
  const std::string name = !arguments.name.empty() ? arguments.name
                           : !contents.top.empty() ? contents.top
                                                   : archive.stem().string();
  RequireEnvironmentName(name, fmt::format("{} import {} NAME", program, arguments.path));
  fs::path place = fs::absolute(arguments.to.empty() ? name : arguments.to).lexically_normal();
  if (!place.has_filename()) place = place.parent_path();
  std::error_code failed;
  const fs::path parent = fs::canonical(place.parent_path(), failed);
  if (!failed) place = parent / place.filename();
  Environments environments;
  RequireFree(name, place, arguments, environments, program);
  if (fs::exists(fs::symlink_status(place))) {
    throw Error(
        fmt::format("{} is there already; unpack into another folder: {} import {} {}--to "
                    "FOLDER",
                    place.string(), program, arguments.path,
                    arguments.name.empty() ? "" : arguments.name + " "));
  }
  NewFolder folder(place);
  Unzip(archive, contents, folder.path());
  if (!DefaultScene(folder.path()) && !arguments.force) {
    throw Error(
        fmt::format("{} does not hold a project: there is neither scenario.json nor "
                    "default.py in it; import it all the same: -f",
                    archive.string()));
  }
  folder.Keep();
  fmt::print("* {} was unpacked.\n", archive.string());
  Register(name, place, environments, program);
  return 0;
}

int Import(const ImportArguments& arguments, const std::string& program) {
  const fs::path path = arguments.path;
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  if (!fs::exists(status)) {
    throw Error(
        fmt::format("there is no {}: {}; name a project's folder, or a zip that `{} "
                    "export` made",
                    arguments.path, failed ? failed.message() : "it is missing", program));
  }
  if (fs::is_directory(status)) {
    if (!arguments.to.empty()) throw Error("--to is for archives; a folder stays where it is");
    return ImportFolder(arguments, program);
  }
  if (fs::is_regular_file(status) && path.extension() == ".zip") {
    return ImportZip(arguments, program);
  }
  const std::string folder = fs::absolute(path).lexically_normal().parent_path().string();
  throw Error(
      fmt::format("{} is a file; import its folder: {} import {}, or run it as it is: {} "
                  "run {}",
                  arguments.path, program, folder, program, arguments.path));
}

}  // namespace

void AddImportCommand(CommandLine& line) {
  const auto arguments = std::make_shared<ImportArguments>();
  CLI::App& command =
      line.Add("import", "make a project's folder, or a zip of one, an environment",
               [arguments, program = line.program()] { return Import(*arguments, program); });
  command.add_option("path", arguments->path, "the folder, which stays where it is, or the zip")
      ->required()
      ->type_name("PATH");
  command.add_option("name", arguments->name, "to run it by  [the folder's]")->type_name("NAME");
  command
      .add_option("--to", arguments->to, "where a zip is unpacked; must not be there yet  [./NAME]")
      ->type_name("FOLDER");
  command.add_flag("-f,--force", arguments->force,
                   "take the name from another environment; take a folder without a scene");
  command.footer(
      "Examples:\n"
      "  ccmorse import courses/par/planning PAR_PLANNING && ccmorse run PAR_PLANNING\n"
      "  ccmorse import ~/School/PAR_INTRO        called PAR_INTRO\n"
      "  ccmorse import planning.zip              unpacks it here, into a folder of its own");
}

}  // namespace ccmorse::tools
