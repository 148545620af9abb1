#pragma once

#include <cstdint>
#include <string>

#include "libCCMorse/MorseClient.h"
#include "libCCMorse/MorseError.h"

namespace PlayerCc {
class PlayerClient;
}

namespace CCMorse {

/// Throws MorseError from `function` for a null client; else gives the simulator's client.
MorseClient& RequireClient(PlayerCc::PlayerClient* client, const char* function);

/// Whether a device can stand behind a proxy of some interface.
using DeviceFilter = bool (*)(const MorseDevice& device);

/// The device behind index `index` of `interface` ("laser"), by the `proxies` tables in the robots'
/// configurations (thesis 3.2); without any table, the index-th device that fits. `robot`: only
/// that robot, when not empty. Throws MorseError from `function` that lists the indexes there are.
MorseDevice& FindProxyDevice(MorseClient& client, const std::string& interface, std::uint32_t index,
                             const std::string& robot, DeviceFilter fits, const char* function);

}  // namespace CCMorse
