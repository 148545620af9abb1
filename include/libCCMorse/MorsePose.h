#pragma once

#include <cstddef>

#include "libCCMorse/MorseSensor.h"

namespace CCMorse {

/// The sensor of the robot's true pose in the world, MORSE's Pose (thesis 3.1.3). Getters give 0
/// before the first data; each takes one consistent copy. Owned by the client; any thread.
class MorsePose : public MorseSensor, public MorsePoseSource {
 public:
  explicit MorsePose(const MorseDeviceInfo& info);

  bool HasPose() const override;                        ///< whether sensible data arrived
  player_pose3d_t GetPose() const override;             ///< m and rad, in the world
  double GetX() const { return GetPose().px; }          ///< m
  double GetY() const { return GetPose().py; }          ///< m
  double GetZ() const { return GetPose().pz; }          ///< m
  double GetRoll() const { return GetPose().proll; }    ///< rad, about x
  double GetPitch() const { return GetPose().ppitch; }  ///< rad, about y
  double GetYaw() const { return GetPose().pyaw; }      ///< rad, about z, counter-clockwise

 protected:
  bool OnData(const MorseValue& data) override;
  DataForm Form() const override;
  bool OnNumbers(const double* numbers, std::size_t count) override;

 private:
  player_pose3d_t pose_{};
};

}  // namespace CCMorse
