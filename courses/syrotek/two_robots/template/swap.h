#pragma once

#include <memory>

#include "imr-h/robot_program.h"

/// What behaviour.cc is to write: a robot that goes to `goal` and keeps clear of all that its laser
/// sees, the other robot, too. Both robots run the same program, and do not talk to each other.
std::unique_ptr<imr::CBehaviour> makeBehaviour(imr::SPoint goal);
