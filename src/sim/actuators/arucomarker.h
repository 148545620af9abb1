#pragma once

#include <string>

#include "sim/component.h"

namespace ccmorse::sim {

/// MORSE's Arucomarker (specs: morse.md B.3): moves a marker, which is seen nowhere yet. Data and
/// stream: x, y, z, m, and roll, pitch, yaw, rad, as a camera would say them: the marker is (z +
/// xoffset, x + yoffset, -y + zoffset) from the robot's origin, along the world's axes, and turned
/// in the order Y, Z, X. Services get_world_position() and get_local_position(), m, a list, and
/// get_world_orientation() and get_local_orientation(), a matrix in rows; local is in the robot's
/// frame.
class Arucomarker : public Actuator {
 public:
  Arucomarker(Robot& robot, const std::string& name);
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // nothing depends on it
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;
  Vec3 WorldPosition() const;
  Rotation WorldRotation() const;

  double x_offset_ = 0.0;  // xoffset, m
  double y_offset_ = 0.0;  // yoffset, m
  double z_offset_ = 0.0;  // zoffset, m
  Vec3 position_;          // as told
  Vec3 euler_;             // roll, pitch, yaw, as told
};

}  // namespace ccmorse::sim
