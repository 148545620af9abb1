#pragma once

#include <span>
#include <vector>

#include "base/pose.h"

namespace ccmorse::navigation {

/// One scan of a range finder, borrowed from whoever has it.
struct ScanView {
  double min_angle = 0.0;          ///< rad, bearing of ranges[0] in the scanner's frame
  double resolution = 0.0;         ///< rad from one beam to the next, counter-clockwise, > 0
  double range_max = 0.0;          ///< m, what a beam without return has, > 0
  std::span<const double> ranges;  ///< m; NaN, negative and more than range_max: no return
  Pose2 mount;                     ///< the scanner on the robot, m and rad
};

/// A scan that owns its ranges.
struct Scan {
  double min_angle = 0.0;      ///< as in ScanView
  double resolution = 0.0;     ///< as in ScanView
  double range_max = 0.0;      ///< as in ScanView
  std::vector<double> ranges;  ///< as in ScanView

  /// The same, borrowed; mounted in the robot's origin.
  ScanView View() const { return {min_angle, resolution, range_max, ranges, {}}; }
};

/// The range as a number of [0, range_max]: what is no measurement counts as no return.
double CleanRange(double range, double range_max);

/// Ends of the beams that met something, m in the robot's frame.
std::vector<Vec2> HitPoints(const ScanView& scan);

/// The scan as a scanner in the robot's origin would see the same points: all around, with the
/// resolution of `scan`, nothing known where it did not look (range_max). The algorithms of
/// obstacle avoidance take ranges as distances from the middle of a round robot, which an error of
/// the S1R's 35 mm would spoil: it is a third of the robot. Directions that fall between two
/// neighbouring beams get the farther one's distance, so that a gap stays a gap.
Scan CentreScan(const ScanView& scan);

}  // namespace ccmorse::navigation
