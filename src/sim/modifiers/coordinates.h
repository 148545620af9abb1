#pragma once

#include <memory>
#include <string>

#include "scene/scenario.h"
#include "sim/modifiers/modifier.h"

namespace ccmorse::sim {

/// Says places in other coordinates (specs: morse.md B.5): x, y and z become
///   NED         north, east, down: x and y change places, z its sign; where there is no x, but
///               yaw, pitch and roll: roll' = pi/2 - yaw, pitch' = -pitch, yaw' = roll
///   ECEF        m from the Earth's centre
///   geodetic    longitude and latitude, degrees, altitude, m
///   geocentric  longitude and geocentric latitude, degrees, m from the Earth's centre
///   UTM         m with x_offset, y_offset and z_offset added
///   feet        feet
/// and of messages to an actuator they are such and become the world's. Returns nullptr for types
/// that are none of these. Throws as MakeModifier().
std::unique_ptr<Modifier> MakeCoordinateModifier(const Component& component,
                                                 const scene::ModifierDef& def,
                                                 const scene::Scenario& scenario);

}  // namespace ccmorse::sim
