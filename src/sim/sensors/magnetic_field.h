#pragma once

#include <vector>

#include "base/pose.h"
#include "scene/magnetic_field.h"
#include "sim/sensors/geodesy.h"

namespace ccmorse::sim {

/// The Earth's magnetic field from a model in spherical harmonics (A. Chulliat et al., "The US/UK
/// World Magnetic Model for 2015-2020", NOAA 2015, section 1.2; specs: morse.md B.2). Any number of
/// threads may ask. The same bits on every machine.
class MagneticField {
 public:
  explicit MagneticField(const scene::MagneticFieldDef& def);

  /// North, east and down, nT, at a place, in a year with its decimals: the terms change evenly
  /// from their epoch on, for as long as anybody asks. At the poles north is along the longitude
  /// given.
  Vec3 NorthEastDown(const GeodeticPlace& place, double year) const;

 private:
  scene::MagneticFieldDef def_;
  int degree_ = 0;  // the highest
};

}  // namespace ccmorse::sim
