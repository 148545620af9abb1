#pragma once

#include <vector>

#include "scene/scenario.h"
#include "sim/component.h"
#include "sim/noise.h"
#include "sim/rays/planar_scan.h"

namespace ccmorse::sim {

class World;

/// A planar laser scanner: MORSE's LaserScanner, of which Hokuyo is a preset (specs: morse.md B.2,
/// H.4; thesis 4.1.2). Data: point_list, hits in the scanner's frame, m, [0, 0, 0] without a hit;
/// and range_list, m, the scanner's range without a hit; both from the right-most beam
/// counter-clockwise. The ranges of hits are noisy if the
/// scenario says so. It does not see the robot that carries it.
class LaserScanner : public Sensor {
 public:
  LaserScanner(Robot& robot, const std::string& name, const scene::LaserDef& def,
               const World& world, std::uint64_t seed);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;
  NumberForm number_form() const override { return NumberForm::kScan; }
  void AppendNumbers(std::vector<double>& out) const override;
  Json Configurations() const override;
  Vec3 mount() const override { return def_.position; }

  int Work() const override { return def_.samples; }

  const std::vector<double>& ranges() const { return ranges_; }  ///< m, (samples)
  const PlanarScanner& scanner() const { return scanner_; }

 private:
  void AddNoise(std::uint64_t tick);
  double Height() const;  // m above the floor
  void AppendFields(std::string& out) const override;

  scene::LaserDef def_;
  const World& world_;
  PlanarScanner scanner_;
  Noise noise_;
  std::vector<double> ranges_;
};

}  // namespace ccmorse::sim
