#pragma once

#include <optional>
#include <string>

#include "scene/scenario.h"
#include "sim/component.h"
#include "sim/sensors/geodesy.h"

namespace ccmorse::sim {

/// MORSE's GPS (specs: morse.md B.2). Level simple: x, y, z of the sensor in the world, m. Level
/// raw: longitude and latitude, degrees, altitude, m, and `velocity`, m/s east, north and up, from
/// the last activation to this one. Level extended: besides, `date` "ddmmyy" and `time` "HHMMSS" of
/// simulated time, which starts with 1970, UTC, and `heading`, degrees clockwise from north,
/// Infinity where it does not move. 60 Hz.
class Gps : public Sensor {
 public:
  /// `level` is "simple", "raw" or "extended"; "" is simple. Throws Error where the level needs to
  /// know where on the Earth the world lies, and the scenario does not say.
  Gps(Robot& robot, const std::string& name, const std::string& level,
      const scene::Scenario& scenario);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  std::optional<Geodesy> geodesy_;  // of the levels that need it
  bool extended_;
  Vec3 position_;  // m, in the world
  Vec3 shown_;     // the same, as modifiers have made it
  GeodeticPlace place_;
  Vec3 velocity_;  // m/s: east, north, up
  double last_time_ = 0.0;
  bool sampled_ = false;
};

}  // namespace ccmorse::sim
