// `ccmorse rm`: forgets an environment, and takes away those that `ccmorse create` made.

#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "base/nearest_name.h"
#include "scene/field.h"
#include "tools/command_line.h"
#include "tools/environments.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;

struct RmArguments {
  std::string name;
  bool force = false;
  bool destroy = false;
  bool keep = false;
};

bool SaysYes(const std::string& question) {
  fmt::print("{} [y/N] ", question);
  std::fflush(stdout);
  std::string answer;
  if (!std::getline(std::cin, answer)) fmt::print("\n");
  return answer == "y" || answer == "Y" || answer == "yes";
}

[[noreturn]] void RefuseUnknown(const std::string& name, const Environments& environments) {
  std::vector<std::string> names;
  for (const Environment& each : environments.List()) names.push_back(each.name);
  throw Error(fmt::format("no environment {}{}; {}", scene::Quoted(name), DidYouMean(name, names),
                          names.empty() ? "none was created or imported yet"
                                        : "the environments are " + scene::Listed(names)));
}

// Why the folder has to stay, or nothing where it may go: `create` made it, it still is a folder of
// its own, and nobody else needs it.
std::optional<std::string> ReasonToStay(const Environment& environment,
                                        const Environments& environments) {
  std::error_code failed;
  const fs::file_status status = fs::symlink_status(environment.folder, failed);
  const std::string folder = environment.folder.string();
  if (!fs::exists(status)) return folder + " was gone already";
  if (!environment.created || !fs::is_directory(status)) return folder + " stays as it is";
  for (const Environment& other : environments.List()) {
    if (other.name == environment.name || other.folder != environment.folder) continue;
    return fmt::format("{} stays, as environment \"{}\" is there, too", folder, other.name);
  }
  return std::nullopt;
}

int Remove(const RmArguments& arguments) {
  Environments environments;
  const auto environment = environments.Find(arguments.name);
  if (!environment) RefuseUnknown(arguments.name, environments);
  const std::string folder = environment->folder.string();
  std::optional<std::string> stays = ReasonToStay(*environment, environments);
  if (arguments.keep && !stays) stays = folder + " stays as it is";
  if (stays) {
    environments.Forget(environment->name);
    fmt::print("* \"{}\" is no environment any more; {}.\n", environment->name, *stays);
    return 0;
  }
  const std::string what = arguments.destroy ? "Delete for good" : "Move to the trash";
  if (!arguments.force && !SaysYes(fmt::format("{} {} and all that is in it?", what, folder))) {
    fmt::print(stderr, "* Nothing was removed.\n");
    return 1;
  }
  if (arguments.destroy) {
    std::error_code failed;
    fs::remove_all(environment->folder, failed);
    if (failed) {
      throw Error(fmt::format("cannot delete all of {}: {}; what is left is still environment '{}'",
                              folder, failed.message(), environment->name));
    }
    environments.Forget(environment->name);
    fmt::print("* Environment \"{}\" was removed, {} deleted.\n", environment->name, folder);
    return 0;
  }
  fs::path now;
  try {
    now = MoveToTrash(environment->folder, environments.home());
  } catch (const Error& error) {
    throw Error(
        fmt::format("{}; use --delete to delete it for good, or --keep to keep it", error.what()));
  }
  environments.Forget(environment->name);
  fmt::print("* Environment \"{}\" was removed; its files lie in {}.\n", environment->name,
             now.string());
  return 0;
}

}  // namespace

void AddRmCommand(CommandLine& line) {
  const auto arguments = std::make_shared<RmArguments>();
  CLI::App& command =
      line.Add("rm", "remove an environment; of an imported one, forget the name only",
               [arguments] { return Remove(*arguments); });
  command.add_option("env", arguments->name, "its name")->required()->type_name("ENV");
  command.add_flag("-f,--force,-y,--yes", arguments->force, "without asking");
  CLI::Option* const destroy =
      command.add_flag("--delete", arguments->destroy,
                       "delete what `create` made, instead of moving it to the trash");
  command.add_flag("--keep", arguments->keep, "forget the name only")->excludes(destroy);
  command.footer(
      "Examples:\n"
      "  ccmorse rm my_scene                      asks, then its folder goes into the trash\n"
      "  ccmorse rm PAR_PLANNING                  was imported: its folder stays as it is\n"
      "Exit status: 1 where the answer was no.");
}

}  // namespace ccmorse::tools
