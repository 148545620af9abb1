#pragma once

// What client programs take from Player's core (specs: player.md A.1): messages and conversions.
// The server's own classes are no part of it.

#include "libplayercommon/error.h"
#include "libplayercore/playercommon.h"
#include "libplayerinterface/interface_util.h"
#include "libplayerinterface/player.h"
