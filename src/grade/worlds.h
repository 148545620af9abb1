#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "grade/grid.h"
#include "grade/rubric.h"
#include "scene/scenario.h"

namespace ccmorse::grade {

/// Where a planner starts and where it is to go.
struct Route {
  Cell start;
  Cell goal;
};

/// The world of a seed: worlds[seed % size] of the rubric with all that is random drawn by the
/// seed, a function of rubric and seed alone. No robot stands in anything, and from where each
/// stands at least a third of the free floor can be reached. Throws Error where the scenario cannot
/// be read, or no such world was found in many tries.
scene::Scenario MakeWorld(const Rubric& rubric, std::uint64_t seed);

/// The start of the first robot by name and a goal drawn by the scenario's seed, far away and
/// connected with it, both free on the dilated map; nothing where there is no such goal. The same
/// for equal scenarios, so the judge finds it from the record.
std::optional<Route> DrawRoute(const scene::Scenario& scenario);

/// The map that planners get: cells no more than half a cell beside a standing box are walls, as
/// scripts/make_arena_map.py has it.
Grid PlannersMap(const scene::World& world);
/// As a text file of the course (imr-h/map_file.h).
std::string MapText(const Grid& map);

}  // namespace ccmorse::grade
