#pragma once

#include <string>
#include <vector>

#include "scene/player/import.h"

namespace ccmorse::tools {

/// What a MORSE builder script is run with.
struct ScriptOptions {
  std::vector<std::string> arguments;    ///< in the script's sys.argv, after "--"
  std::vector<std::string> environment;  ///< "NAME=VALUE", beside ours: MORSE_RESOURCE_PATH, ...
  double time_limit = 120.0;             ///< s of wall time for the script, > 0
};

/// Is this file one to be run by SceneFromScript: does its name end with .py, or has it no ending
/// and no JSON in it? (MORSE runs scripts of any name; its tests have some without an ending.)
bool IsBuilderScript(const std::string& file);

/// The scenario that a MORSE builder script makes (docs/morse.md), and what it asks for that the
/// simulator has not. The script runs in a python3 of its own, with our package morse on its path,
/// prints where we print, and ends when we do. Throws Error when there is no python3 or no package
/// morse, when the script fails (it has said why), takes too long or makes too large a scene, and
/// "FILE:LINE: ..." when its scene cannot be. No other thread may have been started before. Source:
/// specs: morse.md C and D.
scene::ImportedScenario SceneFromScript(const std::string& file, const ScriptOptions& options = {});

/// The scenario of this name or file, or what the builder script makes of `arguments`, which
/// nothing else takes. Throws Error as scene::ImportScenario() and SceneFromScript() do.
scene::ImportedScenario ImportScene(const std::string& name,
                                    const std::vector<std::string>& arguments = {});

/// The folder that holds our package morse: python/ of the source tree, or share/ccmorse/python
/// where it is installed. Throws Error that names the places looked at.
std::string FindPythonFolder();

}  // namespace ccmorse::tools
