// The given part of CExploration: its thread.

#include "exploration.h"

namespace imr {

void CExploration::threadBody() {
  CMapGrid seen(1, 1, MAP_CELL_SIZE);
  SPosition position;
  while (control.waitForMap(seen, position)) control.setPlan(plan(seen, position));
}

}  // namespace imr
