#pragma once

#include "libCCMorse/MorseDevice.h"

namespace CCMorse {

/// Base of all sensors: devices whose data every Read() brings (thesis 3.1.2). Owned by the client;
/// every method may be called from any thread.
class MorseSensor : public MorseDevice {
 public:
  /// Starts polled when the simulator lets its data be read.
  explicit MorseSensor(const MorseDeviceInfo& info);
  ~MorseSensor() override;

 protected:
  bool OnData(const MorseValue& data) override = 0;
};

}  // namespace CCMorse
