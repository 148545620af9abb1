#pragma once

#include <string>
#include <utility>

namespace CCMorse::core {

/// Where a program is to connect that asks for this host and port. A simulator's usual address,
/// localhost (or 127.0.0.1) with port 4000 or Player's 6665, gives way to the environment's
/// CCMORSE_HOST and CCMORSE_PORT, so that `ccmorse batch` can run many programs that have it built
/// in side by side; any other address stays. Throws MorseError when CCMORSE_PORT is no port.
std::pair<std::string, int> AddressFor(const std::string& host, int port);

}  // namespace CCMorse::core
