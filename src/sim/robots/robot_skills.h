#pragma once

#include <vector>

#include "sim/service.h"

namespace ccmorse::sim {

class Robot;
class World;

/// The services of what a robot does itself, its scenario's `skills` (specs: morse.md B.4). Both
/// outlive them.
///
/// heal() of MORSE's Victim: it is injured no more, requires nothing, and its Severity is 0.
///
/// grasp(grab, obj_name) of MORSE's Human: with `grab` true the passive object that is so called
/// goes where the robot goes, from where it is; with false it stays where it is then. True where
/// that has changed anything. One at a time; the object has a true property Graspable, and, as the
/// body has no joints to reach out with, its origin is at most an arm's length, 1 m, from the
/// robot's on the plane. FAILED otherwise. `grab` may be the text "true" or "false", too.
std::vector<Service> RobotSkills(Robot& robot, World& world);

}  // namespace ccmorse::sim
