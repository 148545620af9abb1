#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace ccmorse::tools {

/// MORSE's options that mean something else or nothing here.
struct MorseOptions {
  bool color = false;
  bool reverse_color = false;
  bool no_audio = false;
  std::string node;      ///< of a simulation on several machines
  std::string geometry;  ///< of Blender's window
  std::string base;      ///< Blender file of `edit`
  std::string log;
};

/// The name we were called by: "morse" for that and "morseexec", else "ccmorse". Messages tell
/// users to type it again.
std::string ProgramName(int argc, const char* const* argv);

/// The words of the command line.
struct Words {
  std::vector<std::string> reversed;  ///< as CLI11 wants them: the last one first
  std::vector<std::string> behind;    ///< of `run`: those behind "--", for a builder script
};

/// Behind `morseexec` comes `run`.
Words SplitWords(int argc, const char* const* argv);

/// --version; as `morse` also -v, and it names the MORSE that we stand for.
void AddVersionOption(CLI::App& app, const std::string& program);

/// MORSE's global options.
void AddMorseOptions(CLI::App& app, MorseOptions& options);

/// MORSE's options of `run`; the global ones may stand there, too.
void AddMorseRunOptions(CLI::App& run, MorseOptions& options);

/// Does what an option asks for, or says on stderr what to do instead. Throws Error for one that
/// a run without it would not be what was wanted.
void TellOfMorseOptions(const MorseOptions& options, const std::string& program);

}  // namespace ccmorse::tools
