#include "imr-h/args_config.h"

#include <algorithm>
#include <iostream>
#include <string_view>
#include <utility>

#include "base/nearest_name.h"

namespace imr {
namespace {

// How an option is written in the help: "--port INT", a bool without a value.
std::string usageOf(const CConfig::SItem& item) {
  switch (item.type) {
    case CConfig::STRING:
      return "--" + item.name + " TEXT";
    case CConfig::INT:
      return "--" + item.name + " INT";
    case CConfig::DOUBLE:
    case CConfig::FLOAT:
      return "--" + item.name + " NUMBER";
    case CConfig::BOOL:
    case CConfig::NUM_TYPES:
      break;
  }
  return "--" + item.name;
}

void printHelp(const std::string& programName, const CConfig& config, const SProgram& program,
               std::ostream& out) {
  if (!program.about.empty()) out << program.about << "\n\n";
  out << "Usage: " << programName << " [options]\n\nOptions:\n";
  const std::string help = "--help";
  std::size_t width = help.size();
  for (const CConfig::SItem& item : config) width = std::max(width, usageOf(item).size());
  for (const CConfig::SItem& item : config) {
    const std::string usage = usageOf(item);
    out << "  " << usage << std::string(width - usage.size() + 2, ' ')
        << config.getDescriptionText(item.name);
    const std::string defaultText = config.getDefaultText(item.name);
    if (!defaultText.empty()) out << " [" << defaultText << "]";
    out << '\n';
  }
  out << "  " << help << std::string(width - help.size() + 2, ' ') << "show this text\n";
  if (!program.examples.empty()) out << "\nExamples:\n";
  for (const std::string& example : program.examples) {
    out << "  " << programName << (example.empty() ? "" : " ") << example << '\n';
  }
}

bool isBoolWord(std::string_view text) {
  for (const std::string_view word : {"true", "false", "yes", "no", "on", "off", "1", "0"}) {
    if (text == word) return true;
  }
  return false;
}

// "/usr/bin/intro" -> "intro": what a user types is shorter than where it was found.
std::string baseName(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

[[noreturn]] void throwUnknown(const std::string& name, const CConfig& config) {
  CConfig::NameList known = {"help"};
  for (const CConfig::SItem& item : config) known.push_back(item.name);
  const std::string nearest = ccmorse::NearestName(name, known);
  throw bad_usage("unknown option --" + name +
                  (nearest.empty() ? "" : "; did you mean --" + nearest + "?") +
                  " (--help lists all)");
}

}  // namespace

bool parseArguments(int argc, const char* const* argv, CConfig& config, const SProgram& program,
                    std::ostream& out) {
  // Everything is read and checked before the first option is set.
  std::vector<std::pair<std::string, std::string>> given;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--help" || argument == "-h") {
      printHelp(argc > 0 ? baseName(argv[0]) : "program", config, program, out);
      return false;
    }
    if (argument.size() < 3 || argument.compare(0, 2, "--") != 0) {
      throw bad_usage("unexpected argument \"" + argument +
                      "\"; an option is written --name value" + " (--help lists all)");
    }
    const std::size_t equals = argument.find('=');
    const std::string name =
        argument.substr(2, equals == std::string::npos ? std::string::npos : equals - 2);
    if (!config.has(name)) throwUnknown(name, config);

    std::string value;
    if (equals != std::string::npos) {
      value = argument.substr(equals + 1);
    } else if (config.getType(name) == CConfig::BOOL) {
      const bool valueFollows = i + 1 < argc && isBoolWord(argv[i + 1]);
      value = valueFollows ? argv[++i] : "true";
    } else {
      // A value that begins with two dashes is most likely the next option; `=` can give it still.
      if (i + 1 >= argc || std::string_view(argv[i + 1]).substr(0, 2) == "--") {
        throw bad_usage("option --" + name + " needs a value");
      }
      value = argv[++i];
    }
    config.checkText(name, value);
    given.emplace_back(name, value);
  }
  for (const auto& [name, value] : given) config.setText(name, value);
  return true;
}

bool parseArguments(int argc, const char* const* argv, CConfig& config, const SProgram& program) {
  return parseArguments(argc, argv, config, program, std::cout);
}

}  // namespace imr
