#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/pose.h"
#include "base/trig.h"
#include "navigation/occupancy_grid.h"

namespace ccmorse::navigation {

/// Settings of Player's driver "wavefront" (specs: player.md G.4), with its names. Its
/// cspace_file, force_map_refresh and update_rate belong to the server: nothing is kept in files
/// here, and who calls Step() sets the rate.
struct WavefrontOptions {
  double safety_dist = 0.25;      ///< m, >= 0: cells this near an obstacle, or nearer, are closed
  double max_radius = 1.0;        ///< m, > 0: farther from obstacles a path costs its length only
  double dist_penalty = 1.0;      ///< >= 0: how much dearer a path is at the safety distance
  double distance_epsilon = 0.5;  ///< m, > 0: a waypoint counts as reached this near
  double angle_epsilon = Radians(10.0);  ///< rad, > 0: likewise, of the heading
  double replan_dist_thresh = 2.0;       ///< m, >= 0: plans anew when this far from the path
  double replan_min_time = 2.0;          ///< s between plans; negative: never plans anew
  bool add_rotational_waypoints = true;  ///< turn on the spot towards the next waypoint first
};

/// Settings that suit the S1R of SyRoTek and its arena, for maps of 2 cm cells.
WavefrontOptions WavefrontOptionsForS1r();

/// Where the driver stands, what Player's planner interface tells.
struct WavefrontStatus {
  bool valid = false;             ///< there is a path to the goal
  bool done = false;              ///< the goal is reached
  bool planned = false;           ///< this step made a new plan
  int current = -1;               ///< the waypoint being gone to, -1: none
  std::optional<Pose2> waypoint;  ///< the same, m and rad: the goal for the position controller
};

/// A planner on a map: Dijkstra's costs from the goal over the cells with room, the cheapest path
/// from the robot, straight lines between its waypoints, and the waypoints one after another. Needs
/// something that goes to a position, Snd for instance. Deterministic. Not thread safe.
class Wavefront {
 public:
  static constexpr double kUnreachable = 1e300;  ///< cost of a cell from which no path leads

  /// Throws Error when a setting is out of its range. Unknown cells of the map are open, as in
  /// Player.
  Wavefront(OccupancyGrid map, const WavefrontOptions& options);

  const OccupancyGrid& map() const { return map_; }
  /// Distance of each cell from the nearest obstacle, m, at most max_radius (or a little more than
  /// safety_dist when that is larger).
  const std::vector<double>& obstacle_distances() const { return distances_; }
  /// Cost of the way from each cell to the goal of the last plan.
  const std::vector<double>& costs() const { return costs_; }
  bool IsOpen(CellIndex cell) const;
  /// Whether a path may go from a cell to that neighbour.
  bool CanStep(CellIndex from, CellIndex to) const;
  /// Cost of a step of `length` (m) that ends in `cell`: the length times 1 + dist_penalty times
  /// the closeness, which is 1 at safety_dist and 0 from max_radius on.
  double StepCost(CellIndex cell, double length) const;
  /// Does the straight line touch open cells only?
  bool IsLineOpen(Vec2 from, Vec2 to) const;

  /// The next goal, m and rad; the next Step() plans. Throws Error when a number is not finite.
  void SetGoal(const Pose2& goal);
  void ClearGoal();
  const std::optional<Pose2>& goal() const { return goal_; }

  /// Makes a path from `start` to the goal: false, and no waypoints, when there is none. A start in
  /// a closed cell first goes to the nearest open one; a goal in a closed cell cannot be reached.
  bool Plan(const Pose2& start);
  /// The cells of the last plan, from start to goal, neighbours all of them.
  const std::vector<CellIndex>& path() const { return path_; }
  /// The last plan in straight lines: the last waypoint is the goal, with its heading; others head
  /// for the next one.
  const std::vector<Pose2>& waypoints() const { return waypoints_; }

  /// Where to go now, given the robot's pose and the time, s, that never goes back.
  WavefrontStatus Step(const Pose2& pose, double time);

 private:
  void ComputeCosts(CellIndex goal);
  std::optional<CellIndex> NearestOpen(CellIndex from) const;
  double DistanceFromPath(Vec2 point) const;

  const OccupancyGrid map_;
  const WavefrontOptions options_;
  double reach_;  // m, up to which distances_ are exact
  std::vector<double> distances_;
  std::vector<double> costs_;
  std::optional<CellIndex> costs_of_;  // the goal cell that costs_ are for
  std::vector<CellIndex> path_;
  std::vector<Pose2> waypoints_;
  std::optional<Pose2> goal_;
  std::optional<double> planned_at_;  // s
  std::optional<Vec2> planned_from_;
  std::size_t current_ = 0;
  bool turning_ = false;  // on the spot, towards the next waypoint
  bool done_ = false;
};

}  // namespace ccmorse::navigation
