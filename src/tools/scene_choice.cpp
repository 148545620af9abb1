#include "tools/scene_choice.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/log.h"
#include "base/nearest_name.h"
#include "scene/field.h"
#include "scene/scenario.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;

bool IsFile(const fs::path& path) {
  std::error_code failed;
  return fs::exists(path, failed) && !fs::is_directory(path, failed);
}

bool IsFolder(const fs::path& path) {
  std::error_code failed;
  return fs::is_directory(path, failed);
}

std::vector<fs::path> FilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    if (IsFile(at->path())) files.push_back(at->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool IsScene(const fs::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".json" || ending == ".world" || ending == ".cfg";
}

bool IsScript(const fs::path& file) {
  if (IsScene(file) || file.extension() == ".blend") return false;
  if (file.extension() == ".py") return true;
  std::ifstream text(file);
  char first = ' ';
  return !(text >> first) || first != '{';
}

SceneChoice OfFolder(const fs::path& folder, const std::string& called) {
  SceneChoice choice;
  const std::optional<fs::path> scene = DefaultScene(folder, &choice.note);
  if (!scene) {
    throw Error(
        fmt::format("{} has no scene to start with: {} holds neither scenario.json nor "
                    "default.py; name the file: ccmorse run {} FILE",
                    called, folder.string(), called));
  }
  choice.file = scene->string();
  return choice;
}

SceneChoice OfEnvironment(const Environment& environment, const std::vector<std::string>& words) {
  if (!IsFolder(environment.folder)) {
    throw Error(fmt::format(
        "environment '{}' was in {}, which is {}; if it has moved: ccmorse import -f NEW_PLACE {}; "
        "to forget it: ccmorse rm {}",
        environment.name, environment.folder.string(),
        IsFile(environment.folder) ? "a file now" : "gone", environment.name, environment.name));
  }
  SceneChoice choice;
  if (words.size() < 2) {
    choice = OfFolder(environment.folder, environment.name);
  } else {
    const fs::path own = environment.folder / words[1];
    if (IsFile(own)) {
      choice.file = own.string();
    } else if (IsFile(words[1])) {
      choice.file = words[1];
    } else {
      std::vector<std::string> names;
      for (const fs::path& file : FilesIn(environment.folder)) {
        const bool fine = IsScene(file) || file.extension() == ".py";
        if (fine) names.push_back(file.filename().string());
      }
      throw Error(fmt::format("environment '{}' has no file {}{}; {}", environment.name,
                              scene::Quoted(words[1]), DidYouMean(words[1], names),
                              names.empty()
                                  ? "there are no scenes in " + environment.folder.string()
                                  : "its scenes are " + scene::Listed(names)));
    }
    choice.arguments.assign(words.begin() + 2, words.end());
  }
  choice.name = environment.name;
  choice.environment = environment;
  return choice;
}

// A config file that cannot be read keeps nobody from what is not in it.
std::optional<Environment> FindReadable(const Environments& environments, const std::string& name) {
  try {
    return environments.Find(name);
  } catch (const Error& error) {
    LogWarning("environments are not known: {}", error.what());
    return std::nullopt;
  }
}

void Prepend(const char* variable, const fs::path& folder) {
  const char* const old = std::getenv(variable);
  const std::string value =
      old != nullptr && *old != '\0' ? folder.string() + ":" + old : folder.string();
  ::setenv(variable, value.c_str(), 1);
}

}  // namespace

std::optional<fs::path> DefaultScene(const fs::path& folder, std::string* note) {
  const fs::path scenario = folder / "scenario.json";
  const fs::path script = folder / "default.py";
  if (IsFile(scenario)) {
    if (note != nullptr && IsFile(script)) {
      *note =
          fmt::format("{} starts with scenario.json; its default.py {}", folder.filename().string(),
                      kRunsBuilderScripts ? "starts when it is named"
                                          : "needs builder scripts, which are not run yet");
    }
    return scenario;
  }
  if (IsFile(script)) return script;
  std::vector<fs::path> scenes;
  for (const fs::path& file : FilesIn(folder)) {
    if (file.extension() == ".py" || file.extension() == ".blend") return file;
    if (IsScene(file)) scenes.push_back(file);
  }
  if (scenes.size() == 1) return scenes.front();
  return std::nullopt;
}

SceneChoice ChooseScene(const std::vector<std::string>& words, const Environments& environments) {
  if (words.empty() || words.front().empty()) {
    throw Error(
        "run what? Name an environment, a scenario or a file; `ccmorse list` shows what "
        "there is");
  }
  const std::string& what = words.front();
  if (const auto environment = FindReadable(environments, what)) {
    return OfEnvironment(*environment, words);
  }
  SceneChoice choice;
  const std::vector<std::string> scenarios = scene::ListScenarios();
  const bool known = std::find(scenarios.begin(), scenarios.end(), what) != scenarios.end();
  if (IsFile(what)) {
    choice.file = what;
  } else if (!known && IsFolder(what)) {
    choice = OfFolder(fs::weakly_canonical(what), what);
  } else {
    std::vector<std::string> names = scenarios;
    try {
      choice.file = scene::FindScenario(what);
    } catch (const Error&) {
      for (const Environment& each : environments.List()) names.push_back(each.name);
      std::string message =
          fmt::format("no environment, file or scenario {}{}; there are {}", scene::Quoted(what),
                      DidYouMean(what, names), names.empty() ? "none" : scene::Listed(names));
      if (what.find('/') == std::string::npos && words.size() == 1) {
        message += "; a project's folder becomes an environment by: ccmorse import FOLDER";
      }
      throw Error(message);
    }
  }
  choice.arguments.assign(words.begin() + 1, words.end());
  return choice;
}

void PrepareScene(const SceneChoice& choice) {
  if (fs::path(choice.file).extension() == ".blend") {
    throw Error(
        fmt::format("{} is a scene of Blender itself, which ccmorse does not run; a builder "
                    "script that says Environment('{}') does",
                    choice.file, fs::path(choice.file).filename().string()));
  }
  if (!IsScript(choice.file)) {
    if (choice.arguments.empty()) return;
    throw Error(fmt::format("{} takes no arguments, only builder scripts do; what is {} for?",
                            choice.file, scene::Quoted(choice.arguments.front())));
  }
  if (!kRunsBuilderScripts) {
    throw Error(
        fmt::format("{} is a builder script of MORSE, which this version of ccmorse does "
                    "not run yet; put what it builds into {} (docs/scenario.md)",
                    choice.file, (fs::path(choice.file).parent_path() / "scenario.json").string()));
  }
  if (!choice.environment) return;
  Prepend("PYTHONPATH", choice.environment->folder / "src");
  Prepend("MORSE_RESOURCE_PATH", choice.environment->folder / "data");
}

}  // namespace ccmorse::tools
