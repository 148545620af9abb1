#pragma once

#include <string>
#include <vector>

#include "scene/player/player_file.h"
#include "scene/player/player_setup.h"

namespace ccmorse::scene {

/// One `driver ( ... )` of a .cfg (specs: player.md C.2).
struct ConfigDriver {
  /// Name, provides, requires, alwayson and all other options but those below.
  PlayerDriver driver;
  std::string plugin;      ///< "stageplugin"; "" for none
  std::string world_file;  ///< of Stage's plugin: as written, relative to the .cfg; "" for none
  std::string model;       ///< of Stage's plugin: the model it serves; "" for none
  FilePlace at;
  FilePlace provides_at;
  FilePlace world_file_at;
  FilePlace model_at;
};

/// A .cfg file, read.
struct PlayerConfig {
  std::string file;
  std::vector<ConfigDriver> drivers;  ///< in order
  std::vector<FileNote> notes;        ///< what of the file has no effect
};

/// Is this driver Stage's: named "stage", or of its plugin?
bool IsStage(const ConfigDriver& driver);

/// Reads the text of a .cfg called `file`. Throws Error "FILE:LINE: ...": what ParsePlayerFile
/// throws, a driver without a name, addresses that are none, and a device that two drivers provide.
PlayerConfig ParsePlayerConfig(const std::string& text, const std::string& file,
                               const FileReader& read = ReadFile);

}  // namespace ccmorse::scene
