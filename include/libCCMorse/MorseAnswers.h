#pragma once

#include <string>
#include <vector>

#include "libCCMorse/MorseActuator.h"
#include "libCCMorse/Types.h"

namespace CCMorse {

/// Where a program hands in its results to be judged (docs/grading.md): values by name, each of
/// 1 MiB at most as JSON, 16 names at most. A later value replaces an earlier one of the same name.
/// The real robot and MORSE have no such device. Each call waits until the simulator has taken the
/// value, and throws MorseError when it refuses it or the connection is lost. Owned by the client;
/// any thread.
class MorseAnswers : public MorseActuator {
 public:
  explicit MorseAnswers(const MorseDeviceInfo& info);

  /// Hands in any value as JSON: "[1, 2]". Throws MorseError for text that is no JSON.
  void SubmitJson(const std::string& name, const std::string& json);
  /// Hands in a list of finite numbers.
  void Submit(const std::string& name, const std::vector<double>& numbers);
  /// Hands in "path": the corners of a way, from its start to its goal, m in the world.
  void SubmitPath(const std::vector<player_point_2d_t>& points, const std::string& name = "path");
  /// Hands in "pose": where the robot says it is, m and rad in the world.
  void SubmitPose(double x, double y, double yaw, const std::string& name = "pose");
  /// Hands in a grid map ("map"): `width` x `height` cells of `cell_size` m, row by row from the
  /// bottom, each from the left; '0' is free, '1' a wall, '?' unknown. (`origin_x`, `origin_y`), m,
  /// is the world's place of the bottom-left cell's bottom-left corner. Throws MorseError unless
  /// `cells` has width times height of these characters.
  void SubmitGrid(const std::string& name, int width, int height, const std::string& cells,
                  double cell_size = 0.02, double origin_x = 0.0, double origin_y = 0.0);

  /// The names of what was handed in so far, asked from the simulator.
  std::vector<std::string> GetSubmitted() const;
};

}  // namespace CCMorse
