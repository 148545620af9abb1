#pragma once

#include <cstddef>
#include <vector>

#include "libCCMorse/MorseSensor.h"

namespace CCMorse {

/// A laser scanner, MORSE's LaserScanner and its kinds (thesis 4.1.2). Beam 0 is the right-most
/// one; indexes run counter-clockwise. Settings are read once, when the client connects. Getters
/// give 0 before the first data. Owned by the client; any thread.
class MorseLaser : public MorseSensor {
 public:
  explicit MorseLaser(const MorseDeviceInfo& info);

  double GetMaxRange() const { return max_range_; }         ///< m
  double GetResolution() const { return resolution_; }      ///< rad between two beams
  double GetScanWindow() const { return scan_window_; }     ///< rad from the first beam to the last
  double GetMinAngle() const { return -scan_window_ / 2; }  ///< rad, bearing of beam 0
  double GetMaxAngle() const { return scan_window_ / 2; }   ///< rad, the scan's other edge
  double GetFrequency() const { return frequency_; }        ///< scans a second; 0 when unknown
  /// Where the scanner sits on the robot, m and rad.
  player_pose3d_t GetMounting() const { return mounting_; }

  /// Beams of the last scan.
  std::size_t GetCount() const;
  /// All ranges of the last scan, m; a beam without return has the highest range.
  std::vector<double> GetRanges() const;
  /// The same into `ranges`, which keeps its memory.
  void CopyRanges(std::vector<double>& ranges) const;
  /// Range of beam `index`, m. Throws MorseError when there is no such beam.
  double GetRange(std::size_t index) const;
  /// Bearing of beam `index`, rad, whether or not the last scan has that many.
  double GetBearing(std::size_t index) const;
  /// Shortest range of the last scan, m; the highest range when there is no scan.
  double GetMinRange() const;
  /// Bearing of the shortest range (thesis 3.1.2), rad; of the right-most one if several are equal,
  /// 0 when there is no scan.
  double GetMinRangeAngle() const;

 protected:
  std::vector<std::string> SetupServices() const override;
  void OnSetup(const std::string& service, const MorseValue& answer) override;
  bool OnData(const MorseValue& data) override;
  DataForm Form() const override;
  bool OnNumbers(const double* numbers, std::size_t count) override;

 private:
  // Written once, while the client connects.
  double max_range_ = 0.0;
  double resolution_ = 0.0;
  double scan_window_ = 0.0;
  double frequency_ = 0.0;
  player_pose3d_t mounting_{};
  std::vector<double> ranges_;
};

/// The S1R's scanner (thesis 4.1.2).
using MorseHokuyo = MorseLaser;

}  // namespace CCMorse
