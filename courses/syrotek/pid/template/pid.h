#pragma once

/// The controller: what pid.cc is to write. One object a drive, called for each scan.
class CPid {
 public:
  /// The turn rate, rad/s counter-clockwise, that brings the robot back to its line.
  /// @param error How far the line is to the left of the robot, m.
  /// @param dt    Seconds since the call before; 0 at the first.
  double control(double error, double dt);

 private:
  double sum = 0.0;   // of the error over time, m s
  double last = 0.0;  // the error of the call before, m
};
