#pragma once

#include <span>
#include <vector>

#include "base/pose.h"

namespace ccmorse::sim {

/// Where a unicycle at `start` is after `seconds` at constant speed v (m/s, along its x) and turn
/// rate w (rad/s): the exact arc, not an Euler step. Yaw comes back in (-pi, pi]. An
/// omnidirectional robot has a speed to its left besides, `side` (m/s).
Pose2 DriveArc(const Pose2& start, double v, double w, double seconds, double side = 0.0);

/// A convex thing that stands in the way, with a circle around it to rule it out quickly.
struct Obstacle {
  std::vector<Vec2> outline;  ///< m, world frame, counter-clockwise
  Vec2 centre;                ///< m
  double radius = 0.0;        ///< m
  int box_id = 0;             ///< of the scene's box or mesh, 0 for a robot

  static Obstacle Make(std::vector<Vec2> outline, int box_id);
  /// Moves the outline of a footprint to `pose`, in the memory it has.
  void MoveTo(const struct Footprint& footprint, const Pose2& pose);
};

/// A footprint that moves: corners in its own frame and its circumscribed radius.
struct Footprint {
  std::vector<Vec2> outline;  ///< m, robot's frame, convex, counter-clockwise
  double radius = 0.0;        ///< m, around the robot's origin

  /// Throws Error when there are more than 16 corners.
  static Footprint Make(std::vector<Vec2> outline);
  std::vector<Vec2> At(const Pose2& pose) const;
};

/// What became of one tick's motion.
struct MotionResult {
  Pose2 pose;            ///< where the robot now is
  bool blocked = false;  ///< it met an obstacle and stands just before it
  double driven = 0.0;   ///< m, length of the path of its origin
};

/// Drives the arc as far as nothing is touched: the footprint never overlaps an obstacle, and a
/// blocked robot stands less than 1e-5 m of path before contact. Obstacles are checked every 5 mm
/// of the fastest point's path, so nothing of 1 cm or more is jumped over at any speed. `side`: as
/// for DriveArc.
MotionResult DriveUntilContact(const Footprint& footprint, const Pose2& start, double v, double w,
                               double seconds, std::span<const Obstacle* const> obstacles,
                               double side = 0.0);

/// Does the footprint at `pose` overlap any of the obstacles?
bool Collides(const Footprint& footprint, const Pose2& pose,
              std::span<const Obstacle* const> obstacles);

}  // namespace ccmorse::sim
