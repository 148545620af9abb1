#pragma once

#include <optional>
#include <vector>

#include "base/pose.h"
#include "base/trig.h"
#include "navigation/drive.h"
#include "navigation/scan.h"

namespace ccmorse::navigation {

/// Settings of Player's driver "snd" (specs: player.md G.1), with its names. The two defaults that
/// its code has wrong, bare numbers of degrees taken as radians, are what its manual says.
struct SndOptions {
  double robot_radius = 0.25;                 ///< m, of the smallest circle around the robot, > 0
  std::optional<double> min_gap_width;        ///< m, smallest passage; 2 robot_radius where unset
  std::optional<double> obstacle_avoid_dist;  ///< m, obstacles nearer than this beyond the radius
                                              ///< slow and deflect; 4 robot_radius where unset
  double max_speed = 0.5;                     ///< m/s, > 0
  double max_turn_rate = Radians(60.0);       ///< rad/s, > 0
  std::optional<double> goal_position_tol;    ///< m, > 0; robot_radius / 2 where unset
  double goal_angle_tol = Radians(30.0);      ///< rad, > 0
  double min_range = 0.0;  ///< m, shorter ranges are none; CTU's variant of SND has 0.02
};

/// Settings that suit the S1R of SyRoTek and its arena. The radius is the robot's own, so that it
/// can always turn on the spot; with SyRoTek's published avoidance distance of 0.09 to 0.11 m
/// (specs: syrotek.md A) it would be slow between the arena's pillars, so this is shorter. A goal
/// should be at least robot_radius + goal_position_tol away from obstacles: the robot goes no
/// nearer than its radius, where the algorithm stands still.
SndOptions SndOptionsForS1r();

/// What a scan says, sector by sector (step 1 and 3 of player.md G.1). A sector is as wide as a
/// beam; sector n/2 is straight ahead, sector 0 behind, and they count counter-clockwise.
struct NearnessDiagram {
  double resolution = 0.0;       ///< rad, width of a sector
  double range_max = 0.0;        ///< m
  int count = 0;                 ///< n, sectors of the full circle
  int beams = 0;                 ///< of the scan, at most n
  int first = 0;                 ///< sector of its right-most beam
  std::vector<double> distance;  ///< m (n): L, range_max where nothing is known
  std::vector<double> nearness;  ///< m (n): PND, 0 where nothing is in range
  std::vector<Vec2> points;      ///< m (n): where `distance` ends, in the robot's frame
  double nearest = 0.0;          ///< m, dmin
  double safety = 0.0;           ///< m, Ds: the safety distance now, 0..obstacle_avoid_dist

  int ahead() const { return count / 2; }
  bool full_circle() const { return beams >= count; }
  /// The sector modulo n.
  int Wrap(int sector) const { return ((sector % count) + count) % count; }
  /// Shortest way from one sector to another, in sectors, positive counter-clockwise.
  int Between(int from, int to) const;
};

/// An edge of free space: a jump of nearness between two neighbouring sectors (step 4).
struct SndGap {
  int sector = 0;
  int direction = 0;      ///< +1: left edge of the free space, -1: right edge
  double distance = 0.0;  ///< m, of the obstacle's corner
  bool operator==(const SndGap&) const = default;
};

/// Free space between two gaps (step 5).
struct SndValley {
  int right = 0;      ///< sector of the right end
  int left = 0;       ///< sector of the left end, counter-clockwise of `right`, maybe past sector 0
  SndGap rising;      ///< the edge to go by
  int direction = 0;  ///< from that edge into the valley: +1 counter-clockwise, -1 clockwise
};

// The steps of the algorithm, one by one. Each takes the settings with all that was unset filled
// in, which Snd::Resolved() does.
NearnessDiagram MakeNearnessDiagram(const ScanView& scan, const SndOptions& options);
std::vector<SndGap> FindGaps(const NearnessDiagram& diagram, const SndOptions& options);
/// Is there room beside the gap's corner, on the side of the valley?
bool IsSafeGap(const NearnessDiagram& diagram, const SndGap& gap, const SndOptions& options);
std::vector<SndValley> FindValleys(const NearnessDiagram& diagram, const std::vector<SndGap>& gaps,
                                   int goal_sector, const SndOptions& options);
/// The valley to take (step 6), nothing when there is none.
std::optional<SndValley> ChooseValley(const NearnessDiagram& diagram,
                                      const std::vector<SndValley>& valleys, int goal_sector);
/// Is the way of the robot's width clear in the sector's direction, for the way to the goal
/// `goal_distance` m away?
bool IsCorridorClear(const NearnessDiagram& diagram, int sector, double goal_distance,
                     const SndOptions& options);
/// The sector to go to before deflection (step 7).
int TargetSector(const NearnessDiagram& diagram, const std::optional<SndValley>& valley,
                 int goal_sector, double goal_distance, const SndOptions& options);
/// By how many sectors obstacles within the safety distance turn the robot away (step 8); 0 when
/// the safety distance is.
double Deflection(const NearnessDiagram& diagram, int target, double robot_radius);
/// Speeds for going `angle` rad to the left of straight ahead (step 9).
Drive SndSpeeds(double angle, double goal_distance, double nearest, const SndOptions& options);

/// Smooth nearness diagram navigation: goes to a goal among obstacles that it sees in a scan and
/// keeps no map (J. W. Durham and F. Bullo, "Smooth nearness-diagram navigation", IROS 2008;
/// specs: player.md G.1). Made for a round robot with two wheels and a scanner in its middle; a
/// scanner mounted elsewhere is put right by CentreScan(). Deterministic: the same calls give the
/// same bytes. Not thread safe.
class Snd {
 public:
  /// Throws Error when a setting is not a positive number.
  explicit Snd(const SndOptions& options);

  /// The settings with what was unset filled in. Throws as the constructor.
  static SndOptions Resolved(SndOptions options);
  const SndOptions& options() const { return options_; }

  /// The next goal, m and rad, in the frame that Step() gets poses in. From 1000 m on only its
  /// heading counts: the robot keeps going that way. Throws Error when a number is not finite.
  void SetGoal(const Pose2& goal);
  void ClearGoal() { goal_.reset(); }
  const std::optional<Pose2>& goal() const { return goal_; }

  /// What to do now, to be called for each scan. Stands still without a goal or a scan, and at the
  /// goal. It is `stalled` when something is inside the robot's radius: by the algorithm it waits
  /// then.
  Drive Step(const Pose2& pose, const ScanView& scan);

 private:
  const SndOptions options_;
  std::optional<Pose2> goal_;
  bool reached_ = false;
};

}  // namespace ccmorse::navigation
