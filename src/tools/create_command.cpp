// `ccmorse create`: a new simulation environment, as `morse create` makes one.

#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "base/error.h"
#include "scene/field.h"
#include "tools/command_line.h"
#include "tools/environments.h"
#include "tools/project_files.h"
#include "tools/project_folder.h"
#include "tools/scene_choice.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;

struct CreateArguments {
  std::string place;
  bool force = false;
};

int Create(const CreateArguments& arguments, const std::string& program) {
  // "x/" is x.
  fs::path place = fs::absolute(arguments.place).lexically_normal();
  if (!place.has_filename()) place = place.parent_path();
  const std::string name = place.filename().string();
  if (const std::string problem = ProblemOfPythonName(name); !problem.empty()) {
    const std::string better = AsPythonName(name);
    throw Error(fmt::format(
        "{} cannot be the name of an environment: it {}, and the name becomes a package of Python; "
        "use letters, digits and '_'{}",
        scene::Quoted(name), problem,
        better.empty() ? "" : fmt::format(": {} create {}", program, better)));
  }
  Environments environments;
  const auto old = environments.Find(name);
  if (old && !arguments.force) {
    throw Error(
        fmt::format("there is an environment '{}' already, in {}; choose another name, or "
                    "forget it first: {} rm {}",
                    old->name, old->folder.string(), program, old->name));
  }
  if (fs::exists(fs::symlink_status(place))) {
    if (!arguments.force) {
      throw Error(
          fmt::format("{} is there already; choose another name, or make it an environment "
                      "as it is: {} import {}",
                      place.string(), program, arguments.place));
    }
    fmt::print("* The former {} lies in {} now.\n", place.string(),
               MoveToTrash(place, environments.home()).string());
  }
  NewFolder folder(place);
  WriteProjectFiles(folder.path(), NewProject(name, !kRunsBuilderScripts));
  folder.Keep();
  try {
    environments.Set({name, place, true});
  } catch (const Error& error) {
    throw Error(fmt::format("{} was made, but is no environment yet: {}; until then: {} run {}",
                            place.string(), error.what(), program, place.string()));
  }
  if (old && old->folder != place) {
    fmt::print("* '{}' was {} before, which stays as it is.\n", name, old->folder.string());
  }
  fmt::print("* A new simulation environment has been successfully created in <{}>.\n",
             place.string());
  fmt::print("* You can run it directly with \"{} run {}\" or you can start editing it.\n", program,
             name);
  return 0;
}

}  // namespace

void AddCreateCommand(CommandLine& line) {
  const auto arguments = std::make_shared<CreateArguments>();
  CLI::App& command =
      line.Add("create", "make a new simulation environment, with a robot in a playground",
               [arguments, program = line.program()] { return Create(*arguments, program); });
  command
      .add_option("env", arguments->place,
                  "its name, a folder of which is made here (or the folder's path)")
      ->required()
      ->type_name("ENV");
  command.add_flag("-f,--force", arguments->force,
                   "even where there is one: the former folder goes into the trash");
  command.footer(
      "Examples:\n"
      "  ccmorse create my_scene && ccmorse run my_scene\n"
      "  ccmorse create ~/School/first            called first\n"
      "docs/command_line.md tells what is in it.");
}

}  // namespace ccmorse::tools
