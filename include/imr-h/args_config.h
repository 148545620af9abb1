#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "imr-h/imr_config.h"

namespace imr {

/// What `--help` says about a program beside its options.
struct SProgram {
  /// What the program does, one or a few lines; may be empty.
  std::string about;
  /// Arguments worth showing, without the program's name: "--host robot3 --port 4000".
  std::vector<std::string> examples;
};

/// Sets options from the command line of a program.
///
/// Every option of `config` is given as `--name value` or `--name=value`; a bool also as `--name`
/// alone, which means true. An option given twice keeps the last value. `--help` or `-h` writes all
/// options with their descriptions and defaults, and the examples, to `out`.
///
/// Either all options given are set or, on an error, none.
///
/// @param argc,argv As main() gets them; argv[0] is the program's name.
/// @param config    Options that are known already (CConfig::add).
/// @param program   Text for --help.
/// @param out       Where the help goes.
/// @return False if the help was written, and the program should end with success.
/// @throws bad_usage with a message of one line: an unknown option (with the nearest known one), a
///         value missing or of the wrong type, or an argument that is no option.
bool parseArguments(int argc, const char* const* argv, CConfig& config, const SProgram& program,
                    std::ostream& out);

/// The same with the help on standard output.
bool parseArguments(int argc, const char* const* argv, CConfig& config,
                    const SProgram& program = SProgram());

}  // namespace imr
