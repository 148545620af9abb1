// `ccmorse completion`: what a shell offers after the Tab key, from the commands themselves.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "tools/command_line.h"

namespace ccmorse::tools {
namespace {

std::string OptionsOf(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::Option* const option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  }
  return fmt::format("{}", fmt::join(words, " "));
}

std::string CommandsOf(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::App* const each : command.get_subcommands({})) words.push_back(each->get_name());
  std::sort(words.begin(), words.end());
  return fmt::format("{}", fmt::join(words, " "));
}

int PrintBash(const CLI::App& app) {
  fmt::print(
      "# Completion of ccmorse, morse and morseexec for bash; ~/.bashrc loads it by\n"
      "#   eval \"$(ccmorse completion bash)\"\n"
      "_ccmorse() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} command=${{COMP_WORDS[1]}} words= names=\n"
      "  [ \"${{COMP_WORDS[0]##*/}}\" != morseexec ] || command=run\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ] && [ \"$command\" != run -o \"$word\" = run ]; then\n"
      "    COMPREPLY=($(compgen -W \"{}\" -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case $command in\n",
      CommandsOf(app));
  for (const CLI::App* const each : app.get_subcommands({})) {
    fmt::print("    {}) words=\"{} {}\" ;;\n", each->get_name(), CommandsOf(*each),
               OptionsOf(*each));
  }
  // Names may have blanks, so they come line by line.
  fmt::print(
      "  esac\n"
      "  case $command in\n"
      "    run | render | edit) names=$(ccmorse list --names "
      "2>/dev/null) ;;\n"
      "    rm | export | add) names=$(ccmorse list --names --environments 2>/dev/null) ;;\n"
      "  esac\n"
      "  local IFS=$'\\n'\n"
      "  COMPREPLY=($(compgen -W \"${{words// /$IFS}}$IFS$names\" -- \"$word\") $(compgen -f -- "
      "\"$word\"))\n"
      "}}\n"
      "complete -o filenames -F _ccmorse ccmorse morse morseexec\n");
  return 0;
}

}  // namespace

void AddCompletionCommand(CommandLine& line) {
  const auto shell = std::make_shared<std::string>();
  CLI::App& command = line.Add("completion", "print what completes commands and names in a shell",
                               [&line] { return PrintBash(line.app()); });
  command.add_option("shell", *shell, "bash")
      ->required()
      ->check(CLI::IsMember({"bash"}))
      ->type_name("SHELL");
  command.callback([shell] {});  // keeps the word as long as the command
  command.footer("Example, for ~/.bashrc:\n  eval \"$(ccmorse completion bash)\"");
}

}  // namespace ccmorse::tools
