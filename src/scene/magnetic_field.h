#pragma once

#include <string>
#include <vector>

namespace ccmorse::scene {

/// One term of the spherical harmonics of the Earth's magnetic field: Gauss's coefficients,
/// Schmidt's half normalization.
struct MagneticTerm {
  int degree = 1;       ///< n, 1..kMostMagneticDegree
  int order = 0;        ///< m, 0..n
  double g = 0.0;       ///< nT, at the epoch
  double h = 0.0;       ///< nT, at the epoch
  double g_rate = 0.0;  ///< nT a year
  double h_rate = 0.0;  ///< nT a year

  bool operator==(const MagneticTerm&) const = default;
};

inline constexpr int kMostMagneticDegree = 30;

/// A model of the Earth's magnetic field, as the World Magnetic Model is one (specs: morse.md B.2,
/// Magnetometer). As delivered: the terms of the first degree of the model of 2015, a tilted dipole
/// at the Earth's centre, which is off by up to a third of the field's strength.
struct MagneticFieldDef {
  double epoch = 2015.0;  ///< year, with its decimals
  double date = 2015.0;   ///< year for which it is asked, where a sensor does not say another
  std::vector<MagneticTerm> terms = {{1, 0, -29438.5, 0.0, 10.7, 0.0},
                                     {1, 1, -1501.1, 4796.2, 17.9, -26.8}};

  bool operator==(const MagneticFieldDef&) const = default;
};

/// Reads a file of the World Magnetic Model's form, a WMM.COF: a line of the epoch and the model's
/// name, then lines of n, m, g, h and their changes a year, until one of nines. `date` is the
/// epoch. Throws Error "FILE:LINE: ...".
MagneticFieldDef LoadMagneticField(const std::string& file);

/// The same from the file's text; `file` names it in messages.
MagneticFieldDef ParseMagneticField(const std::string& text, const std::string& file);

}  // namespace ccmorse::scene
