// `ccmorse edit`: MORSE opened Blender there.

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "tools/command_line.h"
#include "tools/environments.h"
#include "tools/scene_choice.h"

namespace ccmorse::tools {
namespace {

struct EditArguments {
  std::vector<std::string> words;
  std::string base;
};

int Edit(const EditArguments& arguments, const std::string& program) {
  const SceneChoice choice = ChooseScene(arguments.words, Environments());
  fmt::print(stderr,
             "ccmorse: there is no editor, as scenes are text. Instead:\n"
             "  edit {} with any editor, then\n"
             "  {} run {}   shows it in the browser; the robots' places and the obstacles can be "
             "tried there (docs/view.md)\n",
             choice.file, program, fmt::join(arguments.words, " "));
  if (!arguments.base.empty()) {
    fmt::print(stderr, "  -b {}: worlds of Blender come in as models (docs/scenario.md)\n",
               arguments.base);
  }
  return 1;
}

}  // namespace

void AddEditCommand(CommandLine& line) {
  const auto arguments = std::make_shared<EditArguments>();
  CLI::App& command =
      line.Add("edit", "say how to edit a scene: MORSE opened Blender for it",
               [arguments, program = line.program()] { return Edit(*arguments, program); });
  command.add_option("scene", arguments->words, "an environment, then one of its files; or a file")
      ->required()
      ->type_name("ENV|FILE");
  command.add_option("-b,--base", arguments->base, "MORSE's: a Blender file to begin with")
      ->type_name("BASE");
}

}  // namespace ccmorse::tools
