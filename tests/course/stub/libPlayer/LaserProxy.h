#pragma once

// The real robot's header, over the same stand-in.
#include "libCCMorse/CCMorse.h"
