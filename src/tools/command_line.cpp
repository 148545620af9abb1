#include "tools/command_line.h"

namespace ccmorse::tools {

void AddProjectCommands(CommandLine& line) {
  AddCreateCommand(line);
  AddImportCommand(line);
  AddExportCommand(line);
  AddRmCommand(line);
  AddAddCommand(line);
  AddEditCommand(line);
  AddCheckCommand(line);
  AddMultinodeServerCommand(line);
  AddPymorseShimCommand(line);
  AddCompletionCommand(line);
}

}  // namespace ccmorse::tools
