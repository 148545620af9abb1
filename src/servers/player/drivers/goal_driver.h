#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/pose.h"
#include "navigation/drive.h"
#include "navigation/scan.h"
#include "servers/player/drivers/driver.h"

namespace ccmorse::servers::player {

/// What the drivers snd, vfh and nd have in common (specs: player.md G.1 to G.3): each provides a
/// position2d that takes goals; requires "input" position2d, where the robot is, "output"
/// position2d, which it drives (one without a key is both), and what the robot sees with. Its data
/// are the input's; speeds and all requests go to the output. A goal is in the input's frame; one
/// that is not finite is dropped. What the driver needs to know of where the scanner or the sonars
/// are on the robot it asks them.
class GoalDriver : public Driver {
 public:
  /// What a driver can see with.
  struct Eyes {
    bool sonar = false;          ///< a sonar, too, beside the laser or instead
    bool ranger = false;         ///< a ranger instead: a scanner of one element, or a ring
    bool exactly_one = false;    ///< not both
    double sonar_range = 0.0;    ///< m, > 0: longer ranges of a sonar are none
    std::size_t sonar_kept = 1;  ///< readings of the sonar that Hits() remembers, > 0
    std::vector<std::size_t> bad_sonars = {};  ///< of the ring, from 0, that do not count
  };
  /// For Eyes::sonar_range, m: a sonar's messages do not tell it, but ours reach so far.
  static constexpr double kSonarRange = 5.0;

  void Data(const DataMessage& message) override;

 protected:
  /// Throws Error when the file names something that the driver cannot work with. Its other
  /// functions may be called by the subclass's constructor from then on.
  GoalDriver(const DriverDef& def, const DeviceList& devices, Eyes eyes);

  // The algorithm. Each is called while there is a pose and a scan or a reading of the sonars.
  virtual void SetGoal(const Pose2& goal) = 0;  ///< finite, m and rad
  virtual void ClearGoal() = 0;
  virtual bool HasGoal() const = 0;
  virtual navigation::Drive Decide(const navigation::RobotState& state) = 0;

  /// The last scan; no ranges where the driver has no scanner.
  navigation::ScanView Scan() const;
  /// Where the scanner and the sonars met something, m in the robot's frame now.
  std::vector<Vec2> Hits() const;

  /// Option "robot_radius" (m), or where it is not given, half the diagonal of what the output says
  /// it is large: the smallest circle that the robot turns within.
  double RobotRadius(const DriverOptions& options);

  bool has_laser() const { return laser_ != nullptr; }

  bool Ask(Provided& device, std::uint8_t subtype, const wire::Body& body, Reply& reply) override;
  void Tell(Provided& device, std::uint8_t subtype, const wire::Body& body) override;
  void Started() override;
  void Stopped() override;

 private:
  bool Look(const DataMessage& message);
  void LookAround(std::span<const double> ranges, double range_max);
  void Drive(double speed, double turn_rate);

  const Eyes eyes_;
  Device& input_;
  Device& output_;
  Device* laser_ = nullptr;
  Device* sonar_ = nullptr;
  Device* ranger_ = nullptr;
  Provided* goals_ = nullptr;
  std::optional<navigation::RobotState> state_;  // as the input last told
  wire::LaserData scan_;
  Pose2 mount_;              // of the scanner
  std::vector<Pose2> ring_;  // where the sonars are
  wire::RangerConfig ranger_config_;
  std::vector<std::vector<Vec2>> heard_;  // of the last readings, m in the input's frame
};

}  // namespace ccmorse::servers::player
