// `ccmorse pymorse-shim`: where the start-up code lies that pymorse needs with today's Python
// (specs: morse.md E.3).

#include <fmt/core.h>

#include "tools/builder_script.h"
#include "tools/command_line.h"

namespace ccmorse::tools {

void AddPymorseShimCommand(CommandLine& line) {
  CLI::App& command =
      line.Add("pymorse-shim", "print the folder for PYTHONPATH with which pymorse runs", [] {
        fmt::print("{}/pymorse_shim\n", FindPythonFolder());
        return 0;
      });
  command.footer(
      "MORSE's Python client, pymorse, fails in close() since Python 3.8, and cannot be imported\n"
      "since 3.12. With this folder in PYTHONPATH it does and can; no file of it is changed, and\n"
      "programs without pymorse run as ever. Tests made of morse.testing do not need it.\n"
      "Examples:\n"
      "  PYTHONPATH=$(ccmorse pymorse-shim) python3 my_client.py\n"
      "  export PYTHONPATH=$(ccmorse pymorse-shim):$PYTHONPATH");
}

}  // namespace ccmorse::tools
