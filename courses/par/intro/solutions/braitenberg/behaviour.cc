// A vehicle after V. Braitenberg, "Vehicles", 1984: two wheels, each with a drive of its own, and
// senses wired to them. Fear: what is near on one side slows the wheel on the other. Love: a light
// on one side slows the wheel on the same; the light shines from the nearest ground that is new to
// the vehicle, along the way there.

#include "behaviour.h"

#include "clearance.h"
#include "memory.h"

namespace {

using intro::room;

constexpr double DRIVE = 0.6;     // m/s of a wheel that nothing slows
constexpr double TRACK = 0.14;    // m between the wheels
constexpr double FEAR = 0.03;     // m/s off a wheel for each feeler that something is near
constexpr double SIGHT = 0.05;    // m: as far is near
constexpr double LOVE = 0.4;      // m/s off a wheel for a light one radian to its side
constexpr double PATIENCE = 0.5;  // s without getting on, until it takes fright

class CVehicle : public imr::CBehaviour {
 public:
  imr::SSpeed step(const imr::SSenses& sensed, imr::CSketch& sketch) override {
    imr::SSenses senses = sensed;
    intro::smooth(senses.scan);
    memory.remember(senses);
    const imr::SPoint here = {senses.pose.x, senses.pose.y};
    if (std::hypot(here.x - last.x, here.y - last.y) > 0.05) {
      last = here;
      moved = senses.time;
    }

    double left = DRIVE;
    double right = DRIVE;
    // Fear, by nine feelers on either side.
    for (double bearing = 0.1; bearing < 1.5; bearing += 0.15) {
      const double weight = FEAR * std::cos(bearing);
      right -= weight * nearness(senses.scan, bearing);
      left -= weight * nearness(senses.scan, -bearing);
    }
    // Love.
    imr::SPoint light;
    sketch.clear(LIGHT);
    if (senses.time >= dark && memory.findFresh(goal, light)) {
      sketch.line(LIGHT, here, goal);
      // It comes around corners: from where there is room.
      double bearing = 0.0;
      intro::freeBearing(senses.scan, intro::bearingOf(senses.pose, light), bearing);
      const double aside = std::clamp(bearing, -1.3, 1.3);
      (aside > 0.0 ? left : right) -= LOVE * std::fabs(aside);
    }
    // Fright: who cannot get on reverses one wheel, until there is room again, and goes without
    // light for a while; after some turns, a little room is enough.
    const double ahead = room(senses.scan, 0.0);
    if (!frightened && senses.time - moved > PATIENCE) {
      frightened = true;
      since = senses.time;
      memory.avoid(goal, 0.16, 60.0);
      side = -side;
    }
    if (frightened && ahead > (senses.time - since < 4.0 ? intro::AHEAD : 0.04)) {
      frightened = false;
      moved = senses.time;
      dark = senses.time + 0.6;
    }
    if (frightened) {
      left = -0.2 * side;
      right = 0.2 * side;
    }
    return intro::careful(senses.scan, {(left + right) / 2, (right - left) / TRACK});
  }

 private:
  static constexpr imr::CSketch::SInk LIGHT = {"light", 255, 165, 0};

  static double nearness(const imr::SScan& scan, double bearing) {
    return 1.0 - std::min(1.0, room(scan, bearing, intro::COMFORT) / SIGHT);
  }

  intro::CMemory memory;
  imr::SPoint goal;    // where the light is from
  imr::SPoint last;    // where the vehicle was when it last moved on
  double moved = 0.0;  // and when, s
  double since = 0.0;  // of the last fright, s
  double dark = 0.0;   // until when no light is seen, s
  int side = 1;        // to turn to: 1 left, -1 right
  bool frightened = false;
};

}  // namespace

std::unique_ptr<imr::CBehaviour> makeBehaviour() { return std::make_unique<CVehicle>(); }
