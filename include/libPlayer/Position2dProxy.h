#pragma once

// Position2dProxy under the name that programs for SyRoTek include (thesis 3.4).
#include "libCCMorse/Position2dProxy.h"
