#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "libCCMorse/MorseProxy.h"
#include "libCCMorse/Types.h"

namespace CCMorse {

class MorseOdometry;
class MorsePose;

/// A robot that moves in the plane (thesis 3.1.3), with the methods of Player's Position2dProxy. It
/// joins the robot's pose sensor, odometry and motion actuator. The index decides where positions
/// come from: the robot's configuration says which index means the pose in the world and which the
/// odometry (thesis 3.2). Owned by the program; see MorseProxy for lifetimes. Any thread.
class Position2dProxy : public MorseProxy {
 public:
  /// `robot`: name of the robot; empty takes the first that has this index. Throws MorseError that
  /// lists the indexes when there is none.
  explicit Position2dProxy(PlayerClient* client, std::uint32_t index = 0,
                           const std::string& robot = "");
  ~Position2dProxy() override;

  // --- Commands. They leave with the next Read() and are ignored while the motors are off.

  /// Forward speed, m/s, and turn rate, rad/s counter-clockwise, held within the robot's limits.
  /// Throws MorseError when a number is not finite or the robot cannot be driven by speeds.
  void SetSpeed(double x_speed, double yaw_speed);
  /// As above; a robot with two wheels cannot go sideways, so `y_speed` is dropped.
  void SetSpeed(double x_speed, double y_speed, double yaw_speed);
  /// As above, from a pose of speeds.
  void SetSpeed(player_pose2d_t velocity);
  /// Forward speed, m/s, while turning towards the heading `yaw_head`, rad. The turn rate follows
  /// from the heading at the time of the call, so call it in the control loop.
  void SetVelHead(double x_speed, double yaw_head);
  /// As above; `y_speed` is dropped, as in Player.
  void SetVelHead(double x_speed, double y_speed, double yaw_head);
  /// Goes to (x, y), m in the frame of GetXPos(), by the robot's waypoint actuator, in a straight
  /// line and without regard for obstacles. The heading at the goal is not controlled. Throws
  /// MorseError when a number is not finite or the robot has no such actuator.
  void GoTo(double x, double y, double yaw);
  void GoTo(player_pose2d_t position);
  /// As above, at most at the speed `velocity.px`, m/s; 0: the robot's highest.
  void GoTo(player_pose2d_t position, player_pose2d_t velocity);
  /// Drives like a car with a steering angle, rad: turn rate = speed tan(angle) / wheel track.
  /// Throws MorseError when the robot does not tell its wheel track.
  void SetCarlike(double x_speed, double drive_angle);
  /// Motors on or off. Off stops the robot at once and ignores commands until they are on. They are
  /// on at first.
  void SetMotorEnable(bool enable);

  // --- The frame of positions

  /// Makes the present position the origin.
  void ResetOdometry();
  /// Makes the present position (x, y, yaw), m and rad; the library moves the frame, the simulation
  /// does not notice. Without data yet, it holds for the first ones.
  void SetOdometry(double x, double y, double yaw);

  // --- Data, of the last Read()

  double GetXPos() const;      ///< m
  double GetYPos() const;      ///< m
  double GetYaw() const;       ///< rad, -pi..pi, counter-clockwise
  double GetXSpeed() const;    ///< m/s, forward, by the odometry; 0 without one
  double GetYSpeed() const;    ///< m/s, to the left; 0 without odometry
  double GetYawSpeed() const;  ///< rad/s, counter-clockwise; 0 without odometry
  /// Whether the robot pushes against something and does not get on; false on plain MORSE.
  bool GetStall() const;
  /// Position and heading in one consistent copy, m and rad.
  player_pose2d_t GetPose() const;

  /// Takes the robot's size from its configuration. Throws MorseError when there is none.
  void RequestGeom();
  /// Pose of the base in its own frame: 0 until RequestGeom() and after it.
  player_pose3d_t GetOffset() const;
  /// Size of the robot, m; 0 before RequestGeom().
  player_bbox3d_t GetSize() const;

 private:
  Position2dProxy(PlayerClient* client, std::uint32_t index, MorseDevice& source);
  player_pose2d_t RawPose(bool* has_data) const;
  player_pose2d_t ToWorld(player_pose2d_t pose) const;

  MorsePose* pose_ = nullptr;          // where positions come from: this one
  MorseOdometry* odometry_ = nullptr;  // or this one
  MorseOdometry* speeds_ = nullptr;    // may be missing
  // Under ProxyMutex().
  bool motors_on_ = true;
  mutable std::optional<player_pose2d_t> awaited_;  // SetOdometry() before the first data
  mutable player_pose2d_t frame_;                   // pose of the sensor's frame in ours
  player_bbox3d_t size_;
};

/// Prints a heading and one line of pose, speeds and stall, as Player's proxies print themselves.
std::ostream& operator<<(std::ostream& out, const Position2dProxy& proxy);

}  // namespace CCMorse
