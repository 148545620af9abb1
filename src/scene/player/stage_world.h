#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/image.h"
#include "scene/player/bitmap.h"
#include "scene/player/player_file.h"
#include "scene/scenario.h"

namespace ccmorse::scene {

/// How the importer gets at files; others for tests and fuzzing.
struct StageFiles {
  FileReader read = ReadFile;
  std::function<Image(const std::string& path)> bitmap = ReadBitmap;
};

/// One of Stage's models on a robot, and what of the scenario has its data.
struct StageModel {
  std::string name;  ///< in full, as Stage calls it: "r0.ranger:1"
  std::string type;  ///< "position", "ranger", "laser" (Stage 2 and 3), "camera" ...
  /// Components of the robot: "pose" or "odometry" of a position model, "hokuyo", "sonar" ...; more
  /// than one where a ranger has several scanners. Empty: CCMorse has nothing for it.
  std::vector<std::string> components;
};

/// A position model and what it carries.
struct StageRobot {
  std::string name;                ///< of the scenario's robot
  std::vector<StageModel> models;  ///< in pre-order, the position model first
};

/// A .world as a scenario. Stage's coordinates moved by scenario.world.origin are the scenario's.
struct StageWorld {
  Scenario scenario;
  std::vector<StageRobot> robots;
  std::vector<FileNote> notes;  ///< what of the file is done otherwise or not at all
};

/// Reads the text of a .world of Stage 2, 3 or 4 called `file` (specs: player.md C.3); bitmaps and
/// included files start from its folder. What becomes of each construct: docs/scenario.md. Throws
/// Error "FILE:LINE: ..." for what ParsePlayerFile throws, unknown types of models, values that
/// make no sense, missing bitmaps and robots that stand in something.
StageWorld ParseStageWorld(const std::string& text, const std::string& file,
                           const StageFiles& files = {});

}  // namespace ccmorse::scene
