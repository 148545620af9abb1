#pragma once

#include <optional>

#include "navigation/occupancy_grid.h"
#include "servers/player/device.h"

namespace ccmorse::servers::player {

/// The whole map that a map device serves, read as Player's clients read it, tile by tile (specs:
/// player.md B.7). The grid's origin is the map's, whose heading must be 0. nullopt where the
/// device refuses, its tiles cannot be read, or there are more than 2^28 cells.
std::optional<navigation::OccupancyGrid> ReadMap(Device& map);

}  // namespace ccmorse::servers::player
