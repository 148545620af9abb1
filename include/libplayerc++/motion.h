#pragma once

// Things that move: proxies of libplayerc++ (specs: player.md A.4, player-interfaces.txt). What
// they share, errors and threads too, is said at ClientProxy.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "libplayerc++/clientproxy.h"

namespace PlayerCc {

/// An array of actuators, such as the joints of an arm; joints count from 0.
class ActArrayProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit ActArrayProxy(PlayerClient* client, std::uint32_t index = 0);
  ~ActArrayProxy() override;

  void RequestGeometry();
  void SetPowerConfig(bool val);
  void SetBrakesConfig(bool val);
  void SetSpeedConfig(std::uint32_t joint, float speed);
  void SetAccelerationConfig(std::uint32_t joint, float acc);
  void MoveTo(std::uint32_t joint, float pos);  ///< m or rad
  void MoveToMulti(std::vector<float> pos);
  void MoveAtSpeed(std::uint32_t joint, float speed);  ///< m/s or rad/s
  void MoveAtSpeedMulti(std::vector<float> speed);
  void MoveHome(int joint);  ///< -1 = all
  void SetActuatorCurrent(std::uint32_t joint, float current);
  void SetActuatorCurrentMulti(std::vector<float> current);
  std::uint32_t GetCount() const;  ///< number of elements in the last data message
  /// Position,speed,acceleration,current,state.
  player_actarray_actuator_t GetActuatorData(std::uint32_t joint) const;
  player_actarray_actuatorgeom_t GetActuatorGeom(std::uint32_t joint) const;
  player_point_3d_t GetBasePos() const;
  player_orientation_3d_t GetBaseOrientation() const;
  player_actarray_actuator_t operator[](std::uint32_t joint);  ///< as the getter with an index
};

/// A gripper.
class GripperProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit GripperProxy(PlayerClient* client, std::uint32_t index = 0);
  ~GripperProxy() override;

  void RequestGeometry();
  std::uint32_t GetState() const;  ///< 1 open 2 closed 3 moving 4 error
  std::uint32_t GetBeams() const;  ///< bit mask
  player_pose3d_t GetPose() const;
  player_bbox3d_t GetOuterSize() const;
  player_bbox3d_t GetInnerSize() const;
  std::uint32_t GetNumBeams() const;
  std::uint32_t GetCapacity() const;
  std::uint32_t GetStored() const;
  void Open();  ///< command;  if it cannot be sent
  void Close();
  void Stop();
  void Store();
  void Retrieve();
};

/// An arm that is commanded by the pose of its end.
class LimbProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit LimbProxy(PlayerClient* client, std::uint32_t index = 0);
  ~LimbProxy() override;

  void RequestGeometry();
  void SetPowerConfig(bool val);
  void SetBrakesConfig(bool val);
  void SetSpeedConfig(float speed);
  void MoveHome();
  void Stop();
  void SetPose(float px, float py, float pz, float ax, float ay, float az, float ox, float oy,
               float oz);
  void SetPosition(float x, float y, float z);
  void VectorMove(float x, float y, float z, float length);
  player_limb_data_t GetData() const;
  player_limb_geom_req_t GetGeom() const;
};

/// An actuator along or about one axis, m or rad.
class Position1dProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit Position1dProxy(PlayerClient* client, std::uint32_t index = 0);
  ~Position1dProxy() override;

  void SetSpeed(double vel);          ///< m/s or rad/s
  void GoTo(double pos, double vel);  ///< pos, vel
  void RequestGeom();
  player_pose3d_t GetPose() const;
  player_bbox3d_t GetSize() const;
  void SetMotorEnable(bool enable);
  void SetOdometry(double pos);
  void ResetOdometry();
  double GetPos() const;  ///< m or rad
  double GetVel() const;
  bool GetStall() const;
  /// Bit field: 0 min,1 centre,2 max limit,3 over-current,4 trajectory complete,5 enabled.
  std::uint8_t GetStatus() const;
  bool IsLimitMin() const;
  bool IsLimitCen() const;
  bool IsLimitMax() const;
  bool IsOverCurrent() const;
  bool IsTrajComplete() const;
  bool IsEnabled() const;
};

/// A robot that moves in the plane: m, rad, m/s and rad/s; angles counter-clockwise.
class Position2dProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit Position2dProxy(PlayerClient* client, std::uint32_t index = 0);
  /// `robot`: the simulated robot that is meant; empty: the first that has this index.
  Position2dProxy(PlayerClient* client, std::uint32_t index, const std::string& robot);
  ~Position2dProxy() override;

  /// Speeds to the front, to the left (where given), m/s, and turn rate, rad/s; leaves at once or
  /// with the next Read().
  void SetSpeed(double x_speed, double y_speed, double yaw_speed);
  /// Speeds to the front, to the left (where given), m/s, and turn rate, rad/s; leaves at once or
  /// with the next Read().
  void SetSpeed(double x_speed, double yaw_speed);
  /// Speeds to the front, to the left (where given), m/s, and turn rate, rad/s; leaves at once or
  /// with the next Read().
  void SetSpeed(player_pose2d_t vel);
  /// Speed to the front, m/s, and the heading to keep, rad; a speed to the side is dropped.
  void SetVelHead(double x_speed, double y_speed, double yaw_head);
  /// Speed to the front, m/s, and the heading to keep, rad; a speed to the side is dropped.
  void SetVelHead(double x_speed, double yaw_head);
  /// Goal, m and rad in the frame of GetXPos(); speeds of 0 leave them to the driver, which must be
  /// one that controls positions.
  void GoTo(player_pose2d_t pos, player_pose2d_t vel);
  /// Goal, m and rad in the frame of GetXPos(); speeds of 0 leave them to the driver, which must be
  /// one that controls positions.
  void GoTo(player_pose2d_t pos);
  /// Goal, m and rad in the frame of GetXPos(); speeds of 0 leave them to the driver, which must be
  /// one that controls positions.
  void GoTo(double x, double y, double yaw);
  void SetCarlike(double x_speed, double drive_angle);  ///< forward speed m/s, steering angle rad
  void RequestGeom();                                   ///< asks for GetOffset() and GetSize()
  player_pose3d_t GetOffset();       ///< pose of the base in its own frame, m and rad
  player_bbox3d_t GetSize();         ///< m
  void SetMotorEnable(bool enable);  ///< a request; a refusal is ignored
  void ResetOdometry();              ///< SetOdometry(0, 0, 0)
  /// Makes the present pose this one, m and rad; a refusal is ignored.
  void SetOdometry(double x, double y, double yaw);
  double GetXPos() const;      ///< m, in the frame of the odometry
  double GetYPos() const;      ///< m
  double GetYaw() const;       ///< rad
  double GetXSpeed() const;    ///< m/s
  double GetYSpeed() const;    ///< m/s
  double GetYawSpeed() const;  ///< rad/s
  bool GetStall() const;       ///< collision/stall flag
};

/// A robot that moves in space: m, rad, m/s and rad/s.
class Position3dProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit Position3dProxy(PlayerClient* client, std::uint32_t index = 0);
  ~Position3dProxy() override;

  /// M/s and rad/s; leaves at once.
  void SetSpeed(double x_speed, double y_speed, double z_speed, double roll_speed,
                double pitch_speed, double yaw_speed);
  /// M/s and rad/s; leaves at once.
  void SetSpeed(double x_speed, double y_speed, double z_speed, double yaw_speed);
  /// M/s and rad/s; leaves at once.
  void SetSpeed(double x_speed, double y_speed, double yaw_speed);
  void SetSpeed(double x_speed, double yaw_speed);      ///< m/s and rad/s; leaves at once
  void SetSpeed(player_pose3d_t vel);                   ///< m/s and rad/s; leaves at once
  void GoTo(player_pose3d_t pos, player_pose3d_t vel);  ///< m, rad
  void GoTo(player_pose3d_t pos);                       ///< m, rad
  void GoTo(double x, double y, double z, double roll, double pitch, double yaw);  ///< m, rad
  void SetMotorEnable(bool enable);
  void SelectVelocityControl(int mode);  ///< driver specific
  void ResetOdometry();
  /// M, rad.
  void SetOdometry(double x, double y, double z, double roll, double pitch, double yaw);
  void RequestGeom();
  double GetXPos() const;        ///< m
  double GetYPos() const;        ///< m
  double GetZPos() const;        ///< m
  double GetRoll() const;        ///< rad
  double GetPitch() const;       ///< rad
  double GetYaw() const;         ///< rad
  double GetXSpeed() const;      ///< m/s
  double GetYSpeed() const;      ///< m/s
  double GetZSpeed() const;      ///< m/s
  double GetRollSpeed() const;   ///< rad/s
  double GetPitchSpeed() const;  ///< rad/s
  double GetYawSpeed() const;    ///< rad/s
  bool GetStall() const;
};

/// A camera's pan, tilt and zoom, rad.
class PtzProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit PtzProxy(PlayerClient* client, std::uint32_t index = 0);
  ~PtzProxy() override;

  /// Pan, tilt, zoom passed on as given (interface unit: rad; header says degrees).
  void SetCam(double pan, double tilt, double zoom);
  /// Rad/s; zoom speed ignored.
  void SetSpeed(double pan_speed = 0, double tilt_speed = 0, double zoom_speed = 0);
  void SelectControlMode(std::uint32_t mode);  ///< 0 velocity, 1 position
  double GetPan() const;                       ///< rad
  double GetTilt() const;                      ///< rad
  double GetZoom() const;                      ///< rad
  int GetStatus();                             ///< request
};

}  // namespace PlayerCc
