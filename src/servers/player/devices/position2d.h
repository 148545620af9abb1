#pragma once

#include <optional>
#include <vector>

#include "base/pose.h"
#include "servers/player/device.h"
#include "servers/player/device_context.h"
#include "sim/component.h"
#include "sim/robots/robot.h"

namespace ccmorse::servers::player {

/// position2d of a robot: its pose by one of its sensors, odometry or the global one, and, where it
/// drives, its motion (specs: player.md B.7, C.3; SyRoTek's conventions: syrotek.md A). Commands:
/// VEL (the side speed is dropped: two wheels), CAR (angle of a front wheel as far before the axle
/// as the wheels are apart), VEL_HEAD and POS, which are driven to on the device's own pose as
/// Stage does it: turn on the spot, go, turn to the final heading. MOTOR_POWER off stops the robot
/// and has it stay until it is on again. SET_ODOM and RESET_ODOM move the frame that the device
/// tells of, not the robot.
class Position2d : public Device {
 public:
  /// `sensor` is the robot's "odometry" or "pose"; published at `frequency` (Hz).
  Position2d(DeviceContext context, const sim::Robot& robot, std::uint16_t index,
             const sim::Sensor& sensor, bool drives, double frequency);

  void Step() override;

 protected:
  bool Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) override;
  void Tell(std::uint8_t subtype, const wire::Body& body) override;
  void LastLeft() override;

 private:
  void Read();  // pose_ from the sensor
  void Drive(double v, double w);
  void Stop();
  void DriveToGoal();
  void DriveByHeading();

  DeviceContext context_;
  const sim::Robot& robot_;
  const sim::Sensor& sensor_;
  bool drives_;
  PublishRate rate_;
  std::vector<double> numbers_;  // scratch
  Pose2 frame_;                  // of the sensor's frame in that of the device
  Pose2 pose_;                   // in the device's frame
  bool power_ = true;
  bool commanded_ = false;         // by a client, since the first one came
  sim::Twist speed_;               // as last commanded
  std::optional<Pose2> goal_;      // POS
  sim::Twist goal_speed_;          // of POS: most of each; 0: the default
  bool near_goal_ = false;         // at the goal's place, turning
  std::optional<double> heading_;  // VEL_HEAD, rad
  double heading_speed_ = 0.0;     // VEL_HEAD, m/s
};

}  // namespace ccmorse::servers::player
