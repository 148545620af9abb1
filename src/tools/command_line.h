#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ccmorse::tools {

/// The sub-commands that register themselves: each has a file with its options, help, examples and
/// what it does, and one line in AddProjectCommands(). Not thread safe.
class CommandLine {
 public:
  /// `app` must outlive this. `program` is the name that the user called us by.
  CommandLine(CLI::App& app, std::string program) : app_(app), program_(std::move(program)) {}

  /// A new sub-command; `act` returns the exit status and may throw Error.
  CLI::App& Add(const std::string& name, const std::string& what, std::function<int()> act) {
    CLI::App* const command = app_.add_subcommand(name, what);
    commands_.push_back({command, std::move(act)});
    return *command;
  }

  /// What a sub-command of a sub-command does; it comes before the one above it.
  void AddTo(CLI::App& command, std::function<int()> act) {
    commands_.insert(commands_.begin(), {&command, std::move(act)});
  }

  /// Does what was asked for; nothing when it was none of these commands.
  std::optional<int> Execute() const {
    for (const Command& each : commands_) {
      if (each.command->parsed()) return each.act();
    }
    return std::nullopt;
  }

  CLI::App& app() { return app_; }

  /// "ccmorse", or "morse": what messages tell the user to type.
  const std::string& program() const { return program_; }

 private:
  struct Command {
    CLI::App* command;
    std::function<int()> act;
  };
  CLI::App& app_;
  std::string program_;
  std::vector<Command> commands_;
};

/// All commands that deal with projects: add, check, completion, create, edit, export, import, rm;
/// and those that bring along what MORSE's users have: multinode-server, pymorse-shim.
void AddProjectCommands(CommandLine& line);

/// One each, in the file of that name.
void AddAddCommand(CommandLine& line);
void AddCheckCommand(CommandLine& line);
void AddCompletionCommand(CommandLine& line);
void AddCreateCommand(CommandLine& line);
void AddEditCommand(CommandLine& line);
void AddExportCommand(CommandLine& line);
void AddImportCommand(CommandLine& line);
void AddMultinodeServerCommand(CommandLine& line);
void AddPymorseShimCommand(CommandLine& line);
void AddRmCommand(CommandLine& line);

}  // namespace ccmorse::tools
