#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/site_config.h"

namespace ccmorse::tools {

/// A simulation project with a name.
struct Environment {
  std::string name;
  std::filesystem::path folder;  ///< absolute
  bool created = false;          ///< by `ccmorse create` and not imported: `rm` may take it away
};

/// The environments that the user has created and imported, as MORSE keeps them: in
/// ~/.morse/config, with MORSE's own rules and no others (it knows no $XDG_CONFIG_HOME).
/// ~/.morse/created, of the same form, says which of them `create` made, so that no other folder is
/// ever deleted. Changes are made under a lock on the folder and appear at once (rename), so any
/// number of programs may use the files at the same time, MORSE itself too. Each call reads the
/// files anew. Thread safe.
class Environments {
 public:
  /// Of the user: $HOME, else the home folder of the user's account. Without any, as in a sandbox,
  /// there are no environments, and none can be added.
  Environments();
  explicit Environments(std::filesystem::path home);

  /// Throws Error when the file is there and cannot be read.
  std::vector<Environment> List() const;
  std::optional<Environment> Find(const std::string& name) const;

  /// Adds an environment or changes the folder of the one of that name. Throws Error that names
  /// the file and the system's reason.
  void Set(const Environment& environment);

  /// Forgets a name; the folder stays. False when there is none. Throws as Set().
  bool Forget(const std::string& name);

  const std::filesystem::path& config_file() const { return config_file_; }
  const std::filesystem::path& home() const { return home_; }

 private:
  void Change(const std::function<void(SiteConfig& sites, SiteConfig& created)>& change);

  std::filesystem::path home_;
  std::filesystem::path config_file_;
  std::filesystem::path created_file_;
};

/// Writes a file so that others see the old or the new one whole; keeps its permissions, and what a
/// symbolic link points at is changed, not the link. Throws Error.
void ReplaceFile(const std::filesystem::path& file, const std::string& text);

/// Throws Error that says what is wrong with the name, and what to do, unless it can be a key of
/// the config file. `how` is the command to type instead, as "ccmorse import PATH NAME".
void RequireEnvironmentName(const std::string& name, const std::string& how);

/// Moves a folder or file into the user's trash (freedesktop.org's Trash specification 1.0:
/// $XDG_DATA_HOME/Trash, else ~/.local/share/Trash) and returns where it lies now. Throws Error,
/// with everything as it was, where it cannot: another file system, for one.
std::filesystem::path MoveToTrash(const std::filesystem::path& what,
                                  const std::filesystem::path& home);

}  // namespace ccmorse::tools
