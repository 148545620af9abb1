#pragma once

// Sensors of distance and contact: proxies of libplayerc++ (specs: player.md A.4,
// player-interfaces.txt). What they share, errors and threads too, is said at ClientProxy.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "libplayerc++/clientproxy.h"

namespace PlayerCc {

/// Switches that notice contact.
class BumperProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit BumperProxy(PlayerClient* client, std::uint32_t index = 0);
  ~BumperProxy() override;

  std::uint32_t GetCount() const;  ///< number of elements in the last data message
  std::uint32_t IsBumped(std::uint32_t index) const;  ///< non-zero if pressed
  bool IsAnyBumped();
  void RequestBumperConfig();
  std::uint32_t GetPoseCount() const;  ///< after RequestBumperConfig
  /// Player_bumper_define_t {pose,length,radius}.
  player_bumper_define_t GetPose(std::uint32_t index) const;
  bool operator[](std::uint32_t index) const;  ///< as the getter with an index
};

/// A ring of infrared sensors.
class IrProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit IrProxy(PlayerClient* client, std::uint32_t index = 0);
  ~IrProxy() override;

  std::uint32_t GetCount() const;                ///< number of elements in the last data message
  double GetRange(std::uint32_t index) const;    ///< m
  double GetVoltage(std::uint32_t index) const;  ///< V
  std::uint32_t GetPoseCount() const;            ///< after RequestGeom
  player_pose3d_t GetPose(std::uint32_t index) const;  ///< pose3d
  void RequestGeom();
  double operator[](std::uint32_t index) const;  ///< as the getter with an index
};

/// A laser scanner. Beam 0 is the right-most one; indexes run counter-clockwise.
class LaserProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit LaserProxy(PlayerClient* client, std::uint32_t index = 0);
  /// `robot`: the simulated robot that is meant; empty: the first that has this index.
  LaserProxy(PlayerClient* client, std::uint32_t index, const std::string& robot);
  ~LaserProxy() override;

  std::uint32_t GetCount() const;       ///< number of elements in the last data message
  double GetMaxRange() const;           ///< m of last scan
  double GetScanRes() const;            ///< angular step rad
  double GetRangeRes() const;           ///< from the config request (m)
  double GetScanningFrequency() const;  ///< Hz after (Request)Configure
  double GetMinAngle() const;           ///< first beam rad of last scan
  double GetMaxAngle() const;           ///< computed min+(n-1)*res rad
  double GetConfMinAngle() const;       ///< after RequestConfigure
  double GetConfMaxAngle() const;       ///< after RequestConfigure
  bool IntensityOn() const;             ///< from config
  player_point_2d_t GetPoint(std::uint32_t index) const;  ///< Cartesian x,y m in laser frame
  double GetRange(std::uint32_t index) const;    ///< m, index 0 = rightmost beam, counter-clockwise
  double GetBearing(std::uint32_t index) const;  ///< rad
  int GetIntensity(std::uint32_t index) const;   ///< 0..255
  int GetID() const;                             ///< after RequestID
  /// Angles rad, resolution, range resolution, intensity flag, frequency.
  void Configure(double min_angle, double max_angle, std::uint32_t scan_res,
                 std::uint32_t range_res, bool intensity, double scanning_frequency);
  void RequestConfigure();
  void RequestID();
  void RequestGeom();
  player_pose3d_t GetPose();                     ///< pose on the parent (px,py,pyaw)
  player_pose3d_t GetRobotPose();                ///< from SCANPOSE messages only
  player_bbox3d_t GetSize();                     ///< sl,sw m, default 0.15
  double GetMinLeft() const;                     ///< minimum over indices > n/2
  double GetMinRight() const;                    ///< minimum over indices <= n/2
  double MinLeft() const;                        ///< deprecated alias
  double MinRight() const;                       ///< deprecated alias
  double operator[](std::uint32_t index) const;  ///< as the getter with an index
};

/// Points in space.
class Pointcloud3dProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit Pointcloud3dProxy(PlayerClient* client, std::uint32_t index = 0);
  ~Pointcloud3dProxy() override;

  std::uint32_t GetCount() const;  ///< number of elements in the last data message
  player_pointcloud3d_element_t GetPoint(std::uint32_t index) const;
  /// As the getter with an index.
  player_pointcloud3d_element_t operator[](std::uint32_t index) const;
};

/// Sensors of distance of any kind: one that scans, or several in a ring.
class RangerProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit RangerProxy(PlayerClient* client, std::uint32_t index = 0);
  ~RangerProxy() override;

  std::uint32_t GetElementCount() const;  ///< number of transducers (1 for a laser)
  player_pose3d_t GetDevicePose() const;  ///< pose3d m,rad
  player_bbox3d_t GetDeviceSize() const;  ///< bbox3d m
  player_pose3d_t GetElementPose(std::uint32_t index) const;
  player_bbox3d_t GetElementSize(std::uint32_t index) const;
  std::uint32_t GetRangeCount() const;           ///< readings in last scan
  double GetRange(std::uint32_t index) const;    ///< m
  double operator[](std::uint32_t index) const;  ///< as the getter with an index
  std::uint32_t GetPointCount() const;
  /// 3-D point, computed by the client from geometry+config.
  player_point_3d_t GetPoint(std::uint32_t index) const;
  std::uint32_t GetIntensityCount() const;
  double GetIntensity(std::uint32_t index) const;  ///< double
  void SetPower(bool enable);
  void SetIntensityData(bool enable);
  void RequestGeom();
  /// Rad, rad, rad, m, m, m, Hz.
  void Configure(double min_angle, double max_angle, double angular_res, double min_range,
                 double max_range, double range_res, double frequency);
  void RequestConfigure();
  double GetMinAngle() const;    ///< configured rad
  double GetMaxAngle() const;    ///< configured rad
  double GetAngularRes() const;  ///< configured rad
  double GetMinRange() const;    ///< m
  double GetMaxRange() const;    ///< m
  double GetRangeRes() const;    ///< m
  double GetFrequency() const;   ///< Hz
};

/// A ring of sonars.
class SonarProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit SonarProxy(PlayerClient* client, std::uint32_t index = 0);
  ~SonarProxy() override;

  std::uint32_t GetCount() const;                ///< number of elements in the last data message
  double GetScan(std::uint32_t index) const;     ///< m; -1.0 if index out of range
  double operator[](std::uint32_t index) const;  ///< as the getter with an index
  std::uint32_t GetPoseCount() const;            ///< after RequestGeom
  player_pose3d_t GetPose(std::uint32_t index) const;  ///< pose3d
  void RequestGeom();                                  ///< a refusal is ignored
};

}  // namespace PlayerCc
