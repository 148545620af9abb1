#include "libCCMorse/MorseSensor.h"

namespace CCMorse {

MorseSensor::MorseSensor(const MorseDeviceInfo& info) : MorseDevice(info) {
  if (HasService("get_local_data")) SetPolled(true);
}

MorseSensor::~MorseSensor() = default;

}  // namespace CCMorse
