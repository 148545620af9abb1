#pragma once

#include <cstddef>

#include "libCCMorse/MorseSensor.h"

namespace CCMorse {

/// Odometry, MORSE's IntegratedOdometry (thesis 3.1.3): the pose in the frame in which the robot
/// started, and speeds. ccmorse gives the speeds in the robot's frame; MORSE 1.4 gives the linear
/// ones in the start frame and with the sign reversed, and they are passed on as they come. Getters
/// give 0 before the first data; each takes one consistent copy. Owned by the client; any thread.
class MorseOdometry : public MorseSensor {
 public:
  explicit MorseOdometry(const MorseDeviceInfo& info);

  player_pose3d_t GetPose() const;                    ///< m and rad, from the start
  player_pose3d_t GetSpeed() const;                   ///< m/s along x, y, z and rad/s about them
  double GetX() const { return GetPose().px; }        ///< m
  double GetY() const { return GetPose().py; }        ///< m
  double GetYaw() const { return GetPose().pyaw; }    ///< rad, counter-clockwise
  double GetXSpeed() const { return GetSpeed().px; }  ///< m/s, forward
  double GetYSpeed() const { return GetSpeed().py; }  ///< m/s, to the left
  double GetYawSpeed() const { return GetSpeed().pyaw; }  ///< rad/s, counter-clockwise
  /// Whether the robot pushes against something and does not get on; false on plain MORSE.
  bool GetStall() const;

 protected:
  bool OnData(const MorseValue& data) override;
  DataForm Form() const override;
  bool OnNumbers(const double* numbers, std::size_t count) override;

 private:
  player_pose3d_t pose_{};
  player_pose3d_t speed_{};
  bool stall_ = false;
};

}  // namespace CCMorse
