#pragma once

#include "scene/field.h"
#include "scene/scenario.h"

namespace ccmorse::scene {

/// Reads a scenario's "obstacles": which dynamic boxes of `world` are up at the start, and presets,
/// timers, traps and paths. Throws Error.
ObstacleRules ReadObstacles(const Field& field, World& world);

/// One timer or trap, {"at": 10, "every": 5, "toggle": [69]} or {"name": "door", "region": [0.5,
/// 0.5, 1, 1], "up": [70]}, that may name the presets of `rules`. Throws Error.
ObstacleTimer ReadTimer(const Field& field, const World& world, const ObstacleRules& rules);
ObstacleTrap ReadTrap(const Field& field, const World& world, const ObstacleRules& rules);

/// The ids of dynamic boxes in a list. Throws Error that names those there are.
std::vector<int> ReadDynamicIds(const Field& list, const World& world);

/// As ReadObstacles reads it.
Json ObstaclesToJson(const ObstacleRules& rules, const World& world);
Json ToJson(const ObstacleTimer& timer);
Json ToJson(const ObstacleTrap& trap);

}  // namespace ccmorse::scene
