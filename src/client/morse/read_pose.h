#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "libCCMorse/MorseValue.h"
#include "libCCMorse/Types.h"

namespace CCMorse {

/// Six finite numbers of a sensor's data, by their keys in the order x, y, z, roll, pitch, yaw;
/// nothing when one is missing or not finite.
inline std::optional<player_pose3d_t> ReadPose(const MorseValue& data,
                                               const char* const (&keys)[6]) {
  double numbers[6];
  for (int i = 0; i < 6; ++i) {
    numbers[i] = data.GetDouble(keys[i], std::numeric_limits<double>::quiet_NaN());
    if (!std::isfinite(numbers[i])) return std::nullopt;
  }
  return player_pose3d_t{numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]};
}

/// The same of numbers in the order of the fast link.
inline std::optional<player_pose3d_t> ReadPose(const double* numbers) {
  for (int i = 0; i < 6; ++i) {
    if (!std::isfinite(numbers[i])) return std::nullopt;
  }
  return player_pose3d_t{numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]};
}

inline constexpr const char* kPoseKeys[6] = {"x", "y", "z", "roll", "pitch", "yaw"};

}  // namespace CCMorse
