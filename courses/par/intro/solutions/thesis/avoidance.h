#pragma once

#include <algorithm>

/// The robot's behaviour as pure functions: what it does about the nearest obstacle on each side.
/// They know neither the robot nor the simulator, so a table of numbers can check them. This is the
/// part that a student changes first.

namespace imr {
namespace robot {

// Constants of the behaviour (thesis C.2 l.121-123).
constexpr double VMAX = 0.3;               ///< Fastest forward speed [m/s].
constexpr double WMAX = 1.0;               ///< Turn rate in front of an obstacle [rad/s].
constexpr double RNG_ANGL_REACTION = 0.5;  ///< Share of the range in the turn; the rest: bearing.
constexpr double HALF_FOV = 40 * (3.14159265359 / 180);  ///< Half the angle watched [rad].
constexpr double MIN_OBSTACLE_RANGE = 0.20;              ///< As near as this: turn on the spot [m].
constexpr double SAFE_OBSTACLE_RANGE = 0.50;  ///< Farther than this: full speed ahead [m].

/// The beams of a scan that the robot looks at, as indexes into the scan. The starting values are
/// the thesis's for the S1R's 682 beams (C.2 l.125-127), in force until a scan has been seen.
///
/// The thesis calls the low indexes left. In Player's order, which CCMorse keeps, beam 0 is the
/// right-most one; the signs of the turn below are right for Player's order.
struct SBeamWindow {
  unsigned centerToEdge = 340;  ///< Beams from the centre to either edge.
  unsigned left = 0;            ///< First beam looked at.
  unsigned center = 340;        ///< Straight ahead. Never looked at itself: the halves exclude it.
  unsigned right = 681;         ///< Last beam looked at.
};

/// The beams within HALF_FOV on either side of the middle (thesis C.2 l.193-198), which works for a
/// laser of any size. A scan narrower than that is used whole.
///
/// @param count   Beams in the scan.
/// @param scanRes Angle between two beams [rad], more than 0.
inline SBeamWindow beamWindow(unsigned count, double scanRes) {
  SBeamWindow window;
  window.center = count / 2;
  window.centerToEdge = window.center;
  const double beams = HALF_FOV / scanRes;
  if (beams < window.center) window.centerToEdge = static_cast<unsigned>(beams);
  window.left = window.center - window.centerToEdge;
  window.right = count == 0 ? 0 : std::min(window.center + window.centerToEdge, count - 1);
  return window;
}

/// The nearest obstacle in one half of the scan.
struct SNearest {
  double range;    ///< m; the laser's maximal range if there is none
  double bearing;  ///< rad, counter-clockwise from straight ahead
};

/// What the motors are told.
struct SVelocity {
  double v;  ///< Forward [m/s].
  double w;  ///< Turn rate, counter-clockwise [rad/s].
};

/// The velocity law (thesis C.2 l.231-264), like a Braitenberg vehicle: the nearer of the two
/// obstacles slows the wheel on the other side.
///
///   range > SAFE_OBSTACLE_RANGE    straight ahead at full speed
///   range > MIN_OBSTACLE_RANGE     the nearer, the slower; turning away from the obstacle
///   else                           turning left on the spot
///
/// Two properties of the thesis's formula are kept on purpose. The bearing's part of the turn,
/// 2 HALF_FOV - bearing / HALF_FOV * 2, is not symmetric: strong for obstacles at negative bearings
/// (right of the robot) and weak at positive ones, where it crosses zero at 0.487 rad, so that the
/// robot turns towards an obstacle 0.5 m away if its bearing is between 0.627 rad and the edge of
/// the window. And the turn is not limited to WMAX: it reaches 2.2 rad/s, and the robot's own limit
/// decides what becomes of it. This is why the robot ends up driving in circles.
///
/// @param left,right The nearest obstacles among the low and the high indexes (see SBeamWindow). At
///                   equal ranges the right one counts.
inline SVelocity avoid(const SNearest& left, const SNearest& right) {
  const bool isLeft = left.range < right.range;
  const double range = isLeft ? left.range : right.range;
  const double angle = isLeft ? left.bearing : right.bearing;
  const int direction = isLeft ? 1 : -1;

  if (range > SAFE_OBSTACLE_RANGE) return SVelocity{VMAX, 0.0};
  if (range <= MIN_OBSTACLE_RANGE) return SVelocity{0.0, WMAX};
  const double v = (range - MIN_OBSTACLE_RANGE) / (SAFE_OBSTACLE_RANGE - MIN_OBSTACLE_RANGE) * VMAX;
  const double byRange = RNG_ANGL_REACTION * (MIN_OBSTACLE_RANGE / range);
  const double byBearing = (1 - RNG_ANGL_REACTION) * (HALF_FOV * 2 - angle / HALF_FOV * 2);
  return SVelocity{v, (byRange + byBearing) * WMAX * direction};
}

}  // namespace robot
}  // namespace imr
