#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/pose.h"
#include "base/trig.h"
#include "navigation/drive.h"

namespace ccmorse::navigation {

/// Settings of Player's driver "vfh" (specs: player.md G.2), with its names. Where two say _0ms
/// and _1ms, they hold at 0 and at 1 m/s, and what is between is interpolated. `synchronous` is
/// the server's. The robot's radius, which Player asks the robot for, is one more.
struct VfhOptions {
  double robot_radius = 0.25;                      ///< m, > 0
  double cell_size = 0.1;                          ///< m, of the local grid, > 0
  int window_diameter = 61;                        ///< cells, odd, 3..1001
  double sector_angle = Radians(5.0);              ///< rad, > 0, at most 30 degrees
  double safety_dist_0ms = 0.1;                    ///< m around the robot, >= 0
  std::optional<double> safety_dist_1ms;           ///< m; safety_dist_0ms where unset
  double max_speed = 0.2;                          ///< m/s, > 0
  std::optional<double> max_speed_narrow_opening;  ///< m/s; max_speed where unset
  std::optional<double> max_speed_wide_opening;    ///< m/s; max_speed where unset
  double max_acceleration = 0.2;                   ///< m/s2, > 0
  double min_turnrate = Radians(10.0);             ///< rad/s, >= 0: slower turns are made as fast
  double max_turnrate_0ms = Radians(40.0);         ///< rad/s, > 0
  std::optional<double> max_turnrate_1ms;          ///< rad/s; max_turnrate_0ms where unset
  double min_turn_radius_safety_factor = 1.0;      ///< of the turning circles' radius, >= 0
  double free_space_cutoff_0ms = 2e6;              ///< a sector of less becomes free
  std::optional<double> free_space_cutoff_1ms;     ///< free_space_cutoff_0ms where unset
  std::optional<double> obs_cutoff_0ms;            ///< a sector of more is blocked; free_space_...
  std::optional<double> obs_cutoff_1ms;            ///< likewise
  double weight_desired_dir = 5.0;                 ///< of the way from the goal's direction, >= 0
  double weight_current_dir = 3.0;                 ///< of the way from the last direction, >= 0
  double distance_epsilon = 0.5;                   ///< m, > 0: the goal is reached this near
  double angle_epsilon = Radians(10.0);            ///< rad, > 0: likewise
  double escape_speed = 0.0;         ///< m/s when stalled, negative: backwards; 0: no escape
  double escape_time = 0.0;          ///< s, how long; 0: no escape
  double escape_max_turnrate = 0.0;  ///< rad/s meanwhile, now to one side, then to the other
};

/// Settings that suit the S1R of SyRoTek and its arena.
VfhOptions VfhOptionsForS1r();

/// Vector field histogram plus: goes to a goal among obstacles in a small grid around the robot
/// (I. Ulrich and J. Borenstein, "VFH+: reliable obstacle avoidance for fast mobile robots", ICRA
/// 1998; specs: player.md G.2). Obstacles beyond the goal do not count. Deterministic. Not thread
/// safe.
class Vfh {
 public:
  /// A direction that could be taken.
  struct Candidate {
    double angle = 0.0;   ///< rad, 0 straight ahead
    bool narrow = false;  ///< the middle of a narrow opening
  };

  /// Throws Error when a setting is out of its range.
  explicit Vfh(const VfhOptions& options);

  /// The next goal, m and rad. Throws Error when a number is not finite.
  void SetGoal(const Pose2& goal);
  void ClearGoal() { goal_.reset(); }
  const std::optional<Pose2>& goal() const { return goal_; }

  /// What to do now. `hits`: where laser or sonar met something, m in the robot's frame
  /// (HitPoints()). `stalled` means that every direction is blocked.
  Drive Step(const RobotState& state, std::span<const Vec2> hits);

  // What the last Step() saw, sector by sector; sector 0 is straight ahead, they count
  // counter-clockwise.
  const std::vector<double>& histogram() const { return histogram_; }  ///< magnitudes (n)
  const std::vector<bool>& blocked() const { return blocked_; }        ///< binary (n)
  const std::vector<bool>& masked() const { return masked_; }  ///< blocked or not to be turned to
  const std::vector<Candidate>& candidates() const { return candidates_; }

 private:
  void BuildHistograms(double speed, double goal_distance, std::span<const Vec2> hits);
  void FindCandidates(double target);
  std::size_t SectorOf(double angle) const;
  double MaxTurnRate(double speed) const;

  VfhOptions options_;
  int sectors_;
  std::vector<double> histogram_;
  std::vector<bool> blocked_;
  std::vector<bool> masked_;
  std::vector<bool> grid_;  // (window_diameter^2): occupied cells, row by row from -x, -y
  std::vector<Candidate> candidates_;
  std::optional<Pose2> goal_;
  bool reached_ = false;
  double spot_side_ = 0.0;      // to which it turns on the spot: 1 left, -1 right, 0 it does not
  double picked_ = 0.0;         // rad, the last direction taken
  double speed_ = 0.0;          // m/s, commanded last
  std::optional<double> time_;  // s, of the last step
  std::optional<double> escape_until_;
  double escape_side_ = 1.0;
};

}  // namespace ccmorse::navigation
