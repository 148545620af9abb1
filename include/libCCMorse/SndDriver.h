#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "libCCMorse/MorseDriver.h"
#include "libCCMorse/Types.h"

namespace CCMorse {

/// Goes to a goal among obstacles that it sees with the laser, without a map: Player's driver "snd"
/// (thesis 3.1.3: it uses Position2dProxy and LaserProxy), smooth nearness diagram navigation by
/// J. W. Durham and F. Bullo, 2008. Having no map, it may be caught in a pocket that lies between
/// it and the goal.
///
///     CCMorse::SndDriver snd(&client);
///     snd.Start();
///     snd.GoTo(2.0, 2.5, 0.0);
///     bool there = snd.WaitForArrival(60.0);
///
/// Settings: "drivers": {"snd": {...}} of the robot's configuration (thesis 3.2), with Player's
/// names and units, angles in degrees: robot_radius, min_gap_width, obstacle_avoid_dist (m),
/// max_speed (m/s), max_turn_rate (deg/s), goal_position_tol (m), goal_angle_tol (deg). What is
/// not set has a value that suits the S1R.
///
/// The driver's thread calls PlayerClient::Read(), so the program has no need to; it commands
/// speeds only while it has a goal. Owned by the program, which keeps the client until the driver
/// is gone. Every method but the base class's Start(), Stop() and Join() is for any thread.
class SndDriver : public MorseDriver {
 public:
  /// `robot`: name of the robot, empty for the first; the indexes are those of its proxies. Throws
  /// MorseError for a robot or an index that there is not, and for a setting that is unknown or
  /// not a positive number.
  explicit SndDriver(PlayerClient* client, const std::string& robot = "",
                     std::uint32_t position_index = 0, std::uint32_t laser_index = 0);
  /// Stops the thread and, if it was under way, the robot.
  ~SndDriver() override;

  /// Goes to (x, y), m, and turns there to `yaw`, rad, in the frame of Position2dProxy; takes the
  /// place of an earlier goal. May be called before Start(). Throws MorseError when a number is
  /// not finite.
  void GoTo(double x, double y, double yaw);
  void GoTo(player_pose2d_t goal);  ///< as above
  /// Gives the goal up; the robot stops.
  void Cancel();

  bool HasGoal() const;    ///< whether a goal was given and not given up
  bool IsArrived() const;  ///< whether the robot has reached the goal, position and heading
  /// Whether something is so near that the robot cannot go on; it waits then.
  bool IsStalled() const;
  /// Waits until IsArrived(), at most `timeout` seconds of simulated time from now; returns it.
  /// Returns at once when the driver does not run, and when it ends.
  bool WaitForArrival(double timeout);

  // The settings in use.
  double GetRobotRadius() const;        ///< m
  double GetMinGapWidth() const;        ///< m
  double GetObstacleAvoidDist() const;  ///< m
  double GetMaxSpeed() const;           ///< m/s
  double GetMaxTurnRate() const;        ///< rad/s
  double GetGoalPositionTol() const;    ///< m
  double GetGoalAngleTol() const;       ///< rad

 protected:
  void Main() override;

 private:
  struct Parts;
  const std::unique_ptr<Parts> parts_;
};

}  // namespace CCMorse
