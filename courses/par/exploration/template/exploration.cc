// Planning: the second part of the task. Use what you wrote for the planning task. Of the functions
// that exploration.h lists, take those you need; `plan` puts them together.

#include "exploration.h"

namespace imr {

SPlan CExploration::plan(const CMapGrid& seen, const SPosition& position) {
  map = seen;
  SPlan made;
  // TASK 2: dilate the obstacles, and list the cells of the frontiers: blue and purple.
  // TASK 3: plan to the nearest frontier, and smooth the path: orange. Without a frontier that can
  // be reached, made.done = true ends the run.
  (void)position;
  return made;
}

}  // namespace imr
