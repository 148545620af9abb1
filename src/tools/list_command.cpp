#include "tools/list_command.h"

#include <fmt/core.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "scene/scenario.h"
#include "tools/environments.h"
#include "tools/scene_choice.h"

namespace ccmorse::tools {

int List(const ListArguments& arguments) {
  if (!arguments.environments) {
    for (const std::string& name : scene::ListScenarios()) fmt::print("{}\n", name);
  }
  for (const Environment& each : Environments().List()) {
    if (arguments.names) {
      fmt::print("{}\n", each.name);
      continue;
    }
    std::error_code failed;
    const char* const state = !std::filesystem::is_directory(each.folder, failed) ? ", gone"
                              : !DefaultScene(each.folder) ? ", without a scene"
                                                           : "";
    fmt::print("{}  ({}{})\n", each.name, each.folder.string(), state);
  }
  return 0;
}

}  // namespace ccmorse::tools
