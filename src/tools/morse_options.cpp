#include "tools/morse_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "base/error.h"

namespace ccmorse::tools {
namespace {

std::string CalledAs(int argc, const char* const* argv) {
  return argc > 0 ? std::filesystem::path(argv[0]).filename().string() : "";
}

}  // namespace

std::string ProgramName(int argc, const char* const* argv) {
  const std::string called = CalledAs(argc, argv);
  return called == "morse" || called == "morseexec" ? "morse" : "ccmorse";
}

Words SplitWords(int argc, const char* const* argv) {
  std::vector<std::string> words;
  if (CalledAs(argc, argv) == "morseexec") words.emplace_back("run");
  for (int i = 1; i < argc; ++i) words.emplace_back(argv[i]);
  Words split;
  const auto mark = std::find(words.begin(), words.end(), "--");
  if (mark != words.end() && std::find(words.begin(), mark, "run") != mark) {
    split.behind.assign(mark + 1, words.end());
    words.erase(mark, words.end());
  }
  split.reversed.assign(words.rbegin(), words.rend());
  return split;
}

void AddVersionOption(CLI::App& app, const std::string& program) {
  const std::string version = std::string("ccmorse ") + CCMORSE_VERSION;
  if (program == "morse") {
    app.set_version_flag("-v,--version", "morse 1.4 (" + version + ")");
  } else {
    app.set_version_flag("--version", version);
  }
}

void AddMorseOptions(CLI::App& app, MorseOptions& options) {
  // One group that help does not show: they are for those who type them by habit.
  app.add_flag("-n,--noaudio", options.no_audio)->group("");
  app.add_flag("-c,--color", options.color)->group("");
  app.add_flag("--reverse-color", options.reverse_color)->group("");
}

void AddMorseRunOptions(CLI::App& run, MorseOptions& options) {
  run.fallthrough();
  run.add_option("--name", options.node, "MORSE's: of this node, for its script; sets MORSE_NODE")
      ->type_name("NODE");
  run.add_option("-g,--geometry", options.geometry)->group("");
  run.add_option("-b,--base", options.base)->group("");
  run.add_option("--log", options.log)->group("");
}

void TellOfMorseOptions(const MorseOptions& options, const std::string& program) {
  if (!options.log.empty()) {
    throw Error(
        fmt::format("there is no --log; write what is printed into the file: {} run ... "
                    ">{} 2>&1",
                    program, options.log));
  }
  if (!options.base.empty()) {
    throw Error(
        fmt::format("-b {} is for Blender, which ccmorse does without; a builder script "
                    "says Environment('{}')",
                    options.base, options.base));
  }
  if (!options.node.empty()) ::setenv("MORSE_NODE", options.node.c_str(), 1);
  if (options.color || options.reverse_color) {
    fmt::print(stderr, "ccmorse: the log has no colours; --color has no effect\n");
  }
  if (!options.geometry.empty()) {
    fmt::print(stderr,
               "ccmorse: the view is a page of the browser, whose window has its own size; -g has "
               "no effect\n");
  }
}

}  // namespace ccmorse::tools
