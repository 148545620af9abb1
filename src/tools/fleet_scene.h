#pragma once

#include "scene/scenario.h"

namespace ccmorse::tools {

/// The scenario in which other simulators were measured (docs/performance.md): `robots` arenas
/// tiled in a grid of ceil(sqrt(robots)) columns, each with one BoxRobot in its middle, heading 37
/// degrees times its number. Robots are named r00000, r00001, ...
scene::Scenario MakeFleet(int robots);

}  // namespace ccmorse::tools
