#pragma once

#include <string>
#include <vector>

#include "scene/player/player_config.h"
#include "scene/player/player_file.h"
#include "scene/player/stage_world.h"
#include "scene/scenario.h"

namespace ccmorse::scene {

/// A scenario from a file of any kind, and what of the file it does not have.
struct ImportedScenario {
  Scenario scenario;
  std::vector<FileNote> notes;  ///< none for a scenario's own file
};

/// Reads a scenario (.json), a .cfg of Player, a .world of Stage or a file of shapes
/// (assets/load.h), by the file's ending. Throws Error "FILE:LINE: ...".
ImportedScenario ImportScenario(const std::string& file);

/// The scenario of a .cfg: of the world its Stage driver names, with `player` set; of a .cfg for
/// SyRoTek's real robot (driver "syrdriv"), the SyRoTek arena with one S1R. Throws Error
/// "FILE:LINE: ..." for a .cfg without a world and for a model that its world has not.
ImportedScenario ImportConfig(const PlayerConfig& config, const StageFiles& files = {});

}  // namespace ccmorse::scene
