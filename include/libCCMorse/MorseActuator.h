#pragma once

#include "libCCMorse/MorseDevice.h"

namespace CCMorse {

/// Base of all actuators: devices that act by commands and requests (thesis 3.1.2). Owned by the
/// client; every method may be called from any thread.
class MorseActuator : public MorseDevice {
 public:
  explicit MorseActuator(const MorseDeviceInfo& info);
  ~MorseActuator() override = 0;
};

}  // namespace CCMorse
