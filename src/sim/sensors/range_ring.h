#pragma once

#include <memory>
#include <vector>

#include "base/trig.h"
#include "scene/scenario.h"
#include "sim/component.h"
#include "sim/rays/triangle.h"

namespace ccmorse::sim {

class World;

/// A ring of range sensors that are read together, infra-red or sonar (specs: syrotek.md A). Data:
/// range_list, m, one a sensor in the order of get_configurations' poses: the distance from the
/// sensor to the nearest point in its cone of anything but its own robot and the floor, which
/// throws neither sound nor light back at a grazing angle; never less than min_range; the range
/// where there is nothing. The cone is searched as a whole, not by single rays, so nothing is too
/// small to be seen.
class RangeRing : public Sensor {
 public:
  /// `mounts` on the robot, at least one; those of `def` do not count.
  RangeRing(Robot& robot, const std::string& name, std::string type, const scene::RingDef& def,
            std::vector<scene::RingMount> mounts, const World& world);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;
  void Prepare() override;
  int Work() const override { return 100 * static_cast<int>(mounts_.size()); }
  Json Configurations() const override;

  const std::vector<double>& ranges() const { return ranges_; }  ///< m, one a sensor
  const std::vector<scene::RingMount>& mounts() const { return mounts_; }
  double range() const { return def_.range; }             ///< m, what a sensor without a hit says
  double cone() const { return Radians(def_.cone_deg); }  ///< rad, full opening angle

 private:
  void AppendFields(std::string& out) const override;

  scene::RingDef def_;
  std::vector<scene::RingMount> mounts_;
  const World& world_;
  Cone cone_;  // opening; where it points is the sensor's
  std::vector<double> ranges_;
};

/// The infra-red sensors of a robot whose scenario mounts them: "ir".
std::unique_ptr<RangeRing> MakeInfraredRing(Robot& robot, const World& world);

/// The sonars, likewise: "sonar".
std::unique_ptr<RangeRing> MakeSonarRing(Robot& robot, const World& world);

}  // namespace ccmorse::sim
