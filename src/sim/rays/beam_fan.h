#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "base/pose.h"
#include "base/rotation.h"
#include "scene/scenario.h"
#include "sim/rays/planar_scan.h"

namespace ccmorse::sim {

/// The beams of a laser scanner as mounted on a robot, by MORSE's arithmetic (specs: morse.md H.4):
/// in each layer from the right-most counter-clockwise, layer after layer from the top. A beam at
/// bearing a of a layer at elevation v points along (cos a, sin a, sin v). With more than one layer
/// the first, third, ... are turned by the layer offset. One thread at a time may scan with one
/// fan.
class BeamFan {
 public:
  explicit BeamFan(const scene::LaserDef& def);

  std::size_t count() const { return count_; }
  double range() const { return range_; }  ///< m

  /// Are all beams level when the robot is? Only such a fan can be scanned without tracing rays.
  bool upright() const { return planar_.has_value(); }

  /// Has all of its beams traced from now on, as one must whose mount moves.
  void Untie() {
    planar_.reset();
    directions_.reset();
  }
  /// Moves an untied fan on its robot.
  void Place(const Vec3& position, const Rotation& rotation) {
    position_ = position;
    rotation_ = rotation;
  }

  /// Where it sits, in the robot's frame; m.
  const Vec3& position() const { return position_; }
  const Rotation& rotation() const { return rotation_; }

  /// Unit vector of beam i in the scanner's frame.
  Vec3 Direction(std::size_t i) const;

  /// All of them. Made when first asked for, as an upright fan is seldom asked.
  const std::vector<Vec3>& directions() const;

  /// For an upright fan only: its beam buffer, and its pose on a robot at `robot`.
  PlanarScanner& planar() { return *planar_; }
  Pose2 PlanarPose(const Pose2& robot) const;

 private:
  scene::LaserDef def_;
  std::size_t count_;
  double range_;
  Vec3 position_;
  Rotation rotation_;
  std::optional<PlanarScanner> planar_;
  mutable std::shared_ptr<const std::vector<Vec3>> directions_;  // scanners alike share them
};

}  // namespace ccmorse::sim
