#pragma once

// Where things are, maps and plans: proxies of libplayerc++ (specs: player.md A.4,
// player-interfaces.txt). What they share, errors and threads too, is said at ClientProxy.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "libplayerc++/clientproxy.h"

namespace PlayerCc {

/// A receiver of GPS.
class GpsProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit GpsProxy(PlayerClient* client, std::uint32_t index = 0);
  ~GpsProxy() override;

  double GetLatitude() const;   ///< deg
  double GetLongitude() const;  ///< deg
  double GetAltitude() const;   ///< m
  double GetSpeed() const;      ///< m/s
  double GetCourse() const;     ///< rad
  std::uint32_t GetSatellites() const;
  std::uint32_t GetQuality() const;  ///< 0 none,1 GPS,2 DGPS
  double GetHdop() const;
  double GetVdop() const;
  double GetUtmEasting() const;     ///< m
  double GetUtmNorthing() const;    ///< m
  double GetTime() const;           ///< s since epoch
  double GetErrHorizontal() const;  ///< m
  double GetErrVertical() const;    ///< m
};

/// A unit of inertial sensors.
class ImuProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit ImuProxy(PlayerClient* client, std::uint32_t index = 0);
  ~ImuProxy() override;

  player_pose3d_t GetPose() const;  ///< pose3d
  float GetXAccel();                ///< m/s^2
  float GetYAccel();                ///< m/s^2
  float GetZAccel();                ///< m/s^2
  float GetXGyro();                 ///< rad/s
  float GetYGyro();                 ///< rad/s
  float GetZGyro();                 ///< rad/s
  float GetXMagn();                 ///< driver unit
  float GetYMagn();
  float GetZMagn();
  player_imu_data_calib_t GetRawValues() const;  ///< all nine
  void SetDatatype(int datatype);                ///< 1..5 = state, calib, quat, euler, fullstate
  void ResetOrientation(int value);              ///< driver code
  void ResetEuler(float roll, float pitch, float yaw);  ///< rad
};

/// Where the robot may be: hypotheses and particles.
class LocalizeProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit LocalizeProxy(PlayerClient* client, std::uint32_t index = 0);
  ~LocalizeProxy() override;

  std::uint32_t GetMapSizeX() const;  ///< cells
  std::uint32_t GetMapSizeY() const;  ///< cells
  std::uint32_t GetMapTileX() const;
  std::uint32_t GetMapTileY() const;
  double GetMapScale() const;             ///< m/cell
  std::uint32_t GetPendingCount() const;  ///< sensor readings not yet processed
  std::uint32_t GetHypothCount() const;
  /// Player_localize_hypoth_t {mean pose2d, cov6 = xx,yy,aa,xy,ya,xa, alpha weight}.
  player_localize_hypoth_t GetHypoth(std::uint32_t index) const;
  int GetParticles();                                ///< request; 0 on success
  player_pose2d_t GetParticlePose(int index) const;  ///< after GetParticles
  void SetPose(double pose[3], double cov[6]);  ///< initial pose double3 and covariance double6
  std::uint32_t GetNumHypoths() const;          ///< the same number
  std::uint32_t GetNumParticles() const;
};

/// A grid map. GetCell() and GetCellIndex() count from the lower-left cell.
class MapProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit MapProxy(PlayerClient* client, std::uint32_t index = 0);
  ~MapProxy() override;

  void RequestMap();  ///< info then data in tiles of at most 640x640, each zlib-deflated
  int GetCellIndex(int x, int y) const;  ///< y*width+x
  /// -1 free, 0 unknown, +1 occupied (times data range).
  std::int8_t GetCell(int x, int y) const;
  double GetResolution() const;     ///< m/cell
  std::uint32_t GetWidth() const;   ///< cells
  std::uint32_t GetHeight() const;  ///< cells
  double GetOriginX() const;        ///< m of the lower-left corner
  double GetOriginY() const;        ///< m
  std::int8_t GetDataRange() const;
  void GetMap(std::int8_t* map) const;  ///< copies width*height bytes
};

/// A planner of paths; m and rad in the map's frame.
class PlannerProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit PlannerProxy(PlayerClient* client, std::uint32_t index = 0);
  ~PlannerProxy() override;

  void SetGoalPose(double gx, double gy, double ga);  ///< m,m,rad map frame
  void SetStartPose(double sx, double sy, double sa);
  void RequestWaypoints();             ///< fills the list
  void SetEnable(bool enable);         ///< pause/resume motion
  std::uint32_t GetPathValid() const;  ///< 1 if a plan exists
  std::uint32_t GetPathDone() const;   ///< 1 when the goal was reached
  double GetPathLength() const;        ///< m after RequestWaypoints
  double GetPx() const;
  double GetPy() const;
  double GetPa() const;
  player_pose2d_t GetPose() const;  ///< current pose
  double GetGx() const;
  double GetGy() const;
  double GetGa() const;
  player_pose2d_t GetGoal() const;
  double GetWx() const;
  double GetWy() const;
  double GetWa() const;
  player_pose2d_t GetCurrentWaypoint() const;
  double GetIx(int i) const;
  double GetIy(int i) const;
  double GetIa(int i) const;
  player_pose2d_t GetWaypoint(std::uint32_t index) const;
  int GetCurrentWaypointId() const;  ///< negative without a plan
  std::uint32_t GetWaypointCount() const;
  player_pose2d_t operator[](std::uint32_t index) const;  ///< as the getter with an index
};

/// A map of layers of features, each in the well-known binary form.
class VectorMapProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit VectorMapProxy(PlayerClient* client, std::uint32_t index = 0);
  ~VectorMapProxy() override;

  void GetMapInfo();
  void GetLayerData(unsigned int layer_index);
  int GetLayerCount() const;
  std::vector<std::string> GetLayerNames() const;
  int GetFeatureCount(unsigned int layer_index) const;
  const std::uint8_t* GetFeatureData(unsigned int layer_index, unsigned int feature_index) const;
  std::size_t GetFeatureDataCount(unsigned int layer_index, unsigned int feature_index) const;
};

}  // namespace PlayerCc
