#pragma once

#include <memory>

#include "imr-h/robot_program.h"

/// Makes the robot's behaviour: what behaviour.cc is to write.
std::unique_ptr<imr::CBehaviour> makeBehaviour();
