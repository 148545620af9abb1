// Wall following: keeps the wall on the right, and crosses over to new ground where it has been.

#include "behaviour.h"

#include "clearance.h"
#include "memory.h"

namespace {

using intro::AHEAD;
using intro::room;

constexpr double FASTEST = 0.4;       // m/s
constexpr double FASTEST_TURN = 2.5;  // rad/s
constexpr double RADIUS = 0.12;       // m, of the turn around the end of a wall
constexpr double NEAR = 0.22;         // m to the laser: a wall that is as near is followed closely
constexpr double WIDE = 0.4;          // m, radius of the turn towards one that is not
constexpr double WALL = 0.5;          // m to the laser: farther walls are none to follow

class CWallFollower : public imr::CBehaviour {
 public:
  imr::SSpeed step(const imr::SSenses& sensed, imr::CSketch& sketch) override {
    imr::SSenses senses = sensed;
    intro::smooth(senses.scan);
    memory.remember(senses);
    const imr::SPoint here = {senses.pose.x, senses.pose.y};
    if (std::hypot(here.x - last.x, here.y - last.y) > 0.05 || !crossing) {
      last = here;
      moved = senses.time;
    }
    const double direction = choose(senses);
    sketch.clear(WAY);
    sketch.line(WAY, here,
                {here.x + 0.3 * std::cos(senses.pose.yaw + direction),
                 here.y + 0.3 * std::sin(senses.pose.yaw + direction)});
    const double straight = std::max(0.0, std::cos(direction));
    double v = FASTEST * straight * straight;
    double w = std::clamp(5.0 * direction, -FASTEST_TURN, FASTEST_TURN);
    if (!crossing && w < 0.0) {
      // Around the end of a wall, and not on the spot: beside the robot and behind it the laser
      // sees too little to turn there.
      v = std::max(v, 0.15);
      const bool near = senses.scan.nearestRange(-2.4, 0.5) < NEAR;
      w = std::max(w, -v / (near ? RADIUS : WIDE));
    }
    return intro::careful(senses.scan, {v, w});
  }

 private:
  static constexpr imr::CSketch::SInk WAY = {"direction", 255, 165, 0};

  // The bearing to go to.
  double choose(const imr::SSenses& senses) {
    if (crossing && memory.isCovered(goal)) endCrossing(senses);
    if (crossing && senses.time - moved > 1.5) giveUp(senses);
    const bool wall = senses.scan.nearestRange(-2.4, 0.5) < WALL;
    if (!crossing && (memory.isKnown() || !wall) && senses.time - since > 2.0) crossing = true;
    double bearing = 0.0;
    if (crossing && cross(senses, bearing)) return bearing;
    return alongWall(senses, wall);
  }

  // The bearing on the way to new ground; false when there is none, or it cannot be reached.
  bool cross(const imr::SSenses& senses, double& bearing) {
    imr::SPoint next;
    if (!memory.findFresh(goal, next)) {
      endCrossing(senses);
      return false;
    }
    const double wish = intro::bearingOf(senses.pose, next);
    if (intro::freeBearing(senses.scan, wish, bearing)) return true;
    if (std::fabs(wish) > 1.0) return true;  // it has to turn before it sees what is there
    giveUp(senses);
    return false;
  }

  double alongWall(const imr::SSenses& senses, bool wall) {
    // Out of a corner: on the spot, to the left, until there is room ahead; after some turns, a
    // little is enough.
    if (!corner) turning = senses.time;
    const bool patient = senses.time - turning < 4.0;
    if (corner && room(senses.scan, 0.0) < (patient ? AHEAD : AHEAD / 3)) return 1.6;
    corner = false;
    // The right-most direction that is free; without a wall, straight on.
    for (double bearing = wall ? -1.3 : 0.0; bearing < 0.8; bearing += 0.05) {
      if (room(senses.scan, bearing, intro::COMFORT) >= AHEAD) return bearing;
    }
    corner = true;
    return 1.6;
  }

  void endCrossing(const imr::SSenses& senses) {
    crossing = false;
    since = senses.time;
  }

  // What cannot be reached is not looked for in the next minute.
  void giveUp(const imr::SSenses& senses) {
    memory.avoid(goal, 0.16, 60.0);
    endCrossing(senses);
  }

  intro::CMemory memory;
  imr::SPoint goal;      // of the crossing
  imr::SPoint last;      // where the robot was when it last moved on
  double moved = 0.0;    // and when, s
  double turning = 0.0;  // since when it turns out of a corner, s
  double since = 0.0;    // the end of the last crossing, s
  bool crossing = false;
  bool corner = false;
};

}  // namespace

std::unique_ptr<imr::CBehaviour> makeBehaviour() { return std::make_unique<CWallFollower>(); }
