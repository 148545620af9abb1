#include "libCCMorse/MorseActuator.h"

namespace CCMorse {

MorseActuator::MorseActuator(const MorseDeviceInfo& info) : MorseDevice(info) {}
MorseActuator::~MorseActuator() = default;

}  // namespace CCMorse
