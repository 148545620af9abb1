#pragma once

#include "libplayerc++/clientproxy.h"

namespace CCMorse {

/// Base of all proxies (thesis 3.1.3): Player's own. GetRobot() tells the robot that it belongs to.
using MorseProxy = PlayerCc::ClientProxy;

}  // namespace CCMorse
