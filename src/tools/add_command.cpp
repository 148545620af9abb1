// `ccmorse add`: templates of a robot, sensor or actuator of one's own.

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
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
#include "tools/child_process.h"
#include "tools/command_line.h"
#include "tools/environments.h"
#include "tools/project_files.h"
#include "tools/project_folder.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;

struct AddArguments {
  std::string name;
  std::string environment;
  std::optional<std::string> description;
  bool force = false;
  bool cpp = false;  // in C++ rather than Python
};

// The package in src that the environment's parts live in: of its own name, else the only one. An
// environment that was imported may have another name than its package.
std::string PackageOf(const Environment& environment) {
  const fs::path source = environment.folder / "src";
  std::error_code failed;
  if (fs::is_directory(source / environment.name, failed)) return environment.name;
  std::vector<std::string> packages;
  for (fs::directory_iterator at(source, failed), end; !failed && at != end; at.increment(failed)) {
    if (fs::exists(at->path() / "__init__.py")) packages.push_back(at->path().filename().string());
  }
  if (packages.size() == 1) return packages.front();
  std::sort(packages.begin(), packages.end());
  if (packages.size() > 1) {
    throw Error(
        fmt::format("{} has several packages, {}, and none is called {}: import it by the "
                    "name of the one to add to",
                    source.string(), scene::Listed(packages), environment.name));
  }
  const std::string folder = environment.folder.filename().string();
  for (const std::string& name : {environment.name, folder, AsPythonName(environment.name)}) {
    if (ProblemOfPythonName(name).empty()) return name;
  }
  throw Error(
      fmt::format("{} cannot be the name of a package of Python; import the environment by "
                  "another name",
                  scene::Quoted(environment.name)));
}

std::string AskForDescription(const std::string& kind) {
  fmt::print("Enter a short description of the {}, then Return: ", kind);
  std::fflush(stdout);
  std::string line;
  std::getline(std::cin, line);
  if (::isatty(STDIN_FILENO) == 0) fmt::print("\n");
  return line;
}

// What is in a file, or "" where there is none.
std::string TextOf(const fs::path& file) {
  std::error_code failed;
  return fs::exists(file, failed) ? ReadFile(file.string()) : "";
}

// The folder that holds ccmorse/plugin.h, as it is here.
std::string FindPluginInclude() {
  std::error_code ignored;
  const fs::path program = OwnProgram();
  for (const fs::path& folder :
       {program.parent_path() / "../include", fs::path(CCMORSE_SOURCE_INCLUDE)}) {
    if (fs::exists(folder / "ccmorse/plugin.h", ignored)) {
      return fs::weakly_canonical(folder, ignored).string();
    }
  }
  return "/usr/include";
}

int AddComponent(ComponentKind kind, const AddArguments& arguments, const std::string& program) {
  const std::string kind_name(KindName(kind));
  const std::string& name = arguments.name;
  const Environments environments;
  const auto environment = environments.Find(arguments.environment);
  if (!environment) {
    std::vector<std::string> names;
    for (const Environment& each : environments.List()) names.push_back(each.name);
    throw Error(
        fmt::format("no environment {}{}; {} create {} makes one, {} import FOLDER makes a "
                    "project's folder one",
                    scene::Quoted(arguments.environment), DidYouMean(arguments.environment, names),
                    program, AsPythonName(arguments.environment), program));
  }
  std::error_code failed;
  if (!fs::is_directory(environment->folder, failed)) {
    throw Error(
        fmt::format("environment '{}' was in {}, which is gone; if it has moved: {} import "
                    "-f NEW_PLACE {}",
                    environment->name, environment->folder.string(), program, environment->name));
  }
  if (const std::string problem = ProblemOfPythonName(name); !problem.empty()) {
    const std::string better = AsPythonName(name);
    throw Error(fmt::format(
        "{} cannot be the name of {} {}: it {}; use letters, digits and '_'{}", scene::Quoted(name),
        kind == ComponentKind::kActuator ? "an" : "a", kind_name, problem,
        better.empty()
            ? ""
            : fmt::format(": {} add {} {} {}", program, kind_name, better, environment->name)));
  }
  const std::string package = PackageOf(*environment);
  const fs::path& root = environment->folder;
  const auto make = [&](const std::string& description) {
    return arguments.cpp ? NewPlugin(kind, name, package, description, FindPluginInclude())
                         : NewComponent(kind, name, package, description);
  };
  std::vector<ProjectFile> files = make("");
  // The Makefile of other plug-ins is the user's by now.
  std::erase_if(files, [&](const ProjectFile& file) {
    return file.path.ends_with("/Makefile") && fs::exists(root / file.path);
  });
  const bool has_makefile = arguments.cpp && files.size() == 2;
  for (const ProjectFile& file : files) {
    if (!arguments.force && fs::exists(fs::symlink_status(root / file.path))) {
      throw Error(fmt::format("{} is there already; choose another name, or -f to replace it",
                              (root / file.path).string()));
    }
  }
  std::string description;
  if (arguments.description) {
    description = *arguments.description;
  } else if (kind != ComponentKind::kRobot) {
    description = AskForDescription(kind_name);
  }
  if (description.find_first_not_of(" \t") == std::string::npos) {
    description = fmt::format("The {} {}.", kind_name, name);
  }
  files = make(description);
  if (has_makefile) {
    std::erase_if(files, [](const ProjectFile& file) { return file.path.ends_with("/Makefile"); });
  }
  // What makes the folders packages, where it is missing; nothing of the user's is replaced.
  const std::string base = "src/" + package + "/";
  std::vector<std::string> packages = {base + "__init__.py", base + "builder/__init__.py"};
  if (!arguments.cpp) packages.push_back(base + kind_name + "s/__init__.py");
  for (const std::string& file : packages) {
    if (!fs::exists(root / file)) files.push_back({file, ""});
  }
  const std::string list = base + "builder/" + kind_name + "s/__init__.py";
  std::string text = TextOf(root / list);
  if (("\n" + text).find("\n" + BuilderImport(name)) == std::string::npos) {
    if (!text.empty() && text.back() != '\n') text += '\n';
    files.push_back({list, text + BuilderImport(name)});
  }
  WriteProjectFiles(root, files);
  fmt::print("* A new {} \"{}\" was added to environment \"{}\":\n", kind_name, name,
             environment->name);
  for (const ProjectFile& file : files) {
    if (!file.path.ends_with("__init__.py")) fmt::print("    {}\n", (root / file.path).string());
  }
  if (arguments.cpp) {
    fmt::print("* Build it by \"make -C {}\".\n",
               (root / ("src/" + package + "/plugins")).string());
  }
  fmt::print("* Use it in a builder script by \"from {}.builder.{}s import {}\".\n", package,
             kind_name, ClassName(name));
  return 0;
}

}  // namespace

void AddAddCommand(CommandLine& line) {
  // Known once the command is there; what is no kind is left for us to name.
  const auto self = std::make_shared<CLI::App*>(nullptr);
  CLI::App& command = line.Add(
      "add", "add the templates of a robot, sensor or actuator to an environment", [self]() -> int {
        const std::vector<std::string> words = (*self)->remaining();
        throw Error(
            fmt::format("add what{}? One of robot, sensor and actuator, as: ccmorse "
                        "add sensor NAME ENV",
                        words.empty() ? "" : " - " + scene::Quoted(words.front())));
      });
  *self = &command;
  command.require_subcommand(0, 1);
  command.allow_extras();
  // Each has its own help.
  for (const ComponentKind kind :
       {ComponentKind::kRobot, ComponentKind::kSensor, ComponentKind::kActuator}) {
    const std::string kind_name(KindName(kind));
    const auto arguments = std::make_shared<AddArguments>();
    CLI::App* const part = command.add_subcommand(kind_name, "add a " + kind_name);
    if (kind == ComponentKind::kActuator) part->description("add an actuator");
    part->add_option("name", arguments->name, "of the new " + kind_name)
        ->required()
        ->type_name("NAME");
    part->add_option("env", arguments->environment, "the environment it is for")
        ->required()
        ->type_name("ENV");
    part->add_option("-d,--description", arguments->description,
                     "one line on what it is; else sensors and actuators ask for it")
        ->type_name("TEXT");
    part->add_flag("-f,--force", arguments->force, "replace files that are there");
    if (kind != ComponentKind::kRobot) {
      part->add_flag("--cpp", arguments->cpp, "in C++, as a plug-in, rather than in Python");
    }
    part->allow_extras(false);
    part->footer(fmt::format("Example:\n  ccmorse add {} {} my_scene", kind_name,
                             kind == ComponentKind::kRobot    ? "rover"
                             : kind == ComponentKind::kSensor ? "thermometer"
                                                              : "pen"));
    line.AddTo(*part, [kind, arguments, program = line.program()] {
      return AddComponent(kind, *arguments, program);
    });
  }
  command.footer(
      "Examples:\n"
      "  ccmorse add robot rover my_scene\n"
      "  ccmorse add sensor thermometer my_scene -d \"Measures the heat of what is near.\"\n"
      "  ccmorse add actuator pen my_scene\n"
      "  ccmorse add sensor probe my_scene --cpp\n"
      "They are Python classes, or one of C++ with --cpp, to be changed and used in builder "
      "scripts\n(docs/components.md).");
}

}  // namespace ccmorse::tools
