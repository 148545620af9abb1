#pragma once

#include "base/pose.h"

namespace ccmorse {

/// A rotation in space: where it takes the three axes.
struct Rotation {
  Vec3 x{1.0, 0.0, 0.0};
  Vec3 y{0.0, 1.0, 0.0};
  Vec3 z{0.0, 0.0, 1.0};
};

/// The rotation by Euler angles XYZ, rad, as MORSE has them (specs: morse.md H.3):
/// Rz(yaw) Ry(pitch) Rx(roll). A positive pitch turns x down. The same bits on every machine.
Rotation FromEuler(double roll, double pitch, double yaw);

/// Where the rotation takes `v`.
constexpr Vec3 Rotate(const Rotation& rotation, const Vec3& v) {
  return v.x * rotation.x + v.y * rotation.y + v.z * rotation.z;
}

/// What the rotation takes to `v`.
constexpr Vec3 RotateBack(const Rotation& rotation, const Vec3& v) {
  return {Dot(rotation.x, v), Dot(rotation.y, v), Dot(rotation.z, v)};
}

}  // namespace ccmorse
