#pragma once

#include "libCCMorse/MorseActuator.h"

namespace CCMorse {

/// The actuator that drives a robot by forward speed and turn rate, MORSE's MotionVW
/// (thesis 3.1.3). Owned by the client; any thread.
class MorseMotionVW : public MorseActuator, public MorseSpeedControl {
 public:
  explicit MorseMotionVW(const MorseDeviceInfo& info);

  /// Forward speed `v`, m/s, and turn rate `w`, rad/s counter-clockwise. They leave with the next
  /// Read() and hold until changed. Throws MorseError when one is not finite.
  void SetSpeed(double v, double w) override;
  /// Speeds 0, with the next Read().
  void Stop() override;
};

}  // namespace CCMorse
