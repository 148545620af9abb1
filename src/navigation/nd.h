#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "base/pose.h"
#include "base/trig.h"
#include "navigation/drive.h"

namespace ccmorse::navigation {

/// Settings of Player's driver "nd" (specs: player.md G.3), with its names; tuples are two
/// numbers. sonar_buffer and sonar_bad_transducers are left to who turns sonar readings into
/// points. The robot's radius, which Player asks the robot for, is one more.
struct NdOptions {
  double robot_radius = 0.25;                    ///< m, > 0
  double goal_position_tol = 0.5;                ///< m, > 0 (goal_tol)
  double goal_angle_tol = Radians(10.0);         ///< rad, > 0 (goal_tol)
  double max_speed = 0.3;                        ///< m/s, > 0
  double max_turn_rate = Radians(45.0);          ///< rad/s, > 0 (max_speed)
  double min_speed = 0.05;                       ///< m/s, >= 0
  double min_turn_rate = Radians(10.0);          ///< rad/s, >= 0 (min_speed)
  double avoid_dist = 0.5;                       ///< m around the robot, > 0: the security zone
  double safety_dist = 0.0;                      ///< m, >= 0: added to the radius
  double rotate_stuck_time = 2.0;                ///< s of turning without getting on, > 0
  double translate_stuck_time = 2.0;             ///< s of driving without getting on, > 0
  double translate_stuck_dist = 0.25;            ///< m: getting on means so far
  double translate_stuck_angle = Radians(20.0);  ///< rad: or turned so far
  bool wait_on_stall = false;                    ///< stand while the robot is stalled
  int laser_buffer = 10;  ///< 1..1000: steps whose hits are remembered, this one included
};

/// Settings that suit the S1R of SyRoTek and its arena.
NdOptions NdOptionsForS1r();

/// The five situations of nearness diagram navigation, and one for a goal that is in reach.
enum class NdSituation {
  kNone,              ///< no goal, at the goal, or no way
  kLowSafety1,        ///< LS1: obstacles in the security zone on one side of the way
  kLowSafety2,        ///< LS2: on both sides
  kHighSafetyGoal,    ///< HSGR: nothing in the zone, the goal is in the free region
  kHighSafetyWide,    ///< HSWR: the free region is wide
  kHighSafetyNarrow,  ///< HSNR: it is narrow
};

/// Nearness diagram navigation: goes to a goal among obstacles by telling five situations apart (J.
/// Minguez and L. Montano, "Nearness diagram (ND) navigation: collision avoidance in troublesome
/// scenarios", IEEE Trans. Robotics and Automation 20(1), 2004; specs: player.md G.3).
/// Deterministic. Not thread safe.
class Nd {
 public:
  static constexpr int kSectors = 144;  ///< of 2.5 degrees; sector 72 is straight ahead

  /// Throws Error when a setting is out of its range.
  explicit Nd(const NdOptions& options);

  /// The next goal, m and rad. Throws Error when a number is not finite.
  void SetGoal(const Pose2& goal);
  void ClearGoal() { goal_.reset(); }
  const std::optional<Pose2>& goal() const { return goal_; }

  /// What to do now. `hits`: where laser or sonar met something, m in the robot's frame
  /// (HitPoints()). `stalled`: the robot is not getting on, or there is no way; it stands then
  /// until the next goal, when it is stuck, or until there is a way.
  Drive Step(const RobotState& state, std::span<const Vec2> hits);

  /// Of the last step.
  NdSituation situation() const { return situation_; }
  /// Of the last step: the direction of motion, rad, 0 straight ahead.
  double direction() const { return direction_; }
  /// Of the last step: distance of the nearest obstacle in each sector, m, kFree for none.
  const std::vector<double>& distances() const { return distances_; }
  static constexpr double kFree = 1e9;

 private:
  // Free space beside a corner.
  struct Region {
    int edge = 0;         // its sector next to the corner
    int side = 0;         // where it is from there: 1 counter-clockwise, -1 clockwise
    double corner = 0.0;  // m, distance of the corner
    int count = 0;        // sectors
  };
  std::optional<Region> ChooseRegion(double target, double last) const;
  bool IsWayClear(double angle, double length) const;
  bool IsStuck(const RobotState& state, const Drive& drive);

  const NdOptions options_;
  std::optional<Pose2> goal_;
  bool reached_ = false;
  bool stuck_ = false;
  NdSituation situation_ = NdSituation::kNone;
  double direction_ = 0.0;
  std::optional<double> going_;         // rad, in the frame of poses: where to before deflection
  std::deque<std::vector<Vec2>> seen_;  // hits of the last steps, m in the frame of poses
  std::vector<double> distances_;       // (kSectors)
  std::vector<Vec2> points_;            // of the nearest obstacles in the sectors
  // Where and when it last got on.
  std::optional<double> moved_time_;
  Pose2 moved_pose_;
  std::optional<double> turning_since_;
  double turning_left_ = 0.0;  // rad still to turn, at least of what has been since
};

}  // namespace ccmorse::navigation
