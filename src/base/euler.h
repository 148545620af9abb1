#pragma once

#include "base/pose.h"
#include "base/rotation.h"

namespace ccmorse {

/// The Euler angles XYZ of a rotation, rad (specs: morse.md H.3): x roll and z yaw in (-pi, pi], y
/// pitch in [-pi/2, pi/2]; FromEuler() gives the rotation again. Straight up or down only their
/// sum or difference is known, and roll is 0. The same bits on every machine.
Vec3 ToEuler(const Rotation& rotation);

/// First `inner`, then `outer`.
Rotation Combined(const Rotation& outer, const Rotation& inner);

}  // namespace ccmorse
