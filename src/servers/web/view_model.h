#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/image.h"
#include "servers/morse/service_directory.h"
#include "sim/sensors/laser_scanner.h"
#include "sim/sensors/range_ring.h"
#include "sim/sensors/search_and_rescue.h"
#include "sim/sensors/semantic_camera.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// What the viewer in the browser is shown of a simulation, as it goes over the wire
/// (docs/protocols/view.md). It only looks. One thread.
class ViewModel {
 public:
  explicit ViewModel(const sim::Simulation& simulation);

  /// What a frame is measured against: what one viewer has.
  struct Seen {
    std::vector<std::uint64_t> samples;  ///< of each sensor, as of the last frame
    std::uint64_t canvas = 0;            ///< rows stamped later are new
    bool operator==(const Seen&) const = default;
  };

  /// What does not change during a run: floor, boxes, meshes, things, lights, camera, robots with
  /// their hulls and sensors. JSON, with the members of `more`, an object.
  std::string Scene(const Json& more) const;

  /// The state now, with those scans and rows of the canvas that are new to the viewer. `rate`:
  /// simulated seconds per wall-clock second, as measured.
  std::string Frame(Seen& seen, double rate, const TimeState& time);

 private:
  void StampCanvas();
  Json RobotScene(const sim::Robot& robot) const;
  Json FrustaScene() const;
  Json RadarsScene() const;
  Json ThingsScene() const;

  const sim::Simulation& simulation_;
  std::vector<const sim::LaserScanner*> lasers_;  // of all robots, by robot, then as mounted
  std::vector<const sim::RangeRing*> rings_;
  std::vector<const sim::SemanticCamera*> cameras_;  // likewise
  std::vector<const sim::SearchAndRescue*> radars_;
  // Cameras, radars, then lasers: those that something carries, by their place.
  std::vector<std::pair<std::size_t, const sim::Sensor*>> carried_;
  std::vector<std::size_t> dynamic_;  // boxes, by their place in the scene
  std::vector<std::size_t> things_;   // passive objects that are drawn, by theirs in the world
  int canvas_width_ = 0;
  int canvas_height_ = 0;
  std::uint64_t canvas_revision_ = 0;
  std::uint64_t stamp_ = 1;
  std::vector<std::uint64_t> row_stamps_;   // when each row changed last
  std::vector<std::uint32_t> canvas_copy_;  // RGBA as sent, (height x width)
};

}  // namespace ccmorse::servers
