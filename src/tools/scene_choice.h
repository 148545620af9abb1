#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/environments.h"

namespace ccmorse::tools {

/// Whether this build runs MORSE's builder scripts (*.py). Where it does not, `create` writes a
/// scenario.json beside default.py, so that what it made starts all the same.
inline constexpr bool kRunsBuilderScripts = true;

/// What `ccmorse run` starts.
struct SceneChoice {
  std::string file;  ///< scenario, .world, .cfg or builder script
  std::string name;  ///< the environment's, "" where none was named
  std::optional<Environment> environment;
  std::vector<std::string> arguments;  ///< for the script's sys.argv
  std::string note;                    ///< what the user should know of the choice, or ""
};

/// The scene that a project starts with: scenario.json; as MORSE has it default.py, else the first
/// *.py or *.blend by name; else the only *.json, *.world or *.cfg there is. Nothing when there is
/// none, or the folder cannot be read. When there are both scenario.json and default.py, `note`,
/// unless null, says which it is.
std::optional<std::filesystem::path> DefaultScene(const std::filesystem::path& folder,
                                                  std::string* note = nullptr);

/// What the words of `ccmorse run` mean: ENV [FILE] [ARGUMENT...] or FILE [ARGUMENT...], where FILE
/// may be a scenario's name or a project's folder, too. An environment comes before a file, as in
/// MORSE, a file before a scenario of that name, and that before a folder. Throws Error that says
/// what is near and what there is.
SceneChoice ChooseScene(const std::vector<std::string>& words, const Environments& environments);

/// Throws Error for what this build cannot run (a .blend, and a script unless kRunsBuilderScripts),
/// and for arguments to what takes none. As MORSE does, it takes any file for a script but .blend
/// and what is ours: .json, .world, .cfg, and what begins with a brace. For a script sets what
/// MORSE sets: PYTHONPATH begins with the environment's src, MORSE_RESOURCE_PATH with its data.
void PrepareScene(const SceneChoice& choice);

}  // namespace ccmorse::tools
