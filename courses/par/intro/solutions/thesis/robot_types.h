#pragma once

namespace imr {
namespace robot {

/// Where the robot is, in the frame of the position sensor: x forward of the origin, y to the left,
/// yaw counter-clockwise from the x axis.
struct SPosition {
  double x;    ///< m
  double y;    ///< m
  double yaw;  ///< rad

  SPosition() : x(0.0), y(0.0), yaw(0.0) {}
  SPosition(double px, double py, double pyaw) : x(px), y(py), yaw(pyaw) {}
};

}  // namespace robot
}  // namespace imr
