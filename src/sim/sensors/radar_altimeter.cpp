#include "sim/sensors/radar_altimeter.h"

#include <array>
#include <limits>

#include "base/trig.h"
#include "sim/rays/beam_fan.h"
#include "sim/rays/range_engine.h"
#include "sim/robots/robot.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

namespace {

constexpr double kLongest = 1e5;  // m

}  // namespace

RadarAltimeter::RadarAltimeter(Robot& robot, const std::string& name, const World& world)
    : Sensor(robot, name, "RadarAltimeter", 60.0), world_(world) {
  AddProperty("MaxRange", max_range_, 0.0, kLongest);
}

void RadarAltimeter::Sample(const Instant& now) {
  // Two beams, all but one: a fan has no fewer. Its place is the sensor's, whose mount says how it
  // is turned: the radar looks down whatever that is.
  scene::LaserDef down;
  down.position = mount();
  down.pitch = kPi / 2.0;
  down.range = kLongest;
  down.samples = 2;
  down.scan_window_deg = down.resolution_deg = 1e-6;
  BeamFan fan(down);
  std::array<double, 2> ranges{};
  if (robot().dynamic()) {
    const Vec3 here = robot().position() + Rotate(robot().rotation(), mount());
    world_.rays().Scan(fan, here - mount(), Rotation{}, robot().index(), ranges);
  } else {
    world_.rays().Scan(fan, robot().pose(), robot().model().origin_height, robot().index(), ranges);
  }
  z_ = ranges[0] <= max_range_ ? ranges[0] : std::numeric_limits<double>::infinity();
  DataChanged(now.time);
}

void RadarAltimeter::Reset() {
  Sensor::Reset();
  z_ = 0.0;
}

void RadarAltimeter::AddToHash(StateHash& hash) const { hash.Add(z_); }

void RadarAltimeter::AppendFields(std::string& out) const { AppendField(out, "z", z_); }

}  // namespace ccmorse::sim
