#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ccmorse::tools {

/// A file of a project: path from its root, content.
struct ProjectFile {
  std::string path;
  std::string content;
  bool executable = false;
};

enum class ComponentKind { kRobot, kSensor, kActuator };

/// "robot", "sensor" or "actuator"; the folders of the kind have an s more.
std::string_view KindName(ComponentKind kind);

/// What keeps a name from being that of a Python package or module: "has a '-'", "is a word of
/// Python", ...; "" for a good one.
std::string ProblemOfPythonName(std::string_view name);

/// The nearest good name, "my_env" for "my env"; "" when there is none.
std::string AsPythonName(std::string_view name);

/// As Python's str.capitalize(), which MORSE makes class names with; ASCII only.
std::string ClassName(std::string_view name);

/// The files of a new environment, in MORSE's places (specification: MORSE 1.4's command line; the
/// thesis's section 4.1 has default.py's calls). With `with_scenario` also a scenario.json with the
/// same robot in a playground, for a ccmorse that does not run builder scripts.
std::vector<ProjectFile> NewProject(const std::string& name, bool with_scenario);

/// The files of a new component; `package` is the folder in src. `description` is one line of text
/// for the class. The __init__.py of builder/KINDs is not among them: see BuilderImport().
std::vector<ProjectFile> NewComponent(ComponentKind kind, const std::string& name,
                                      const std::string& package, const std::string& description);

/// The same for a sensor or actuator in C++: src/PACKAGE/plugins/NAME.cpp, a Makefile beside it
/// that builds every .cpp of the folder, and the class for builder scripts. `include` is the folder
/// of ccmorse/plugin.h here, which is used where pkg-config does not know ccmorse.
std::vector<ProjectFile> NewPlugin(ComponentKind kind, const std::string& name,
                                   const std::string& package, const std::string& description,
                                   const std::string& include);

/// The line for src/PACKAGE/builder/KINDs/__init__.py that lets scripts import the component.
std::string BuilderImport(const std::string& name);

}  // namespace ccmorse::tools
