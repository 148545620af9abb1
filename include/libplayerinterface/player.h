#pragma once

// Player's messages: structs and constants under Player's own names (specs: player.md A.1, B.7).

#include <cstdint>

#include "libplayerinterface/player_interfaces.h"
