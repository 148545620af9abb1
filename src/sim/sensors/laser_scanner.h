#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "scene/scenario.h"
#include "sim/component.h"
#include "sim/late_text.h"
#include "sim/noise.h"
#include "sim/rays/beam_fan.h"

namespace ccmorse::sim {

class World;

/// A laser scanner of one or more layers, level or tilted: MORSE's LaserScanner, of which Hokuyo is
/// a preset (specs: morse.md B.2, H.4; thesis 4.1.2). Data: point_list, hits in the scanner's
/// frame, m, [0, 0, 0] without a hit; and range_list, m, the scanner's range without a hit; both
/// layer by layer from the top, from the right-most beam counter-clockwise. The ranges of
/// hits are noisy if the scenario says so. It does not see the robot that carries it.
/// Service `mirror`: from now on it shows the ranges it is given instead of looking (thesis 5.1).
class LaserScanner : public Sensor, public LateText {
 public:
  LaserScanner(Robot& robot, const std::string& name, const scene::LaserDef& def,
               const World& world, std::uint64_t seed);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;
  NumberForm number_form() const override { return NumberForm::kScan; }
  void AppendNumbers(std::vector<double>& out) const override;
  Json Configurations() const override;
  std::function<std::string()> TextLater() override;
  Vec3 mount() const override { return is_carried() ? Sensor::mount() : def_.position; }
  Rotation mount_rotation() const override {
    return is_carried() ? Sensor::mount_rotation() : FromEuler(def_.roll, def_.pitch, def_.yaw);
  }
  void Mounted() override;

  void Prepare() override;
  int Work() const override { return static_cast<int>(fan_.count()); }

  const std::vector<double>& ranges() const { return ranges_; }  ///< m, (layers * samples)
  const BeamFan& fan() const { return fan_; }

 protected:
  LaserScanner(Robot& robot, const std::string& name, const char* type, const scene::LaserDef& def,
               const World& world, std::uint64_t seed);
  /// Its fan does not stay where it is on the robot.
  void LetMove();
  /// The direction of beam i, a unit vector, in the frame that points are shown in.
  virtual Vec3 PointDirection(std::size_t i) const { return fan_.Direction(i); }
  /// How the fan is turned on the robot now; asked before each scan of one whose mount moves.
  virtual Rotation FanRotation() const { return mount_rotation(); }

 private:
  void Mirror(Arguments arguments);
  void AddNoise(std::uint64_t tick);
  void AppendFields(std::string& out) const override;

  scene::LaserDef def_;
  const World& world_;
  BeamFan fan_;
  bool moves_ = false;  // the fan, on the robot
  Noise noise_;
  std::vector<double> ranges_;
  std::vector<double> mirrored_;  // what to show instead; empty: look
  // PointDirection() of all beams, for TextLater(); nullptr: not asked for yet.
  std::shared_ptr<const std::vector<Vec3>> point_directions_;
};

}  // namespace ccmorse::sim
