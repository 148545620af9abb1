#pragma once

#include "base/pose.h"
#include "base/trig.h"
#include "sim/component.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

/// Where the robot has come since the start, as its wheels tell it: MORSE's IntegratedOdometry
/// (specs: morse.md B.2). Pose in the frame of the robot's pose at the start, m and rad; speeds in
/// the robot's own frame, m/s and rad/s, with the sign and frame that MORSE's later versions have
/// (1.4 had both wrong). `stall` is ours: whether the robot's last motion was blocked. 60 Hz.
/// The scenario may let it begin elsewhere and count with gain errors, which each run draws anew by
/// its seed (specs: player.md C.3, odom_error); it then sums up what the robot moves from sample to
/// sample, and its speeds have the same errors.
class OdometrySensor : public Sensor {
 public:
  OdometrySensor(Robot& robot, const std::string& name, std::uint64_t seed);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;
  NumberForm number_form() const override { return NumberForm::kOdometry; }
  void AppendNumbers(std::vector<double>& out) const override;

 private:
  void AppendFields(std::string& out) const override;

  void DeadReckon();

  bool exact_;              // no gain errors
  Vec3 gain_;               // of what it counts forward, sideways and in turning
  Pose2 last_;              // in the world, at the last sample
  Pose2 start_;             // in the world
  SinCosPair start_angle_;  // of its yaw
  Pose2 moved_;             // in the frame of start_
  Pose2 shown_;             // the same, as modifiers have made it
  Vec3 rest_;               // z, m, and pitch and roll, rad: 0 but for modifiers
  Twist twist_;
  bool stalled_ = false;
};

}  // namespace ccmorse::sim
