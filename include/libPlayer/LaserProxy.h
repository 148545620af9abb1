#pragma once

// LaserProxy under the name that programs for SyRoTek include (thesis 3.4).
#include "libCCMorse/LaserProxy.h"
