#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "libCCMorse/MorseProxy.h"
#include "libCCMorse/Types.h"

namespace CCMorse {

class MorseLaser;

/// A laser scanner (thesis 3.1.3), with the methods of Player's LaserProxy. Beam 0 is the
/// right-most one; indexes run counter-clockwise. Owned by the program; see MorseProxy for
/// lifetimes. Any thread.
class LaserProxy : public MorseProxy {
 public:
  /// `robot`: name of the robot; empty takes the first that has this index. Throws MorseError that
  /// lists the indexes when there is none.
  explicit LaserProxy(PlayerClient* client, std::uint32_t index = 0, const std::string& robot = "");
  ~LaserProxy() override;

  std::uint32_t GetCount() const;       ///< beams of the last scan; 0 before the first
  double GetMaxRange() const;           ///< m; also the range of a beam without return
  double GetScanRes() const;            ///< rad between two beams
  double GetRangeRes() const;           ///< 0: ranges are not rounded
  double GetScanningFrequency() const;  ///< scans a second; 0 when unknown
  double GetMinAngle() const;           ///< rad, bearing of beam 0
  double GetMaxAngle() const;           ///< rad, the other edge of the scan
  double GetConfMinAngle() const;       ///< as GetMinAngle()
  double GetConfMaxAngle() const;       ///< as GetMaxAngle()
  bool IntensityOn() const;             ///< false: the scanner measures ranges only

  /// Range of a beam, m; a beam without return has GetMaxRange(). Throws MorseError when the last
  /// scan has no such beam.
  double GetRange(std::uint32_t index) const;
  /// As GetRange().
  double operator[](std::uint32_t index) const { return GetRange(index); }
  double GetBearing(std::uint32_t index) const;  ///< rad
  /// Where the beam ends, m in the scanner's frame. Throws as GetRange().
  player_point_2d_t GetPoint(std::uint32_t index) const;
  /// 0. Throws as GetRange().
  int GetIntensity(std::uint32_t index) const;
  /// Shortest range of the left half, indexes above half of the count, m; GetMaxRange() for no
  /// scan.
  double GetMinLeft() const;
  /// Shortest range of the right half, m; GetMaxRange() when there is no scan.
  double GetMinRight() const;
  double MinLeft() const { return GetMinLeft(); }    ///< old name of GetMinLeft()
  double MinRight() const { return GetMinRight(); }  ///< old name of GetMinRight()

  /// Throws MorseError always: MORSE's scanners are set up in the scene.
  void Configure(double min_angle, double max_angle, std::uint32_t scan_res,
                 std::uint32_t range_res, bool intensity, double scanning_frequency);
  /// Nothing to do: the settings are known since the client connected.
  void RequestConfigure();
  /// Throws MorseError always: MORSE's scanners have no serial number.
  void RequestID();
  int GetID() const;  ///< -1
  /// Nothing to do: the geometry is known since the client connected.
  void RequestGeom();
  player_pose3d_t GetPose() const;  ///< where the scanner sits on the robot, m and rad
  /// Pose of the robot in the world at the last Read(), m and rad; zeros without a pose sensor.
  player_pose3d_t GetRobotPose() const;
  player_bbox3d_t GetSize() const;  ///< of the scanner: Player's default of 0.15 m

 private:
  LaserProxy(PlayerClient* client, std::uint32_t index, MorseDevice& laser);
  MorseLaser* const laser_;  // owned by the client object, which the base class keeps alive
};

/// Prints a heading and one line a beam: range and bearing.
std::ostream& operator<<(std::ostream& out, const LaserProxy& proxy);

}  // namespace CCMorse
