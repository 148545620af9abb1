#pragma once

#include <memory>

#include "libCCMorse/MorseDevice.h"

namespace CCMorse::core {

/// Makes the device that fits the name and the type; a plain MorseDevice when no class does. A type
/// that a class names decides, because it is certain; else the longest identifier in the name does.
std::unique_ptr<MorseDevice> MakeDevice(const MorseDeviceInfo& info);

}  // namespace CCMorse::core
